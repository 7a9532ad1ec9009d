// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/edge_graph/edge_graph.h"
#include "core/edge_graph/planarize.h"
#include "core/stroke/consolidate.h"
#include "core/stroke/stroke.h"

namespace ew {

/// How to read doubtful places; the defaults are the first reading, the others are tried where that
/// one matches nothing.
struct ReadingOptions {
    double joinScale = 1.0;     ///< reach of stroke ends, times the distance threshold
    double mergeScale = 1.0;    ///< readiness to take close lines for one
    double throughReach = 0.4;  ///< tol::kThroughReach
    double breakReach = 1.3;  ///< widest gap in the middle of an edge, times the distance threshold
};

/// The strokes as straight pieces, with what is no line set aside as noise.
struct InkReading {
    std::vector<Segment> segments;
    std::vector<NoiseItem> noise;
    double wobblePx = 0.0;  ///< how much this hand strays from straight lines, rms
};

/// Step 1a: corners and lines of every stroke. Strokes that cannot be read (see validateStroke)
/// must not come here.
InkReading readInk(const std::vector<Stroke>& strokes, double distancePx);

/// Most lines, of those drawn twice only one counting, that are read at once: several times the
/// edges that a template can show, each in several pieces. What comes behind is O(n^2) in lines and
/// in their crossings.
inline constexpr std::size_t kMaxLines = 300;

/// Are there more lines than kMaxLines?
bool isCrowded(const InkReading& ink, double distancePx);

/// Step 1b, case 1: the Edge Graph of straight pieces of ink. Ends within the
/// distance threshold meet in one junction; ends close to the inside of a line make a T junction;
/// overshoot is trimmed; what borders no region is dropped and listed as noise or dangling, with
/// the open ends that look as if they were meant to meet something. After the topology is settled
/// every edge is fitted again to the ink between its junctions, and every junction to its edges.
/// O(n^2) in the number of segments.
/// \return one graph for each plausible choice of which bends are corners, the most usual choice
/// first:
///         the others take fewer or more of the slight bends for the middle of an edge that was
///         drawn in two strokes. Never empty; a graph without edges where nothing is closed.
/// \paper{4.1.1}
std::vector<EdgeGraph> buildEdgeGraphs(const InkReading& ink, double distancePx,
                                       const ReadingOptions& options = {});

/// A graph whose ends are joined and whose lines are cut, before anything is dropped or
/// straightened.
struct GraphDraft {
    std::vector<InkLine> lines;
    RawGraph raw;
    double price = 0.0;  ///< of the tolerances that it took, in units of twice a log-likelihood
};
GraphDraft draftEdgeGraph(const InkReading& ink, double distancePx,
                          const ReadingOptions& options = {});

/// The line through the ink of an edge, directed from p0 to p1; ends are not set.
GraphEdge fitEdge(const Vec2& p0, const Vec2& p1, const std::vector<LinePiece>& pieces,
                  const std::vector<InkLine>& lines);

/// Puts every junction at the weighted least-squares intersection of its edges' fitted lines, and
/// tips where no pen stopped at their junction.
void settleJunctions(EdgeGraph& graph, double distancePx);

/// Settles a draft: drops what borders no region, takes the bends at `straight` (and those that are
/// certainly none) for the middle of an edge, fits edges and junctions to the ink.
EdgeGraph settleEdgeGraph(const InkReading& ink, const std::vector<InkLine>& lines, RawGraph raw,
                          const std::vector<int>& straight, double distancePx);

/// The most usual one.
EdgeGraph buildEdgeGraph(const InkReading& ink, double distancePx,
                         const ReadingOptions& options = {});

}  // namespace ew
