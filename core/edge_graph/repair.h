// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "core/edge_graph/build.h"
#include "core/edge_graph/faces.h"

namespace ew {

struct RepairOptions {
    double distancePx = 14.0;  ///< the distance threshold [px]
    double spreadPx = 2.0;     ///< how far this hand misses what it aims at, per axis [px]
    double maxPrice = 60.0;    ///< dearer repairs are not tried
    double pastFirst = 20.0;   ///< ... nor any this much dearer than the first that led somewhere
    std::size_t maxStates = 1500;                  ///< graphs looked at, at most
    std::function<bool(const PlaneGraph&)> known;  ///< is it worth settling a graph of this shape?
};

/// A graph after a few small corrections.
struct RepairedGraph {
    EdgeGraph graph;
    double price = 0.0;  ///< sum over the corrections, in units of twice a log-likelihood
    int dropped = 0;     ///< edges left out that no other edge explains
};

/// What a rough hand's drawing may have been meant to be: searches, cheapest first, through graphs
/// that differ from the drafts by joining two vertices or landing an open end on an edge (price:
/// squared distance over squared spread), leaving out an edge (little where another edge runs
/// beside it), and taking a bend for straight. Returns those whose shape is known, cheapest first.
/// Cost: O(states * (V^2 + E^2)).
/// \paper{4.1.3}
std::vector<RepairedGraph> repairedGraphs(const InkReading& ink,
                                          const std::vector<GraphDraft>& drafts,
                                          const RepairOptions& options);

}  // namespace ew
