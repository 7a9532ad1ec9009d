// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/edge_graph/edge_graph.h"
#include "core/reading/types/interpretation.h"
#include "core/tlib/library_index.h"

namespace ew {

/// What a drawing that fits no template has less and more than one that shows an aspect.
struct AspectDifference {
    std::vector<std::array<Vec2, 2>> missing;  ///< edges of the aspect that are not drawn [px]
    std::vector<int> extra;                    ///< graph edges that it does not show
    int strays = 0;                            ///< lines with an open end that it does not show
    double offPx = 0.0;  ///< rms distance of the drawn corners to the template in such a view
};

/// Lays as many drawn lines as can be over the edges of an aspect, corner on corner; of equally
/// many the most parallel ones. Lines that are attached at one end only count as drawn: what they
/// lack is told as an open end. Cost: a bounded search; nothing where it
/// ends without a result, as with a drawing that has little in common with the aspect.
/// \pre the graph has edges.
std::optional<AspectDifference> compare(const EdgeGraph& graph, const LibraryEntry& entry,
                                        const Aspect& aspect, double distancePx);

/// The template that a drawing is nearest to.
struct Nearest {
    NearestTemplate shown;
    std::array<int, 6> degrees{};  ///< corners of its aspect by how many lines meet there, 5: more
    int strays = 0;                ///< lines with an open end that it does not show
};

/// Of the aspects with much the same corners, the one that differs by the fewest lines. Nothing
/// where none has much in common with the drawing. Cost: that of a few compare().
/// \pre the graph has edges.
std::optional<Nearest> nearestTemplate(const EdgeGraph& graph, const TemplateLibrary& library,
                                       double distancePx);

/// How many lines meet at each junction.
std::vector<int> junctionDegrees(const EdgeGraph& graph);

}  // namespace ew
