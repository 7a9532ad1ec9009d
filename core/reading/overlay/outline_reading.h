// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/edge_graph/build.h"
#include "core/tlib/matcher.h"

namespace ew {

/// Ink read from the whole to its parts: an aspect laid over it.
struct OutlineReading {
    EdgeGraph graph;   ///< the aspect's graph, every edge fitted to the ink beside it
    GraphMatch match;  ///< which vertex and edge is which; parallelDeg is measured
    double barePx =
        0.0;  ///< length of edges along which there is no ink, but for gaps at their ends
    double widestGapPx = 0.0;  ///< longest stretch of an edge without ink
};

struct OutlineOptions {
    double distancePx = 14.0;  ///< the distance threshold [px], > 0
    double excusePx = 0.0;  ///< GraphMatch::parallelDeg leaves out what this does to an edge [px]
    bool frames = true;     ///< also where the ink's own directions put a rectilinear template
};

/// Lays the aspects of a convex template over the ink, outline on outline, and lets every edge take
/// the ink that runs beside it. Finds what a graph built from line ends up misses where corners lie
/// so close together, or are missed so far, that ends join wrongly: the outline of a drawing
/// survives that.
///
/// Only explicit aspects without T junctions whose edges all find ink are laid. In turn, every way
/// to lay an outline of n corners on the n corners of the convex hull of the ink; then ink is
/// assigned by distance and direction and edges are fitted anew (three rounds).
/// \return the best fitting ones, at most two an aspect; empty for templates that are not convex.
/// Cost: O(n (p + e)) an aspect of n outline vertices and e edges over p points of ink.
std::vector<OutlineReading> readingsByOutline(const InkReading& ink,
                                              const std::shared_ptr<const LibraryEntry>& entry,
                                              const OutlineOptions& options);

}  // namespace ew
