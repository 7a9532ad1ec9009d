// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edge_graph/build.h"

#include <algorithm>
#include <cmath>

#include "core/base/tolerance.h"
#include "core/edge_graph/line_ends.h"
#include "core/edge_graph/open_ends.h"
#include "core/edge_graph/planarize.h"
#include "core/edge_graph/prune.h"
#include "core/stroke/segmenting.h"

namespace ew {
namespace {
std::size_t at(int i) { return static_cast<std::size_t>(i); }
}  // namespace

GraphEdge fitEdge(const Vec2& p0, const Vec2& p1, const std::vector<LinePiece>& pieces,
                  const std::vector<InkLine>& lines) {
    GraphEdge edge;
    const Vec2 axis = p1 - p0;
    const double len = std::max(axis.norm(), 1e-9);
    const Vec2 u = axis / len;
    const double margin = std::min(4.0, 0.1 * len);

    std::vector<Vec2> ink;
    std::vector<int> strokes;
    // Extent along the edge of what was drawn for it, by whole lines: their ends are the real pen
    // ends.
    double lo = len;
    double hi = 0;
    Vec2 loTip = p0;
    Vec2 hiTip = p1;
    for (const LinePiece& piece : pieces) {
        const InkLine& line = lines[at(piece.line)];
        strokes.insert(strokes.end(), line.strokes.begin(), line.strokes.end());
        edge.inkPx += std::abs(piece.t1 - piece.t0);
        for (const Vec2& p : line.points) {
            const double t = (p - p0).dot(u);
            if (t > margin && t < len - margin) ink.push_back(p);
        }
        for (const Vec2& tip : {line.a, line.b}) {
            const double t = (tip - p0).dot(u);
            if (t < lo) {
                lo = t;
                loTip = tip;
            }
            if (t > hi) {
                hi = t;
                hiTip = tip;
            }
        }
    }
    std::sort(strokes.begin(), strokes.end());
    strokes.erase(std::unique(strokes.begin(), strokes.end()), strokes.end());
    edge.strokes = std::move(strokes);

    Vec2 center;
    Vec2 dir;
    const LineFit fit = ink.size() >= 4 ? fitLine(ink) : LineFit{};
    if (ink.size() >= 4 && fit.tMax - fit.tMin > 0.4 * len) {
        center = fit.center;
        dir = fit.direction;
        edge.wobblePx = fit.rmsPx;
    } else {
        const InkLine& line = lines[at(pieces.front().line)];
        center = 0.5 * (line.a + line.b);
        dir = pieces.size() == 1 ? line.direction() : u;
    }
    if (dir.dot(u) < 0) dir = -dir;
    // A line that runs on past the vertex (a T junction's bar) has no end there to speak of.
    const double reach = 0.12 * len + 6.0;
    auto tipNear = [&](const Vec2& vertex, const Vec2& tip, bool penEnd) {
        return Vec2(center + dir * ((penEnd ? tip : vertex) - center).dot(dir));
    };
    edge.penEnd = {std::abs(lo) < reach, std::abs(hi - len) < reach};
    edge.tips = {tipNear(p0, loTip, edge.penEnd[0]), tipNear(p1, hiTip, edge.penEnd[1])};
    return edge;
}

void settleJunctions(EdgeGraph& graph, double distancePx) {
    const double wAcross = 1.0 / std::pow(tol::kEndSpreadAcross * distancePx, 2);
    const double wAlong = 1.0 / std::pow(tol::kEndSpreadAlong * distancePx, 2);
    std::vector<Eigen::Matrix2d> m(graph.junctions.size(), Eigen::Matrix2d::Zero());
    std::vector<Vec2> r(graph.junctions.size(), Vec2::Zero());
    for (const GraphEdge& e : graph.edges) {
        const Vec2 d = (e.tips[1] - e.tips[0]).normalized();
        const Vec2 n(-d.y(), d.x());
        for (std::size_t s = 0; s < 2; ++s) {
            // Where the line runs on, its end says nothing about how far.
            const double along = (e.penEnd[s] ? 1.0 : 1e-6) * wAlong;
            const Eigen::Matrix2d w = wAcross * n * n.transpose() + along * d * d.transpose();
            m[at(e.ends[s])] += w;
            r[at(e.ends[s])] += w * e.tips[s];
        }
    }
    for (std::size_t j = 0; j < graph.junctions.size(); ++j) {
        const double det = m[j].determinant();
        if (det > 1e-18) {
            const Eigen::Matrix2d inverse =
                (Eigen::Matrix2d() << m[j](1, 1), -m[j](0, 1), -m[j](1, 0), m[j](0, 0)).finished() /
                det;
            graph.junctions[j].position = inverse * r[j];
        }
    }
    for (GraphEdge& e : graph.edges) {
        const Vec2 d = (e.tips[1] - e.tips[0]).normalized();
        for (std::size_t s = 0; s < 2; ++s) {
            if (e.penEnd[s]) continue;
            const Vec2& p = graph.junctions[at(e.ends[s])].position;
            e.tips[s] += d * d.dot(p - e.tips[s]);
        }
    }
}

namespace {

std::vector<Vec2> pieceOutline(const std::vector<InkLine>& lines, const LinePiece& piece) {
    const InkLine& line = lines[at(piece.line)];
    const Vec2 d = line.direction();
    return {line.a + d * piece.t0, line.a + d * piece.t1};
}

/// Sorts what was pruned into trimmed overshoot, stray ink and dangling edges.
void setAside(EdgeGraph& graph, const RawGraph& raw, const std::vector<PrunedEdge>& pruned,
              const std::vector<InkLine>& lines, const std::vector<int>& junctionOf,
              double distancePx) {
    std::vector<bool> used(lines.size(), false);
    for (const RawGraph::Edge& e : raw.edges) {
        if (!e.alive) continue;
        for (const LinePiece& p : e.pieces) used[at(p.line)] = true;
    }
    for (const PrunedEdge& p : pruned) {
        double length = 0;
        for (const LinePiece& piece : p.pieces) length += std::abs(piece.t1 - piece.t0);
        const InkLine& line = lines[at(p.pieces.front().line)];
        const double limit =
            std::max(tol::kOvershootReach * distancePx, tol::kOvershootShare * line.length());
        const bool overshoot = used[at(p.pieces.front().line)] && length < limit;
        for (const LinePiece& piece : p.pieces) {
            for (const int stroke : lines[at(piece.line)].strokes) {
                graph.noise.push_back({overshoot ? NoiseKind::Overshoot : NoiseKind::Stray, stroke,
                                       pieceOutline(lines, piece)});
            }
        }
        if (overshoot) continue;
        DanglingEdge d;
        const bool first = p.attachedAtFirst || !p.attachedAtSecond;
        const int from = first ? p.v[0] : p.v[1];
        const int to = first ? p.v[1] : p.v[0];
        d.ends = {raw.vertices[at(from)], raw.vertices[at(to)]};
        d.junction = junctionOf[at(from)];
        for (const LinePiece& piece : p.pieces) {
            const auto& s = lines[at(piece.line)].strokes;
            d.strokes.insert(d.strokes.end(), s.begin(), s.end());
        }
        graph.dangling.push_back(std::move(d));
    }
}

}  // namespace

namespace {

InkReading readWithWobble(const std::vector<Stroke>& strokes, double distancePx, double wobblePx) {
    InkReading ink;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        StrokeReading reading = readStroke(strokes[i], static_cast<int>(i), distancePx, wobblePx);
        NoiseKind kind = NoiseKind::Dot;
        switch (reading.kind) {
            case StrokeKind::Polyline:
                for (Segment& s : reading.segments) ink.segments.push_back(std::move(s));
                continue;
            case StrokeKind::Dot:
                kind = NoiseKind::Dot;
                break;
            case StrokeKind::Scribble:
                kind = NoiseKind::Scribble;
                break;
            case StrokeKind::Curve:
                kind = NoiseKind::Curve;
                break;
        }
        ink.noise.push_back({kind, static_cast<int>(i), std::move(reading.outline)});
    }
    return ink;
}

/// A third of the pieces says that a hand is steady.
constexpr double kSteadyShare = 0.3;

/// How much this hand wobbles: the median of the longer straight pieces of its drawing [px rms], so
/// that a piece with a corner overlooked does not count.
/// \param share  another quantile, 0..1.
double handWobble(const InkReading& ink, double distancePx, double share = 0.5) {
    std::vector<double> rms;
    for (const Segment& s : ink.segments) {
        if (s.inkPx >= 2.5 * distancePx) rms.push_back(s.rmsPx);
    }
    if (rms.empty()) return tol::kWobbleUnknownPx;
    const auto n = static_cast<double>(rms.size());
    const auto at = rms.begin() + static_cast<std::ptrdiff_t>(std::floor(share * n));
    std::nth_element(rms.begin(), at, rms.end());
    return *at;
}

}  // namespace

