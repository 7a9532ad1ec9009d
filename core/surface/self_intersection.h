// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "core/base/vec.h"

namespace ew {

/// Pairs of triangles that meet in more than the corners that they share. Errs to the safe side:
/// triangles that touch within rounding (tol::kApartRelative of the size) are reported.
/// \pre the triangles are oriented, and those round a point are one closed fan.
/// \param group  triangles of one non-negative group are known to be free of each other.
/// \param limit  stops after so many pairs.
/// O(n log n) for surfaces.
std::vector<std::pair<int, int>> selfIntersections(const std::vector<Vec3>& points,
                                                   const std::vector<std::array<int, 3>>& triangles,
                                                   const std::vector<int>& group,
                                                   std::size_t limit);

/// The same question for two triangles, answered exactly for the coordinates as they are.
bool meetExactly(const std::vector<Vec3>& points, const std::array<int, 3>& s,
                 const std::array<int, 3>& t);

}  // namespace ew
