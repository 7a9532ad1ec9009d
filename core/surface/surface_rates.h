// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface: brings OpenSubdiv with it.
#pragma once

#include <opensubdiv/bfr/parameterization.h>

#include <array>
#include <span>
#include <vector>

#include "core/base/vec.h"

namespace ew {

/// Pieces that a face needs so that flat triangles stay within a tolerance of the limit surface.
struct FaceRates {
    std::vector<double> edges;  ///< by edge of the face
    std::array<double, 2>
        inner{};  ///< along edge 0 and along edge 1 of a quadrangle; else the same
    std::array<double, 2> stitched{};  ///< the same where an edge is not cut as the inside is
};

/// Where a face is to be measured: coordinates in its parameter domain.
/// \param regular  as in FaceSamples.
std::vector<Vec2> rateSamples(const OpenSubdiv::Bfr::Parameterization& face, bool regular);

/// What is known of a face.
struct FaceSamples {
    std::span<const Vec3> points;  ///< the surface at rateSamples()
    bool regular = false;          ///< one patch: no extraordinary point, no crease
    std::vector<bool> hard;        ///< by edge: a crease, whose curve counts in all directions
    std::vector<bool> peaks;  ///< by corner: more faces meet than in a regular one, so that the
                              ///< bend grows without a limit
};

/// Measures a face by its samples. What counts is how far the surface bends out of its tangent
/// plane: how it is parameterised does not matter. Where it takes few pieces, the distance of the
/// samples from these is what is measured.
FaceRates facePieces(const OpenSubdiv::Bfr::Parameterization& face, const FaceSamples& samples,
                     double tolerance);

}  // namespace ew
