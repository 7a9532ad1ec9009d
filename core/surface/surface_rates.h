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
};

/// Where a face is to be measured: coordinates in its parameter domain.
std::vector<Vec2> rateSamples(const OpenSubdiv::Bfr::Parameterization& face);

/// Measures a face by second differences of points on it. What counts is how far the surface bends
/// out of its tangent plane: how it is parameterised does not matter.
/// \param samples  the surface at rateSamples(face).
/// \param regular  without an extraordinary point, at which surfaces bend more than samples show.
/// \param hard     by edge: a crease, whose curve counts in all directions.
FaceRates facePieces(const OpenSubdiv::Bfr::Parameterization& face, std::span<const Vec3> samples,
                     bool regular, double tolerance, const std::vector<bool>& hard);

}  // namespace ew
