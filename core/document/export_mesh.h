// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/solid/solid.h"

namespace ew {

/// Writes solids as a mesh file in world coordinates [mm]; the format follows the extension, in any
/// case of letters:
///   .obj  one object a body, the planar faces as polygons, 17 significant digits
///   .stl  binary, triangles with unit normals, single precision as the format has it
///   .ply  binary little endian, double precision, the planar faces as polygons
/// A face with holes becomes several polygons without holes, as few as joining its triangles gives.
/// The file appears whole or not at all: it is written beside its place and then moved there.
/// \param path  UTF-8.
/// Errors: NoSolid where there are no bodies, UnknownExtension, CannotWrite, BadValue for a pose
/// that is not finite or puts a coordinate beyond what the format holds.
Result<void> exportBodies(const std::vector<Body>& bodies, const std::string& path);

/// The faces of a solid as simple polygons without holes: vertex indices, counter-clockwise from
/// outside. A face without holes is one polygon, its outer loop.
std::vector<std::vector<int>> facePolygons(const Solid& solid);

}  // namespace ew
