// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edge_graph/prune.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

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

/// Takes vertices out of a graph one at a time and keeps the incidence up to date; of what can be
/// done, doubled edges come first, then vertices in ascending order.
class Dissolver {
  public:
    explicit Dissolver(RawGraph& graph) : graph_(graph), around_(graph.incidence()) {
        for (std::size_t v = 0; v < around_.size(); ++v) {
            maybeDoubled_.insert(maybeDoubled_.end(), static_cast<int>(v));
        }
        maybeStraight_ = maybeDoubled_;
    }

    /// Everything that is certainly no corner.
    void certain(double distancePx) {
        do {
            doubles();
        } while (nextStraight(distancePx));
    }

    /// One vertex of degree 2.
    void at(int v) {
        unite(v);
        doubles();
    }

    const std::vector<int>& around(int v) const { return around_[index(v)]; }

  private:
    static std::size_t index(int i) { return static_cast<std::size_t>(i); }
    RawGraph::Edge& edge(int e) { return graph_.edges[index(e)]; }

    void doubles() {
        while (!maybeDoubled_.empty()) {
            const int v = *maybeDoubled_.begin();
            if (!uniteDoubleAt(v)) maybeDoubled_.erase(v);
        }
    }

    bool uniteDoubleAt(int v) {
        const std::vector<int>& list = around_[index(v)];
        for (std::size_t i = 0; i < list.size(); ++i) {
            for (std::size_t j = i + 1; j < list.size(); ++j) {
                const int gone = list[j];
                RawGraph::Edge& a = edge(list[i]);
                RawGraph::Edge& b = edge(gone);
                const int w = otherEnd(a, v);
                if (w != otherEnd(b, v)) continue;
                if (a.v[0] != b.v[0]) reverse(b);
                a.pieces.insert(a.pieces.end(), b.pieces.begin(), b.pieces.end());
                b.alive = false;
                std::erase(around_[index(v)], gone);
                std::erase(around_[index(w)], gone);
                maybeStraight_.insert({v, w});
                return true;
            }
        }
        return false;
    }

    bool nextStraight(double distancePx) {
        while (!maybeStraight_.empty()) {
            const int v = *maybeStraight_.begin();
            if (surelyStraight(v, distancePx)) {
                unite(v);
                return true;
            }
            maybeStraight_.erase(v);
        }
        return false;
    }

    bool surelyStraight(int v, double distancePx) {
        const std::vector<int>& list = around_[index(v)];
        if (list.size() != 2) return false;
        const RawGraph::Edge& a = edge(list[0]);
        const RawGraph::Edge& b = edge(list[1]);
        if (otherEnd(a, v) == otherEnd(b, v)) return false;
        const Bend bend = bendAt(graph_, v, a, b);
        const bool slight =
            bend.turnDeg < tol::kStraightDeg && bend.bendPx < tol::kSurelyStraightBend * distancePx;
        return oneLine(a, b) || slight;
    }

    /// Makes one edge of the two that meet in v.
    void unite(int v) {
        const int kept = around_[index(v)][0];
        const int gone = around_[index(v)][1];
        RawGraph::Edge& a = edge(kept);
        RawGraph::Edge& b = edge(gone);
        if (a.v[1] != v) reverse(a);
        if (b.v[0] != v) reverse(b);
        a.v[1] = b.v[1];
        a.pieces.insert(a.pieces.end(), b.pieces.begin(), b.pieces.end());
        b.alive = false;
        around_[index(v)].clear();
        std::vector<int>& end = around_[index(a.v[1])];
        std::replace(end.begin(), end.end(), gone, kept);
        std::sort(end.begin(), end.end());
        maybeDoubled_.insert({a.v[0], a.v[1]});
        maybeStraight_.insert({a.v[0], a.v[1]});
    }

    RawGraph& graph_;
    std::vector<std::vector<int>> around_;        ///< living edges at every vertex, ascending
    std::set<int> maybeDoubled_, maybeStraight_;  ///< vertices that have to be looked at
};

}  // namespace

void dissolveCertain(RawGraph& graph, double distancePx) { Dissolver(graph).certain(distancePx); }

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

void dissolveAt(RawGraph& graph, int vertex) { Dissolver(graph).at(vertex); }

void straighten(RawGraph& graph, const std::vector<int>& vertices, double distancePx) {
    dissolveCertain(graph, distancePx);
    for (const int v : vertices) {
        Dissolver dissolver(graph);
        const auto& around = dissolver.around(v);
        if (around.size() != 2) continue;
        if (otherEnd(graph.edges[at(around[0])], v) == otherEnd(graph.edges[at(around[1])], v)) {
            continue;
        }
        dissolver.at(v);
    }
    dissolveCertain(graph, distancePx);
}

}  // namespace ew
