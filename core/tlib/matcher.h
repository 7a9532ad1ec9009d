// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/edge_graph/edge_graph.h"
#include "core/tlib/library_index.h"

namespace ew {

/// An Edge Graph read as an aspect of a template.
struct GraphMatch {
    std::shared_ptr<const LibraryEntry> entry;
    std::shared_ptr<const Aspect> aspect;  ///< with missing edges already left out
    std::vector<int> vertex;               ///< per junction: template vertex, -1 for a T junction
    std::vector<int> edge;     ///< per graph edge: template edge (TemplateAnalysis::edges)
    bool mirrored = false;     ///< the drawing is the mirror image of the aspect
    int missingEdges = 0;      ///< aspect edges that the drawing has not
    double parallelDeg = 0.0;  ///< largest angle between an edge and the mean of its class, less
                               ///< what the distance threshold excuses on short edges [degrees]
    double bentDeg = 0.0;      ///< largest bend of a T junction's bar [degrees]
};

struct MatchOptions {
    double distancePx = 14.0;
    double spreadPx = 0.0;      ///< how far this hand's line ends lie apart where they should meet
    std::string templateId;     ///< only this one where not empty
    bool allowMissing = false;  ///< look for aspects with one edge more than the drawing
    std::size_t maxMatches = 24;  ///< the best by parallelism are returned
};

/// Finds all aspects with this graph. A hash of the canonical code finds the aspects in O(1), so
/// the cost does not grow with templates that do not fit; the walks of the canonical form are the
/// maps; maps that differ by a symmetry of the template are one match.
/// \paper{4.2}
std::vector<GraphMatch> matchGraph(const EdgeGraph& graph, const LibraryIndex& library,
                                   const MatchOptions& options);

/// Measures parallelDeg and bentDeg of a match.
/// \param excusePx  moving an edge's end by this is no turn [px].
void measureMatch(GraphMatch& match, const EdgeGraph& graph, double excusePx);

/// The Edge Graph as a plane graph, for canonicalForm.
PlaneGraph planeGraph(const EdgeGraph& graph);

}  // namespace ew
