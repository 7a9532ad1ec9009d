// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/derived_shape.h"
#include "core/document/polygons.h"
#include "core/solid/solid.h"

namespace ew {

/// What a mesh file is written from. The outermost shape of every body is written: its surface,
/// else its filleted cage, else the solid.
struct MeshSource {
    const std::vector<Body>& bodies;
    const DerivedShape& shape;                ///< of these bodies
    const std::vector<MappedStroke>& mapped;  ///< those that shape.curves speak of
};

/// Writes a mesh file in world coordinates [mm]; the format follows the extension, in any case of
/// letters:
///   .obj  one object a body, planar faces as polygons, 17 significant digits; a surface as
///         triangles with its normals; mapped strokes as lines, one object a stroke
///   .stl  binary, triangles with unit normals, single precision as the format has it
///   .ply  binary little endian, double precision, planar faces as polygons
///   .glb  glTF 2.0 binary: triangles, smooth normals where there is a surface, mapped strokes
///   .3mf  3MF core: triangles, mm
/// A face with holes becomes several polygons without holes, as few as joining its triangles gives.
/// The file appears whole or not at all: it is written beside its place and then moved there.
/// \param path  UTF-8.
/// Errors: NoSolid where there are no bodies, UnknownExtension, CannotWrite, BadValue for a pose
/// that is not finite or puts a coordinate beyond what the format holds, NotClosed where readers of
/// .stl, .glb and .3mf, which have single precision, would find the shape open or without area,
/// shape.problem where the shape could not be made.
Result<void> exportShape(const MeshSource& source, const std::string& path);

/// The same for solids alone.
Result<void> exportBodies(const std::vector<Body>& bodies, const std::string& path);

}  // namespace ew
