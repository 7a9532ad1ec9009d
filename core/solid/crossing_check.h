// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/solid.
#pragma once

#include "core/base/result.h"
#include "core/solid/exact_geometry.h"
#include "core/solid/operand.h"

namespace ew {

/// No two faces cross or touch but in the edges and corners that they share: every edge is tried
/// against every face that it does not belong to, in exact arithmetic. That finds all contacts,
/// since where two polygons meet, a side of one meets the other.
///
/// \param planes  all of them, exact.
/// \param within  contacts can be in this box only; null for anywhere.
/// \pre loops are checked (checkLoops) and every face by itself is sound (triangulateFace). Error:
///     SelfIntersecting; the message names the faces. O(n log n) for small faces.
Result<void> checkCrossings(const ExactBrep& brep, const FacePlanes& planes, const Box3* within);

}  // namespace ew
