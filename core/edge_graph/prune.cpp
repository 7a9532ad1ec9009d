// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edge_graph/prune.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/tolerance.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

int otherEnd(const RawGraph::Edge& e, int v) { return e.v[0] == v ? e.v[1] : e.v[0]; }

void reverse(RawGraph::Edge& e) {
    std::swap(e.v[0], e.v[1]);
    std::reverse(e.pieces.begin(), e.pieces.end());
    for (LinePiece& p : e.pieces) std::swap(p.t0, p.t1);
}

/// Edges whose removal disconnects the graph (lowest reachable depth, iterative).
std::vector<int> bridges(const RawGraph& graph) {
    const auto incidence = graph.incidence();
    const std::size_t n = graph.vertices.size();
    std::vector<int> depth(n, -1);
    std::vector<int> low(n, 0);
    std::vector<int> result;
    struct Frame {
        int v;
        int via;
        std::size_t next;
    };
    for (std::size_t root = 0; root < n; ++root) {
        if (depth[root] >= 0) continue;
        depth[root] = low[root] = 0;
        std::vector<Frame> stack{{static_cast<int>(root), -1, 0}};
        while (!stack.empty()) {
            Frame& f = stack.back();
            if (f.next < incidence[at(f.v)].size()) {
                const int e = incidence[at(f.v)][f.next++];
                if (e == f.via) continue;
                const int w = otherEnd(graph.edges[at(e)], f.v);
                if (depth[at(w)] >= 0) {
                    low[at(f.v)] = std::min(low[at(f.v)], depth[at(w)]);
                } else {
                    depth[at(w)] = low[at(w)] = depth[at(f.v)] + 1;
                    stack.push_back({w, e, 0});
                }
            } else {
                const Frame done = f;
                stack.pop_back();
                if (done.via < 0) continue;
                const int parent = otherEnd(graph.edges[at(done.via)], done.v);
                low[at(parent)] = std::min(low[at(parent)], low[at(done.v)]);
                if (low[at(done.v)] > depth[at(parent)]) result.push_back(done.via);
            }
        }
    }
    return result;
}

}  // namespace

std::vector<PrunedEdge> pruneOpen(RawGraph& graph) {
    // A dangling tree consists of bridges, so one pass finds both.
    std::vector<PrunedEdge> pruned;
    for (const int e : bridges(graph)) {
        RawGraph::Edge& edge = graph.edges[at(e)];
        edge.alive = false;
        pruned.push_back({edge.v, edge.pieces, false, false});
    }
    const auto incidence = graph.incidence();
    for (PrunedEdge& p : pruned) {
        p.attachedAtFirst = !incidence[at(p.v[0])].empty();
        p.attachedAtSecond = !incidence[at(p.v[1])].empty();
    }
    return pruned;
}