InkReading readInk(const std::vector<Stroke>& strokes, double distancePx) {
    InkReading ink = readWithWobble(strokes, distancePx, tol::kWobbleUnknownPx);
    const auto wobbleOf = [&](const InkReading& r, double share) {
        return std::max(tol::kWobbleLeastPx, 1.3 * handWobble(r, distancePx, share));
    };
    // In a small drawing most pieces may have an overlooked corner. A hand that was steady in some
    // is steady, if that leaves none that strays.
    bool known = false;
    const double wobble = wobbleOf(ink, 0.5);
    const double steady = wobbleOf(ink, kSteadyShare);
    if (wobble >= 0.6 * tol::kWobbleUnknownPx && steady < 0.25 * tol::kWobbleUnknownPx) {
        InkReading again = readWithWobble(strokes, distancePx, steady);
        known = handWobble(again, distancePx) <= steady;
        if (known) ink = std::move(again);
    }
    // A steadier hand than was assumed means its slight bends.
    if (!known && wobble < tol::kWobbleUnknownPx) {
        ink = readWithWobble(strokes, distancePx, wobble);
    }
    // No hand is that steady: the lines are computed or ruled, and their corners are all meant.
    if (handWobble(ink, distancePx, kSteadyShare) < tol::kRuledPx) {
        InkReading ruled = readWithWobble(strokes, distancePx, tol::kRuledWobblePx);
        if (handWobble(ruled, distancePx) < tol::kRuledPx) ink = std::move(ruled);
    }
    ink.wobblePx = handWobble(ink, distancePx);
    return ink;
}

