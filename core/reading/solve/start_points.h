// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/reading/evidence/sighting.h"

namespace ew {

/// Starting points: the reference shape seen along each representative direction of the aspect,
/// turned and scaled onto the drawing; the best fitting first.
std::vector<CameraPoints> startPoints(const Template& tmpl, const Sighting& sighting,
                                      const Aspect& aspect, bool mirrored);

}  // namespace ew
