// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/reading/solve/general_fit.h"

namespace ew {

/// A start for solveAnchored: least squares over what is linear, which is nearly everything:
/// anchors, directions, drawn places, and opposite sides of quadrangles being alike.
CameraPoints anchoredStart(const Template& tmpl, const TemplateAnalysis& analysis,
                           const Sighting& sighting, const Anchors& anchors);

}  // namespace ew
