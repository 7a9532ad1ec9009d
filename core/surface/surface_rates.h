// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface.
#pragma once

#include <vector>

#include "core/surface/limit_surface.h"

namespace ew {

/// Pieces that a face needs so that flat triangles stay within a tolerance of the limit surface.
struct FaceRates {
    std::vector<double> edges;  ///< by edge of the face
    std::array<double, 2>
        inner{};  ///< along edge 0 and along edge 1 of a quadrangle; else the same
};

/// Measures the selected face by second differences of points on it. What counts is how far the
/// surface bends out of its tangent plane: how it is parameterised does not matter.
/// \param hard  by edge: a crease, whose curve counts in all directions.
FaceRates facePieces(const LimitSurface& surface, double tolerance, const std::vector<bool>& hard);

}  // namespace ew
