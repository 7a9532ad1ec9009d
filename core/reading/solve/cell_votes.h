// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/reading/extract/line_drawing.h"
#include "core/reading/solve/cell_complex.h"

namespace ew {

/// What the eye sees of a cell, as area of the picture [px^2].
struct CellVotes {
    double empty = 0.0;  ///< it sees into the cell
    double solid = 0.0;  ///< it sees the cell's face
    bool unseen() const { return empty == 0.0 && solid == 0.0; }
};

/// Rays through a face that is drawn meet nothing before its plane and solid just behind it, rays
/// beside the drawing meet nothing at all.
/// \param planeOf   per region: plane of its face.
/// \param spreadPx  rays as near as this to a line are not asked.
/// \return per cell. O(rays * (planes + lines)).
std::vector<CellVotes> cellVotes(const CellComplex& complex, const LineDrawing& drawing,
                                 const std::vector<int>& planeOf, double spreadPx);

}  // namespace ew