namespace {

Bend bendAt(const RawGraph& graph, int v, const RawGraph::Edge& a, const RawGraph::Edge& b) {
    const Vec2 p = graph.vertices[at(v)];
    const Vec2 u = p - graph.vertices[at(otherEnd(a, v))];
    const Vec2 w = graph.vertices[at(otherEnd(b, v))] - p;
    const Vec2 chord = u + w;
    Bend bend;
    bend.vertex = v;
    bend.turnDeg = std::abs(std::atan2(cross2(u, w), u.dot(w))) * 180.0 / std::numbers::pi;
    bend.bendPx = chord.norm() < 1e-9 ? 0.0 : std::abs(cross2(chord.normalized(), u));
    return bend;
}

bool oneLine(const RawGraph::Edge& a, const RawGraph::Edge& b) {
    return a.pieces.size() == 1 && b.pieces.size() == 1 &&
           a.pieces.front().line == b.pieces.front().line;
}

void unite(RawGraph& graph, int v, int ea, int eb) {
    RawGraph::Edge& a = graph.edges[at(ea)];
    RawGraph::Edge& b = graph.edges[at(eb)];
    if (a.v[1] != v) reverse(a);
    if (b.v[0] != v) reverse(b);
    a.v[1] = b.v[1];
    a.pieces.insert(a.pieces.end(), b.pieces.begin(), b.pieces.end());
    b.alive = false;
}

bool uniteCertain(RawGraph& graph, double distancePx) {
    const auto incidence = graph.incidence();
    for (std::size_t v = 0; v < incidence.size(); ++v) {
        if (incidence[v].size() != 2) continue;
        const int vi = static_cast<int>(v);
        const RawGraph::Edge& a = graph.edges[at(incidence[v][0])];
        const RawGraph::Edge& b = graph.edges[at(incidence[v][1])];
        if (otherEnd(a, vi) == otherEnd(b, vi)) continue;
        const Bend bend = bendAt(graph, vi, a, b);
        const bool slight =
            bend.turnDeg < tol::kStraightDeg && bend.bendPx < tol::kSurelyStraightBend * distancePx;
        if (!oneLine(a, b) && !slight) continue;
        unite(graph, vi, incidence[v][0], incidence[v][1]);
        return true;
    }
    return false;
}

bool uniteDoubles(RawGraph& graph) {
    const auto incidence = graph.incidence();
    for (std::size_t v = 0; v < incidence.size(); ++v) {
        for (std::size_t i = 0; i < incidence[v].size(); ++i) {
            for (std::size_t j = i + 1; j < incidence[v].size(); ++j) {
                RawGraph::Edge& a = graph.edges[at(incidence[v][i])];
                RawGraph::Edge& b = graph.edges[at(incidence[v][j])];
                if (otherEnd(a, static_cast<int>(v)) != otherEnd(b, static_cast<int>(v))) continue;
                if (a.v[0] != b.v[0]) reverse(b);
                a.pieces.insert(a.pieces.end(), b.pieces.begin(), b.pieces.end());
                b.alive = false;
                return true;
            }
        }
    }
    return false;
}

}  // namespace

void dissolveCertain(RawGraph& graph, double distancePx) {
    while (uniteDoubles(graph) || uniteCertain(graph, distancePx)) {
    }
}

std::vector<Bend> doubtfulBends(const RawGraph& graph, double distancePx) {
    const auto incidence = graph.incidence();
    std::vector<Bend> bends;
    for (std::size_t v = 0; v < incidence.size(); ++v) {
        if (incidence[v].size() != 2) continue;
        const int vi = static_cast<int>(v);
        const RawGraph::Edge& a = graph.edges[at(incidence[v][0])];
        const RawGraph::Edge& b = graph.edges[at(incidence[v][1])];
        if (otherEnd(a, vi) == otherEnd(b, vi)) continue;
        const Bend bend = bendAt(graph, vi, a, b);
        if (bend.turnDeg <= tol::kBrokenTurnDeg && bend.bendPx <= tol::kBrokenBend * distancePx) {
            bends.push_back(bend);
        }
    }
    return bends;
}

std::optional<Bend> leastBend(const RawGraph& graph, double distancePx) {
    const std::vector<Bend> bends = doubtfulBends(graph, distancePx);
    const auto least =
        std::min_element(bends.begin(), bends.end(),
                         [](const Bend& a, const Bend& b) { return a.bendPx < b.bendPx; });
    return least == bends.end() ? std::nullopt : std::optional<Bend>(*least);
}

void dissolveAt(RawGraph& graph, int vertex) {
    const auto incidence = graph.incidence();
    unite(graph, vertex, incidence[at(vertex)][0], incidence[at(vertex)][1]);
    while (uniteDoubles(graph)) {
    }
}

void straighten(RawGraph& graph, const std::vector<int>& vertices, double distancePx) {
    dissolveCertain(graph, distancePx);
    for (const int v : vertices) {
        const auto incidence = graph.incidence();
        const auto& around = incidence[at(v)];
        if (around.size() != 2) continue;
        if (otherEnd(graph.edges[at(around[0])], v) == otherEnd(graph.edges[at(around[1])], v)) {
            continue;
        }
        dissolveAt(graph, v);
    }
    dissolveCertain(graph, distancePx);
}

}  // namespace ew