bool isCrowded(const InkReading& ink, double distancePx) {
    ConsolidateOptions options;
    options.distancePx = distancePx;
    options.mostLines = kMaxLines;
    return consolidate(ink.segments, options).size() > kMaxLines;
}

namespace {

EdgeGraph finish(const RawGraph& raw, const std::vector<PrunedEdge>& pruned,
                 const std::vector<InkLine>& lines, const InkReading& ink, double distancePx) {
    EdgeGraph graph;
    graph.noise = ink.noise;
    std::vector<int> junctionOf(raw.vertices.size(), -1);
    for (const RawGraph::Edge& e : raw.edges) {
        if (!e.alive) continue;
        for (const int v : e.v) {
            if (junctionOf[at(v)] >= 0) continue;
            junctionOf[at(v)] = static_cast<int>(graph.junctions.size());
            graph.junctions.push_back({raw.vertices[at(v)]});
        }
        GraphEdge edge =
            fitEdge(raw.vertices[at(e.v[0])], raw.vertices[at(e.v[1])], e.pieces, lines);
        edge.ends = {junctionOf[at(e.v[0])], junctionOf[at(e.v[1])]};
        graph.edges.push_back(std::move(edge));
    }
    settleJunctions(graph, distancePx);
    setAside(graph, raw, pruned, lines, junctionOf, distancePx);
    findOpenEnds(graph, distancePx);
    return graph;
}

constexpr std::size_t kMostBends = 6;

}  // namespace

GraphDraft draftEdgeGraph(const InkReading& ink, double distancePx, const ReadingOptions& options) {
    GraphDraft draft;
    draft.lines = consolidate(ink.segments, {distancePx, options.mergeScale});
    const JoinOptions join{distancePx, options.joinScale, options.breakReach};
    draft.raw = planarize(draft.lines, joinEnds(draft.lines, join), {join, options.throughReach});
    return draft;
}

EdgeGraph settleEdgeGraph(const InkReading& ink, const std::vector<InkLine>& lines, RawGraph raw,
                          const std::vector<int>& straight, double distancePx) {
    const std::vector<PrunedEdge> pruned = pruneOpen(raw);
    straighten(raw, straight, distancePx);
    return finish(raw, pruned, lines, ink, distancePx);
}

std::vector<EdgeGraph> buildEdgeGraphs(const InkReading& ink, double distancePx,
                                       const ReadingOptions& options) {
    auto [lines, raw, price] = draftEdgeGraph(ink, distancePx, options);
    const std::vector<PrunedEdge> pruned = pruneOpen(raw);
    dissolveCertain(raw, distancePx);

    std::vector<EdgeGraph> graphs{finish(raw, pruned, lines, ink, distancePx)};
    std::size_t usual = 0;
    while (graphs.size() <= kMostBends) {
        const auto bend = leastBend(raw, distancePx);
        if (!bend) break;
        dissolveAt(raw, bend->vertex);
        if (bend->turnDeg < tol::kNearlyStraightDeg &&
            bend->bendPx < tol::kStraightBend * distancePx) {
            usual = graphs.size();
        }
        graphs.push_back(finish(raw, pruned, lines, ink, distancePx));
    }
    std::rotate(graphs.begin(), graphs.begin() + static_cast<std::ptrdiff_t>(usual),
                graphs.begin() + static_cast<std::ptrdiff_t>(usual) + 1);
    return graphs;
}

EdgeGraph buildEdgeGraph(const InkReading& ink, double distancePx, const ReadingOptions& options) {
    return buildEdgeGraphs(ink, distancePx, options).front();
}

}  // namespace ew
