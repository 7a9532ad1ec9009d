// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/edge_graph/edge_graph.h"
#include "core/edge_graph/planarize.h"

namespace ew {

/// Something that belongs to no closed region, with where it was.
struct PrunedEdge {
    std::array<int, 2> v{-1, -1};
    std::vector<LinePiece> pieces;
    bool attachedAtFirst = false;   ///< v[0] is (still) a vertex of the graph
    bool attachedAtSecond = false;  ///< v[1] is
};

/// Takes out everything that borders no region: dangling trees and bridges. Returns what was taken.
/// \paper{4.1.3}
std::vector<PrunedEdge> pruneOpen(RawGraph& graph);

/// Unites the two edges at every vertex of degree two that is certainly no corner (one line, or a
/// bend too slight to be meant), and edges that join the same two vertices (a retrace that
/// consolidation left).
void dissolveCertain(RawGraph& graph, double distancePx);

/// The vertex of degree two that bends least among those that may be no corner, and how much [px]:
/// where an edge was drawn in two strokes the hand leaves such a bend, but a flat corner looks the
/// same.
struct Bend {
    int vertex = -1;
    double bendPx = 0.0;
    double turnDeg = 0.0;
};
std::optional<Bend> leastBend(const RawGraph& graph, double distancePx);

/// Unites the two edges at that vertex, and doubles that this makes.
void dissolveAt(RawGraph& graph, int vertex);

/// dissolveCertain, and dissolveAt for those of the vertices that join two edges.
void straighten(RawGraph& graph, const std::vector<int>& vertices, double distancePx);

/// All vertices of degree two that may be no corner.
std::vector<Bend> doubtfulBends(const RawGraph& graph, double distancePx);

}  // namespace ew
