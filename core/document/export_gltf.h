// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/vec.h"

namespace ew {

/// One body's triangles for export; what it points to must outlive the call.
struct TriangleMeshView {
    std::string name;                                     ///< UTF-8
    std::span<const Vec3> positions;                      ///< world [mm]
    std::span<const std::array<int, 3>> triangles;        ///< counter-clockwise from outside
    std::span<const Vec3> normals;                        ///< unit; empty: flat shading
    std::span<const std::array<int, 3>> normalTriangles;  ///< normals by triangle; empty where
                                                          ///< normal i belongs to position i
    std::array<double, 3> color{0.72, 0.74, 0.78};        ///< linear, 0..1
};

/// A polyline for export, e.g. a stroke on the surface.
struct PolylineView {
    std::span<const Vec3> points;  ///< world [mm], n >= 2
    std::array<double, 3> color{0.05, 0.05, 0.06};
};

/// The bytes of a glTF 2.0 binary file (.glb): a node and mesh for each body, lines as one mesh of
/// line strips, under a root node that turns z up, mm into the format's y up, metres. Points with
/// several normals are repeated, one for each; bodies without normals get flat ones.
/// \param origin  of these coordinates in the world [mm]: the root node puts it back. A body that
///                lies far from there by its own size gets a translation of its own as well.
/// Errors: NoSolid where there is no triangle, BadValue for numbers that are not finite or do not
/// fit single precision, indices out of range, or a file over 4 GiB, which the format cannot hold.
Result<std::string> gltfBytes(std::span<const TriangleMeshView> bodies,
                              std::span<const PolylineView> lines = {},
                              const Vec3& origin = Vec3::Zero());

/// Checks what both mesh formats need: NoSolid, BadValue as above.
Result<void> checkMeshes(std::span<const TriangleMeshView> bodies);

}  // namespace ew
