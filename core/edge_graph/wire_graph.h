// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/edge_graph/build.h"

namespace ew {

/// The Edge Graph of a drawing that shows all edges, those that are hidden, too: lines meet where
/// their ends do, and nowhere else; those that cross pass each other. What was drawn in several
/// pieces, one for each stretch that is seen or hidden, is one edge. Not a plane graph.
/// A line may lie on another one in the picture, or so near that both were taken for one: where a
/// corner lacks its third line and ink leads from there to another corner, there is one.
/// \return without edges where nothing is closed; otherwise one graph, or a few where a line that
///         is covered may lead to several corners. O(n^2) in the number of segments.
/// \paper{4.1.1}
std::vector<EdgeGraph> buildWireGraphs(const InkReading& ink, double distancePx);

/// Do lines cross well away from their ends, as in a drawing that shows hidden edges? In one of
/// what is seen alone lines end where they meet. A few crossings may be a detail, as in a window
/// with panes. O(n^2) in the number of segments.
bool crossesLikeWires(const InkReading& ink, double distancePx);

}  // namespace ew
