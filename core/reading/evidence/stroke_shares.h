// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "core/edge_graph/edge_graph.h"

namespace ew {

/// How much of a stroke a reading explains [px].
struct StrokeShare {
    double beside = 0.0;  ///< along no edge
    double all = 0.0;
};

/// The strokes of which a reading explains less than half, and those that are no lines; ascending.
/// \param shares  by stroke.
std::vector<int> strokesLeftOut(const std::map<int, StrokeShare>& shares,
                                const std::vector<NoiseItem>& noise);

}  // namespace ew
