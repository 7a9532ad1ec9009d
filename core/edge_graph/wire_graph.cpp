// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edge_graph/wire_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "core/edge_graph/line_ends.h"
#include "core/edge_graph/planarize.h"
#include "core/edge_graph/prune.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

RawGraph wiresBetween(const std::vector<InkLine>& lines, const std::vector<EndCluster>& clusters) {
    RawGraph raw;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const int line = static_cast<int>(i);
        raw.edges.push_back({{-1, -1}, {{line, 0.0, lines[i].length()}}, true});
    }
    for (const EndCluster& c : clusters) {
        for (const LineEnd& e : c.ends) {
            raw.edges[at(e.line)].v[at(e.side)] = static_cast<int>(raw.vertices.size());
        }
        raw.vertices.push_back(c.position);
    }
    return raw;
}

/// Where lines were drawn in pieces, one for each stretch that is seen or hidden, the ends of two
/// pieces look like a corner where they cross something, or meet with one that they only pass.
class Passings {
  public:
    /// What is certainly no corner is taken apart: two lines that cross.
    static void takeApart(RawGraph& raw) {
        const auto incidence = raw.incidence();
        for (std::size_t v = 0; v < incidence.size(); ++v) {
            if (incidence[v].size() != 4) continue;
            const int vertex = static_cast<int>(v);
            for (const Pair& p : straightPairs(raw, vertex, incidence[v])) {
                std::vector<int> others;
                for (const int e : incidence[v]) {
                    if (e != p[0] && e != p[1]) others.push_back(e);
                }
                if (!isStraight(raw, vertex, others[0], others[1])) continue;
                move(raw, vertex, p);
                break;
            }
        }
    }

    /// The graph as it is, then with one line more that passes a corner; a few.
    static std::vector<RawGraph> variants(const RawGraph& raw) {
        std::vector<RawGraph> out{raw};
        for (std::size_t k = 0; k < out.size() && out.size() < kMostVariants; ++k) {
            const auto incidence = out[k].incidence();
            for (std::size_t v = 0; v < incidence.size(); ++v) {
                // A corner of three, and a line.
                if (incidence[v].size() < 5) continue;
                const int vertex = static_cast<int>(v);
                for (const Pair& p : straightPairs(out[k], vertex, incidence[v])) {
                    if (out.size() == kMostVariants) return out;
                    RawGraph passed = out[k];
                    move(passed, vertex, p);
                    out.push_back(std::move(passed));
                }
            }
        }
        return out;
    }

  private:
    using Pair = std::array<int, 2>;
    static constexpr double kStraight = 8.0 * std::numbers::pi / 180.0;
    static constexpr std::size_t kMostVariants = 6;

    static Vec2 leaving(const RawGraph& raw, int vertex, int edge) {
        const RawGraph::Edge& e = raw.edges[at(edge)];
        const Vec2 d = raw.vertices[at(e.v[1])] - raw.vertices[at(e.v[0])];
        return e.v[0] == vertex ? d : Vec2(-d);
    }

    static bool isStraight(const RawGraph& raw, int vertex, int a, int b) {
        const Vec2 in = -leaving(raw, vertex, a);
        const Vec2 out = leaving(raw, vertex, b);
        return std::abs(std::atan2(cross2(in, out), in.dot(out))) < kStraight;
    }

    static std::vector<Pair> straightPairs(const RawGraph& raw, int vertex,
                                           const std::vector<int>& edges) {
        std::vector<Pair> out;
        for (std::size_t i = 0; i < edges.size(); ++i) {
            for (std::size_t j = i + 1; j < edges.size(); ++j) {
                if (isStraight(raw, vertex, edges[i], edges[j]))
                    out.push_back({edges[i], edges[j]});
            }
        }
        return out;
    }

    /// Gives two edges a vertex of their own.
    static void move(RawGraph& raw, int vertex, const Pair& edges) {
        const int fresh = static_cast<int>(raw.vertices.size());
        raw.vertices.push_back(Vec2(raw.vertices[at(vertex)]));
        for (const int e : edges) {
            for (int& end : raw.edges[at(e)].v) {
                if (end == vertex) end = fresh;
            }
        }
    }
};

/// Lines that others cover.
class Covered {
  public:
    Covered(EdgeGraph graph, double nearPx) : graph_(std::move(graph)), near_(nearPx) {}

    /// Has every corner three lines?
    static bool isWhole(const EdgeGraph& graph) { return bareCorners(graph).empty(); }

    /// The graph with one more line at every corner that has only two.
    std::vector<EdgeGraph> all() {
        const std::vector<int> bare = bareCorners(graph_);
        if (bare.empty() || bare.size() > kMostBare) return {graph_};
        extend(graph_);
        return std::move(found_);
    }

  private:
    static constexpr std::size_t kMostBare = 6;
    static constexpr std::size_t kMostFound = 4;

    static std::vector<int> bareCorners(const EdgeGraph& graph) {
        std::vector<int> degree(graph.junctions.size(), 0);
        for (const GraphEdge& e : graph.edges) {
            ++degree[at(e.ends[0])];
            ++degree[at(e.ends[1])];
        }
        std::vector<int> out;
        for (std::size_t v = 0; v < degree.size(); ++v) {
            if (degree[v] == 2) out.push_back(static_cast<int>(v));
        }
        return out;
    }

