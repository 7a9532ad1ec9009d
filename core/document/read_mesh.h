// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/solid/polyhedron_spec.h"

namespace ew {

/// Points and polygons of an OBJ file, or of a PLY file (text or little endian); normals, colours
/// and the like are passed over. What the mesh is worth shapeOfMesh() tells.
/// \param source  name for messages. Errors: WrongFormat for another kind of file, Syntax with the
/// line, TooLarge beyond kMaxMeshPoints of core/tlib/mesh_shape.h.
Result<PolyhedronSpec> readMesh(const std::string& bytes, const std::string& source);

}  // namespace ew
