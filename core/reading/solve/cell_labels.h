// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/reading/solve/cell_complex.h"
#include "core/reading/solve/cell_votes.h"

namespace ew {

/// Which cells are solid. What the eye sees decides; what it does not see is filled more or less so
/// that the surface is least (a minimal cut), and then changed, all on one side of a plane at a
/// time, as long as that makes the edges of the solid shorter.
/// \return per answer and cell; the answers differ.
std::vector<std::vector<bool>> cellLabels(const CellComplex& complex,
                                          const std::vector<CellVotes>& votes);

}  // namespace ew