    void extend(const EdgeGraph& graph) {
        if (found_.size() == kMostFound) return;
        const std::vector<int> bare = bareCorners(graph);
        if (bare.empty()) {
            found_.push_back(graph);
            return;
        }
        // Two corners that both lack a line have the same one.
        std::vector<EdgeGraph> next;
        for (const bool toBare : {true, false}) {
            for (std::size_t w = 0; w < graph.junctions.size(); ++w) {
                const int to = static_cast<int>(w);
                const bool isBare = std::find(bare.begin(), bare.end(), to) != bare.end();
                if (isBare != toBare || to == bare.front()) continue;
                if (auto edge = coveredEdge(graph, bare.front(), to)) {
                    next.push_back(graph);
                    next.back().edges.push_back(*std::move(edge));
                }
            }
            if (!next.empty()) break;
        }
        for (const EdgeGraph& g : next) extend(g);
    }

    /// The line from one corner to another, if others cover it.
    std::optional<GraphEdge> coveredEdge(const EdgeGraph& graph, int from, int to) const {
        const Vec2& a = graph.junctions[at(from)].position;
        const Vec2& b = graph.junctions[at(to)].position;
        GraphEdge out;
        out.ends = {from, to};
        out.tips = {a, b};
        constexpr double kStepPx = 4.0;
        const int steps = 2 + static_cast<int>((b - a).norm() / kStepPx);
        const bool known =
            std::any_of(graph.edges.begin(), graph.edges.end(), [&](const GraphEdge& e) {
                return std::minmax(e.ends[0], e.ends[1]) == std::minmax(from, to);
            });
        if (known) return std::nullopt;
        for (int k = 1; k < steps; ++k) {
            const Vec2 p = a + (b - a) * k / steps;
            const auto cover =
                std::find_if(graph.edges.begin(), graph.edges.end(), [&](const GraphEdge& e) {
                    return runsAlong(graph, e, b - a) &&
                           distanceToSegment(p, graph.junctions[at(e.ends[0])].position,
                                             graph.junctions[at(e.ends[1])].position,
                                             near_) < near_;
                });
            if (cover == graph.edges.end()) return std::nullopt;
            out.strokes.insert(out.strokes.end(), cover->strokes.begin(), cover->strokes.end());
        }
        std::sort(out.strokes.begin(), out.strokes.end());
        out.strokes.erase(std::unique(out.strokes.begin(), out.strokes.end()), out.strokes.end());
        out.inkPx = (b - a).norm();
        return out;
    }

    static bool runsAlong(const EdgeGraph& graph, const GraphEdge& e, const Vec2& direction) {
        constexpr double kAlong = 0.2;  // sine
        const Vec2 d =
            graph.junctions[at(e.ends[1])].position - graph.junctions[at(e.ends[0])].position;
        return std::abs(cross2(d, direction)) < kAlong * d.norm() * direction.norm();
    }

    EdgeGraph graph_;
    double near_;
    std::vector<EdgeGraph> found_;
};

std::vector<EdgeGraph> wireGraphsOf(const InkReading& ink, const std::vector<InkLine>& lines,
                                    double distancePx) {
    JoinOptions join;
    join.distancePx = distancePx;
    RawGraph raw = wiresBetween(lines, joinEnds(lines, join));
    Passings::takeApart(raw);
    std::vector<EdgeGraph> out;
    for (RawGraph& variant : Passings::variants(raw)) {
        // Corners have three edges or more, so what only bends a little is one line.
        std::vector<int> straight;
        for (const Bend& b : doubtfulBends(variant, distancePx)) straight.push_back(b.vertex);
        out.push_back(settleEdgeGraph(ink, lines, std::move(variant), straight, distancePx));
    }
    return out;
}

/// Do two lines cross at least so far from all their ends?
bool cross(const InkLine& a, const InkLine& b, double clearPx) {
    constexpr double kLeastSine = 0.17;
    const Vec2 d = a.b - a.a;
    const Vec2 e = b.b - b.a;
    const double det = cross2(d, e);
    if (std::abs(det) < kLeastSine * d.norm() * e.norm()) return false;
    const Vec2 between = b.a - a.a;
    const double s = cross2(between, e) / det;
    const double t = cross2(between, d) / det;
    return std::min(s, 1.0 - s) * d.norm() >= clearPx && std::min(t, 1.0 - t) * e.norm() >= clearPx;
}

}  // namespace

bool crossesLikeWires(const InkReading& ink, double distancePx) {
    constexpr std::size_t kFewest = 3;
    constexpr std::size_t kLinesACrossing = 6;
    constexpr double kClear = 1.5;  // distance thresholds
    const std::vector<InkLine> lines = consolidate(ink.segments, {distancePx});
    std::size_t crossings = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            crossings += cross(lines[i], lines[k], kClear * distancePx) ? 1U : 0U;
        }
    }
    return crossings >= std::max(kFewest, lines.size() / kLinesACrossing);
}

std::vector<EdgeGraph> buildWireGraphs(const InkReading& ink, double distancePx) {
    // Each line as it was drawn, then those that lie on one another as one.
    constexpr double kAsDrawn = 0.05;
    const std::vector<InkLine> drawn = consolidate(ink.segments, {distancePx, kAsDrawn});
    const std::vector<InkLine> lines = consolidate(ink.segments, {distancePx});
    std::vector<EdgeGraph> out;
    if (drawn.size() > lines.size()) {
        for (EdgeGraph& g : wireGraphsOf(ink, drawn, distancePx)) {
            if (Covered::isWhole(g)) out.push_back(std::move(g));
        }
    }
    for (EdgeGraph& g : wireGraphsOf(ink, lines, distancePx)) {
        for (EdgeGraph& whole : Covered(std::move(g), distancePx).all()) {
            out.push_back(std::move(whole));
        }
    }
    constexpr std::size_t kMost = 8;
    if (out.size() > kMost) out.resize(kMost);
    return out;
}

}  // namespace ew
