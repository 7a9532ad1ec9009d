// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/solid/solid.h"

namespace ew {

/// The faces of a solid as simple polygons without holes: vertex indices, counter-clockwise from
/// outside. A face without holes is one polygon, its outer loop.
std::vector<std::vector<int>> facePolygons(const Solid& solid);

/// Joins pieces (triangles) of one face along their common edges into few simple polygons.
std::vector<std::vector<int>> joinTriangles(std::vector<std::vector<int>> pieces);

}  // namespace ew
