// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/edge_graph/edge_graph.h"

namespace ew {

/// The open ends that are worth telling: closed, all of them together, their line would border a
/// region. A gap that is open from both of its sides is there once. \pre findOpenEnds()
/// \return in the order of graph.openEnds. O(n^2) in the dangling lines.
std::vector<OpenEnd> closableEnds(const EdgeGraph& graph);

}  // namespace ew
