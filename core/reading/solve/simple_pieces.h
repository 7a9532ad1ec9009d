// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/vec.h"

namespace ew {

/// A face with holes as several without: each hole is cut open along two diagonals between corners.
/// O(corners^3) a hole.
/// \param points  of all corners.
/// \param loops   [0] the outer one, holes the other way round.
/// \return loops of the same corners; empty where no two diagonals are free.
std::vector<std::vector<int>> simplePieces(const std::vector<Vec3>& points,
                                           const std::vector<std::vector<int>>& loops);

}  // namespace ew
