// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/edge_graph/edge_graph.h"

namespace ew {

/// The graph without some of its edges: what that leaves dangling goes too, and where two edges are
/// left at a junction without a corner they become one. Removed ink is listed as stray noise.
EdgeGraph withoutEdges(const EdgeGraph& graph, const std::vector<int>& edges);

/// The connected parts of a graph, the one with the most ink first. Noise, dangling edges and open
/// ends stay with the first.
std::vector<EdgeGraph> connectedParts(const EdgeGraph& graph);

/// Several graphs as one, beside each other; the inverse of connectedParts().
EdgeGraph joinedParts(const std::vector<EdgeGraph>& parts);

/// Bounding-box diagonal of the junctions [px].
double graphExtent(const EdgeGraph& graph);

/// Is the graph one closed line, with no junction of more than two edges?
bool isOneOutline(const EdgeGraph& graph);

}  // namespace ew
