// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/reading/propose/placement.h"
#include "core/solid/boolean.h"

namespace ew {

/// Cracking: faces of the solid that a change meets although the drawing does not lie
/// in them, ascending.
/// \paper{5.2.3}
std::vector<int> crackedFaces(const Solid& target, const BooleanReport& report,
                              const Placement& placement);

}  // namespace ew
