// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/edge_graph/line_ends.h"

namespace ew {

/// A stretch of a line between two parameters [px from InkLine::a].
struct LinePiece {
    int line = -1;
    double t0 = 0.0;
    double t1 = 0.0;
};

/// The Edge Graph while it is being made: edges between vertices, each with the ink it came from.
struct RawGraph {
    struct Edge {
        std::array<int, 2> v{-1, -1};
        std::vector<LinePiece> pieces;  ///< in order from v[0] to v[1]
        bool alive = true;
    };
    std::vector<Vec2> vertices;  ///< [px]
    std::vector<Edge> edges;

    /// Living edges at every vertex.
    std::vector<std::vector<int>> incidence() const;
};

struct PlanarizeOptions {
    JoinOptions join;
    double throughReach = 0.4;  ///< tol::kThroughReach, in fractions of the distance threshold
};

/// Cuts lines where others end on them (T junctions) or cross them.
RawGraph planarize(const std::vector<InkLine>& lines, const std::vector<EndCluster>& clusters,
                   const PlanarizeOptions& options);

}  // namespace ew
