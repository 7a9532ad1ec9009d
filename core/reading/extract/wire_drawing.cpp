// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/extract/wire_drawing.h"

#include <algorithm>
#include <array>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boyer_myrvold_planar_test.hpp>
#include <set>
#include <utility>
#include <vector>

#include "core/base/disjoint_sets.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Do all wires hang together without these two corners?
bool hangTogether(const LineDrawing& wires, int without, int withoutToo) {
    DisjointSets part(wires.nodes.size());
    for (std::size_t d = 0; d < wires.from.size(); d += 2) {
        const int a = wires.from[d];
        const int b = wires.from[d + 1];
        const auto gone = [&](int v) { return v == without || v == withoutToo; };
        if (!gone(a) && !gone(b)) part.join(a, b);
    }
    int first = -1;
    for (std::size_t v = 0; v < wires.nodes.size(); ++v) {
        const int node = static_cast<int>(v);
        if (wires.nodes[v].out.empty() || node == without || node == withoutToo) continue;
        if (first < 0) first = node;
        if (part.root(first) != part.root(node)) return false;
    }
    return true;
}

bool isThreeConnected(const LineDrawing& wires) {
    std::vector<int> corners;
    for (std::size_t v = 0; v < wires.nodes.size(); ++v) {
        if (!wires.nodes[v].out.empty()) corners.push_back(static_cast<int>(v));
    }
    constexpr std::size_t kFewest = 4;
    constexpr std::size_t kMost = 80;
    if (corners.size() < kFewest || corners.size() > kMost) return false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        for (std::size_t j = i + 1; j < corners.size(); ++j) {
            if (!hangTogether(wires, corners[i], corners[j])) return false;
        }
    }
    return true;
}

/// Puts the lines of every node into the order of a planar embedding, if there is one.
bool embed(LineDrawing& wires) {
    using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS,
                                        boost::property<boost::vertex_index_t, int>,
                                        boost::property<boost::edge_index_t, int>>;
    using Edge = boost::graph_traits<Graph>::edge_descriptor;
    Graph graph(wires.nodes.size());
    for (std::size_t d = 0; d < wires.from.size(); d += 2) {
        boost::add_edge(at(wires.from[d]), at(wires.from[d + 1]), static_cast<int>(d / 2), graph);
    }
    std::vector<std::vector<Edge>> order(wires.nodes.size());
    const bool planar =
        boost::boyer_myrvold_planarity_test(boost::boyer_myrvold_params::graph = graph,
                                            boost::boyer_myrvold_params::embedding = order.data());
    if (!planar) return false;
    for (std::size_t v = 0; v < order.size(); ++v) {
        std::vector<int> out;
        for (const Edge& e : order[v]) {
            const int wire = 2 * boost::get(boost::edge_index, graph, e);
            out.push_back(wires.from[at(wire)] == static_cast<int>(v) ? wire : wire + 1);
        }
        wires.nodes[v].out = std::move(out);
    }
    return true;
}

void addFaces(LineDrawing& wires) {
    for (std::size_t start = 0; start < wires.from.size(); ++start) {
        if (wires.left[start] >= 0) continue;
        LineDrawing::Region face;
        for (int d = static_cast<int>(start); wires.left[at(d)] < 0;) {
            wires.left[at(d)] = static_cast<int>(wires.regions.size());
            face.loop.push_back(d);
            const auto& out = wires.nodes[at(wires.to(d))].out;
            const auto back = std::find(out.begin(), out.end(), LineDrawing::twin(d));
            d = back + 1 == out.end() ? out.front() : *(back + 1);
        }
        for (const int d : face.loop) face.corners.push_back(wires.to(d));
        double area = 0.0;
        for (const int d : face.loop) {
            area += 0.5 *
                    cross2(wires.nodes[at(wires.from[at(d)])].at, wires.nodes[at(wires.to(d))].at);
        }
        face.areaPx = std::abs(area);
        wires.regions.push_back(std::move(face));
    }
}

}  // namespace

std::optional<LineDrawing> wireDrawing(const EdgeGraph& graph) {
    LineDrawing wires;
    for (const Junction& j : graph.junctions) wires.nodes.push_back({j.position, {}, -1});
    std::set<std::pair<int, int>> known;
    for (const GraphEdge& e : graph.edges) {
        if (!known.insert(std::minmax(e.ends[0], e.ends[1])).second) return std::nullopt;
        for (const int end : e.ends) {
            wires.nodes[at(end)].out.push_back(static_cast<int>(wires.from.size()));
            wires.from.push_back(end);
        }
    }
    const bool whole = std::all_of(wires.nodes.begin(), wires.nodes.end(),
                                   [](const LineDrawing::Node& n) { return n.out.size() >= 3; });
    if (!whole || wires.from.empty()) return std::nullopt;
    wires.left.assign(wires.from.size(), -1);
    if (isThreeConnected(wires) && embed(wires)) addFaces(wires);
    return wires;
}

}  // namespace ew
