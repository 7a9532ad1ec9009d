// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "core/base/result.h"
#include "core/surface/control_cage.h"

namespace ew {

inline constexpr int kMaxSubdivisionLevels = 6;

/// Triangles on the limit surface: closed, oriented, no T vertices.
struct SurfaceMesh {
    std::vector<Vec3> positions;                ///< [mm]
    std::vector<std::array<int, 3>> triangles;  ///< positions, counter-clockwise from outside
    std::vector<Eigen::Vector3f> normals;       ///< unit limit normals, outward; a normal needs
                                                ///< no more digits, and there are many
    std::vector<std::array<int, 3>> normalTriangles;  ///< normals, by triangle; empty where normal
                                                      ///< i belongs to position i (no sharp crease)
    std::vector<int> origin;                          ///< by triangle: face of the control cage

    /// The normal at a corner (0..2) of a triangle.
    Vec3 normal(std::size_t triangle, std::size_t corner) const {
        const auto& n = normalTriangles.empty() ? triangles : normalTriangles;
        return normals[static_cast<std::size_t>(n[triangle][corner])].cast<double>().normalized();
    }
};

struct SubdivisionOptions {
    SubdivisionScheme scheme = SubdivisionScheme::CatmullClark;
    int levels = 3;          ///< uniform, 0..kMaxSubdivisionLevels
    double tolerance = 0.0;  ///< > 0: adaptive; no point of the surface is farther than this from
                             ///< the triangles [mm]. `levels` is not used then
    std::size_t memoryLimit = std::size_t{1} << 30U;  ///< largest result [bytes]
};

/// The subdivision surface of a control cage, by OpenSubdiv.
///
/// Uniform: the vertices that `levels` rounds of subdivision have, moved to the limit surface (for
/// level 0 the cage's own). Adaptive: each edge of the cage gets as many pieces as its curve and
/// its two faces need, so that neighbours agree; the inside of a face as many as it needs. Vertices
/// of both lie on the limit surface, normals are exact; where an infinitely sharp edge or corner
/// is, every side has its own normal. Where the parameters of a flat part run backwards, its
/// triangles are cut anew over the same points; those beyond its border are moved into it.
///
/// \pre the cage is closed and oriented (checked).
/// Errors: BadValue for options out of range or a cage that the scheme cannot use (Loop needs
/// triangles) or coordinates that are not finite; NotClosed, NotManifold, NotOriented;
/// TooMuchMemory, before anything large is allocated; Internal where OpenSubdiv refuses.
/// Several shells are one surface of several shells. O(triangles).
/// \paper{6.1}
Result<SurfaceMesh> subdivide(const ControlCage& cage, const SubdivisionOptions& options);

/// Bytes that the result of subdivide() takes at most.
std::size_t surfaceBytes(std::size_t positions, std::size_t triangles, bool creased);

}  // namespace ew
