// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/reading/solve/cell_complex.h"

namespace ew {

/// A solid made of cells, by its faces. Camera space [px].
struct CellSolid {
    struct Face {
        int plane = -1;                       ///< of the complex
        std::vector<std::vector<int>> loops;  ///< vertices; [0] outer, counter-clockwise from
                                              ///< outside, holes clockwise
    };
    std::vector<Vec3> vertices;  ///< only those where three faces or more meet
    std::vector<Face> faces;
};

/// The surface of the solid cells, facets in one plane joined.
/// \param solid  per cell.
/// \return nothing where it is empty, no 2-manifold, or a face touches itself.
std::optional<CellSolid> cellSolid(const CellComplex& complex, const std::vector<bool>& solid);

}  // namespace ew
