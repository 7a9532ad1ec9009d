// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/base/vec.h"

namespace ew {

/// Splits a path into straight pieces: the partition with the least squared residual for each
/// number of pieces (dynamic programming), and among those the number with the best penalised
/// likelihood n/2 log(residual + wobble^2) - penalty.
/// \param nodes  m >= 2 points along the path [px], about evenly spaced.
/// \param wobblePx  how far this hand strays from a straight line, rms [px], > 0.
/// \return indices of the cuts, first 0, last m - 1. O(m + k c^2) for k pieces and c <= 90 places
///     where the path may turn.
std::vector<std::size_t> optimalPartition(const std::vector<Vec2>& nodes, double wobblePx);

/// Moves each inner cut to where its two pieces fit best.
/// \pre cuts as optimalPartition returns them.
void refineCuts(const std::vector<Vec2>& nodes, std::vector<std::size_t>& cuts);

/// Root mean square distance of a run of nodes to its line [px].
double runRms(const std::vector<Vec2>& nodes, std::size_t first, std::size_t last);

}  // namespace ew
