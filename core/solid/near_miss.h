// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/solid.
#pragma once

#include "core/solid/mesh_kernel.h"
#include "core/solid/operand.h"

namespace ew {

/// Where parts of a closed surface that are no neighbours come nearer to each other than `reach`
/// without touching: a thin web between two cuts, a slit, a step too low to see, a side too short.
/// That is so where a corner all but lies in a face that it does not belong to, or two sides
/// without a common corner all but meet.
/// \param points  rounded [mm].
/// \param within  only what comes near in this box.
/// \return a point of each such place [mm]; empty in nearly all cases. O(n log n) for small faces.
std::vector<Vec3> nearMisses(const std::vector<Vec3>& points, const std::vector<FaceLoops>& faces,
                             const Box3& within, double reach);

}  // namespace ew
