// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface: brings OpenSubdiv with it.
#pragma once

#include <opensubdiv/bfr/parameterization.h>

#include <array>
#include <vector>

#include "core/base/vec.h"

namespace ew {

/// How the parameter domain of a face is cut up. The points of the border come first, from corner 0
/// round along edge 0, corner 1 and so on; then those inside.
struct SurfacePattern {
    std::vector<Vec2> coords;
    std::vector<std::array<int, 4>> facets;  ///< counter-clockwise; [3] is -1 in a triangle
};

/// What `levels` rounds of subdivision make of a face.
SurfacePattern uniformPattern(const OpenSubdiv::Bfr::Parameterization& face, int levels);

/// A pattern with its own number of pieces on every edge, and inside.
/// \param rates  by edge, then one inner rate, or two for quadrangles (along edge 0, along edge 1).
SurfacePattern adaptivePattern(const OpenSubdiv::Bfr::Parameterization& face,
                               const std::vector<int>& rates);

}  // namespace ew
