// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edge_graph/edit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/disjoint_sets.h"
#include "core/base/tolerance.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Vec2 position(const EdgeGraph& g, int j) { return g.junctions[at(j)].position; }

void makeStray(EdgeGraph& g, const GraphEdge& e) {
    for (const int stroke : e.strokes) {
        g.noise.push_back({NoiseKind::Stray, stroke, {e.tips[0], e.tips[1]}});
    }
}

std::vector<std::vector<int>> incidence(const EdgeGraph& g, const std::vector<bool>& alive) {
    std::vector<std::vector<int>> result(g.junctions.size());
    for (std::size_t e = 0; e < g.edges.size(); ++e) {
        if (!alive[e]) continue;
        for (const int j : g.edges[e].ends) result[at(j)].push_back(static_cast<int>(e));
    }
    return result;
}

/// Joins two edges at a junction where they go straight on; false where they do not.
bool uniteAt(EdgeGraph& g, std::vector<bool>& alive, int junction, int ea, int eb) {
    GraphEdge& a = g.edges[at(ea)];
    GraphEdge& b = g.edges[at(eb)];
    const std::size_t sa = a.ends[0] == junction ? 1 : 0;  // far side of a
    const std::size_t sb = b.ends[0] == junction ? 1 : 0;
    if (a.ends[sa] == b.ends[sb]) return false;
    const Vec2 u = position(g, junction) - position(g, a.ends[sa]);
    const Vec2 w = position(g, b.ends[sb]) - position(g, junction);
    const double turn = std::abs(std::atan2(cross2(u, w), u.dot(w))) * 180.0 / std::numbers::pi;
    if (turn > tol::kNearlyStraightDeg) return false;
    GraphEdge merged;
    merged.ends = {a.ends[sa], b.ends[sb]};
    merged.tips = {a.tips[sa], b.tips[sb]};
    merged.penEnd = {a.penEnd[sa], b.penEnd[sb]};
    merged.origin = a.origin;
    merged.inkPx = a.inkPx + b.inkPx;
    merged.wobblePx = std::max(a.wobblePx, b.wobblePx);
    std::set_union(a.strokes.begin(), a.strokes.end(), b.strokes.begin(), b.strokes.end(),
                   std::back_inserter(merged.strokes));
    a = std::move(merged);
    alive[at(eb)] = false;
    return true;
}

void compact(EdgeGraph& g, const std::vector<bool>& alive) {
    std::vector<int> number(g.junctions.size(), -1);
    std::vector<Junction> junctions;
    std::vector<GraphEdge> edges;
    for (std::size_t e = 0; e < g.edges.size(); ++e) {
        if (!alive[e]) continue;
        for (int& j : g.edges[e].ends) {
            if (number[at(j)] < 0) {
                number[at(j)] = static_cast<int>(junctions.size());
                junctions.push_back(g.junctions[at(j)]);
            }
            j = number[at(j)];
        }
        edges.push_back(std::move(g.edges[e]));
    }
    g.junctions = std::move(junctions);
    g.edges = std::move(edges);
    for (DanglingEdge& d : g.dangling) {
        if (d.junction >= 0) d.junction = number[at(d.junction)];
    }
}

}  // namespace

EdgeGraph withoutEdges(const EdgeGraph& graph, const std::vector<int>& edges) {
    EdgeGraph g = graph;
    std::vector<bool> alive(g.edges.size(), true);
    for (const int e : edges) {
        alive[at(e)] = false;
        makeStray(g, g.edges[at(e)]);
    }
    for (bool changed = true; changed;) {
        changed = false;
        const auto around = incidence(g, alive);
        for (std::size_t j = 0; j < around.size() && !changed; ++j) {
            if (around[j].size() == 1) {
                makeStray(g, g.edges[at(around[j][0])]);
                alive[at(around[j][0])] = false;
                changed = true;
            } else if (around[j].size() == 2) {
                changed = uniteAt(g, alive, static_cast<int>(j), around[j][0], around[j][1]);
            }
        }
    }
    compact(g, alive);
    return g;
}

std::vector<EdgeGraph> connectedParts(const EdgeGraph& graph) {
    DisjointSets part(graph.junctions.size());
    for (const GraphEdge& e : graph.edges) part.join(e.ends[0], e.ends[1]);
    std::vector<int> roots;
    for (int j = 0; j < static_cast<int>(graph.junctions.size()); ++j) {
        if (part.root(j) == j) roots.push_back(j);
    }
    if (roots.size() <= 1) return {graph};
    std::vector<EdgeGraph> parts;
    for (const int root : roots) {
        EdgeGraph g;
        g.junctions = graph.junctions;
        for (const GraphEdge& e : graph.edges) {
            if (part.root(e.ends[0]) == root) g.edges.push_back(e);
        }
        if (g.edges.empty()) continue;
        compact(g, std::vector<bool>(g.edges.size(), true));
        parts.push_back(std::move(g));
    }
    auto ink = [](const EdgeGraph& g) {
        double sum = 0;
        for (const GraphEdge& e : g.edges) sum += e.inkPx;
        return sum;
    };
    std::stable_sort(parts.begin(), parts.end(),
                     [&](const EdgeGraph& a, const EdgeGraph& b) { return ink(a) > ink(b); });
    if (!parts.empty()) {
        parts[0].noise = graph.noise;
        parts[0].dangling = graph.dangling;
        for (DanglingEdge& d : parts[0].dangling) d.junction = -1;
        parts[0].openEnds = graph.openEnds;
    }
    return parts;
}

EdgeGraph joinedParts(const std::vector<EdgeGraph>& parts) {
    EdgeGraph out;
    for (const EdgeGraph& part : parts) {
        const int first = static_cast<int>(out.junctions.size());
        out.junctions.insert(out.junctions.end(), part.junctions.begin(), part.junctions.end());
        for (GraphEdge e : part.edges) {
            for (int& j : e.ends) j += first;
            out.edges.push_back(std::move(e));
        }
        const int danglingFrom = static_cast<int>(out.dangling.size());
        for (DanglingEdge d : part.dangling) {
            if (d.junction >= 0) d.junction += first;
            out.dangling.push_back(std::move(d));
        }
        for (OpenEnd o : part.openEnds) {
            if (o.edge >= 0) o.edge += danglingFrom;
            out.openEnds.push_back(o);
        }
        out.noise.insert(out.noise.end(), part.noise.begin(), part.noise.end());
    }
    return out;
}

double graphExtent(const EdgeGraph& graph) {
    Eigen::AlignedBox2d box;
    for (const Junction& j : graph.junctions) box.extend(j.position);
    return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

bool isOneOutline(const EdgeGraph& graph) {
    std::vector<int> degree(graph.junctions.size(), 0);
    for (const GraphEdge& e : graph.edges) {
        for (const int j : e.ends) ++degree[static_cast<std::size_t>(j)];
    }
    return !graph.empty() &&
           std::none_of(degree.begin(), degree.end(), [](int d) { return d > 2; });
}

}  // namespace ew
