// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface.
#pragma once

#include <span>
#include <vector>

#include "core/base/vec.h"

namespace ew {

/// Splits a planar polygon, with holes or not convex, into convex quadrangles and triangles over
/// its own corners: the triangles of a constrained Delaunay triangulation, joined in pairs, those
/// first that make the squarest quadrangles.
/// \param loops  indices into points, [0] the outline.
/// \return empty where the polygon is not simple.
std::vector<std::vector<int>> splitFace(const std::vector<Vec3>& points,
                                        std::span<const std::span<const int>> loops);

/// All corners turn the way of the loop's normal or go straight on.
bool isConvex(const std::vector<Vec3>& points, std::span<const int> loop);

}  // namespace ew
