// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/derived_shape.h"
#include "core/document/export_options.h"
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

/// Writes a mesh file in world coordinates; the format follows the extension, in any case of
/// letters:
///   .obj  one object a body, 17 significant digits; a surface as triangles with its normals;
///         mapped strokes as lines, one object a stroke
///   .stl  binary, triangles with unit normals, single precision as the format has it
///   .ply  binary little endian, double precision
///   .glb  glTF 2.0 binary: triangles, smooth normals where there is a surface, mapped strokes
///   .3mf  3MF core: triangles, mm
/// As polygons, a face with holes becomes several without holes, as few as joining its triangles
/// gives. All but .obj are read in single precision, so far from the world's origin they get one of
/// their own (fileOrigin): .glb and .3mf say so in the nodes and build items that put it back; .stl
/// (in its header) and .ply (in a comment) say "origin at X Y Z", and the returned note says it
/// too. The file appears whole or not at all.
/// \param path  UTF-8.
/// \return a sentence for the person, or nothing.
/// Errors: NoSolid where there are no bodies, UnknownExtension, CannotWrite, BadValue for a pose
/// that is not finite or coordinates that the format cannot hold closely enough, NotClosed where
/// readers of .stl, .glb and .3mf, which have single precision, would find the shape open or
/// without area, BadValue also for a body that is not there, Cancelled where
/// ExportOptions::progress says so, shape.problem where the shape could not be made.
Result<std::string> exportShape(const MeshSource& source, const std::string& path,
                                const ExportOptions& options = {});

/// The same for solids alone.
Result<std::string> exportBodies(const std::vector<Body>& bodies, const std::string& path,
                                 const ExportOptions& options = {});

}  // namespace ew
