// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/edge_graph/edge_graph.h"
#include "core/reading/score/candidates.h"

namespace ew {

/// One way to read the strokes, with what it leads to.
struct GraphReading {
    EdgeGraph graph;
    std::vector<EdgeGraph> otherParts;
    std::vector<RatedCandidate> candidates;  ///< best first
    std::vector<Slip> slips;                 ///< what it would be, were it drawn right
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

/// What a drawing is more likely meant as than the best candidate of the best reading, were it
/// drawn right, by all of its readings; the likeliest slip where that reading has no candidate
/// within the thresholds. nullptr: nothing.
/// \param any  also one of the best candidate's own template.
/// \param inkPx  all that was drawn: lines left out fit anything.
const Slip* likeliestSlip(const std::vector<GraphReading>& readings, const GraphReading& best,
                          double inkPx, bool any = false);

}  // namespace ew
