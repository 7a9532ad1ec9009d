// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/edge_graph/edge_graph.h"
#include "core/reading/score/candidates.h"

namespace ew {

/// One way to read the strokes, with what it leads to.
struct GraphReading {
    EdgeGraph graph;
    std::vector<EdgeGraph> otherParts;
    std::vector<RatedCandidate> candidates;  ///< best first
    std::optional<Vec2> impossibleCorner;
    int extraEdges = 0;
    double price = 0.0;  ///< of the graph: ink dropped or bent straight, second looks, extra edges
    double strayPrice = 0.0;  ///< ... that part of it which is for ink dropped
    double cost = 0.0;        ///< of the best candidate, price included
    bool clear = false;
    bool ambiguous = false;
};

/// Decides whether the best candidate is clear enough to be taken by itself.
void judge(GraphReading& reading);

/// Is the best candidate of a before that of b?
bool better(const GraphReading& a, const GraphReading& b);

}  // namespace ew
