// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/edge_graph/edge_graph.h"
#include "core/reading/extract/line_drawing.h"

namespace ew {

/// The graph of buildWireGraph() as a drawing of wires. Nodes are its junctions, and no line ends
/// behind another.
///
/// Where the wires have one planar embedding (no two corners whose removal takes them apart), its
/// regions are the faces of the solid, all of them, those that look away, too (Whitney 1933), and
/// LineDrawing::Node::out is in their order; elsewhere there are no regions.
/// \return nothing where some corner has fewer than three lines: then something is not drawn.
/// O(corners^2 * lines).
std::optional<LineDrawing> wireDrawing(const EdgeGraph& graph);

}  // namespace ew
