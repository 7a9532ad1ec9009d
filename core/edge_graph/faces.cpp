// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edge_graph/faces.h"

#include <algorithm>
#include <cmath>

namespace ew {
namespace {
std::size_t at(int i) { return static_cast<std::size_t>(i); }
}  // namespace

RotationSystem rotationOf(const PlaneGraph& graph) {
    RotationSystem r;
    const std::size_t m = graph.edges.size();
    r.origin.resize(2 * m);
    r.next.assign(2 * m, -1);
    r.prev.assign(2 * m, -1);
    r.degree.assign(graph.points.size(), 0);
    std::vector<std::vector<std::pair<double, int>>> around(graph.points.size());
    for (std::size_t e = 0; e < m; ++e) {
        const Vec2 d = graph.points[at(graph.edges[e][1])] - graph.points[at(graph.edges[e][0])];
        const int i = static_cast<int>(2 * e);
        r.origin[2 * e] = graph.edges[e][0];
        r.origin[2 * e + 1] = graph.edges[e][1];
        around[at(graph.edges[e][0])].emplace_back(std::atan2(d.y(), d.x()), i);
        around[at(graph.edges[e][1])].emplace_back(std::atan2(-d.y(), -d.x()), i + 1);
    }
    for (std::size_t v = 0; v < around.size(); ++v) {
        auto& list = around[v];
        // y is down, so growing angles run clockwise on the screen.
        std::sort(list.begin(), list.end());
        r.degree[v] = static_cast<int>(list.size());
        for (std::size_t i = 0; i < list.size(); ++i) {
            const int d = list[i].second;
            const int n = list[(i + 1) % list.size()].second;
            r.next[at(d)] = n;
            r.prev[at(n)] = d;
        }
    }
    return r;
}

std::vector<PlaneFace> facesOf(const PlaneGraph& graph, const RotationSystem& rotation) {
    std::vector<PlaneFace> faces;
    std::vector<bool> seen(rotation.origin.size(), false);
    for (int start = 0; start < rotation.directedCount(); ++start) {
        if (seen[at(start)]) continue;
        PlaneFace face;
        for (int d = start; !seen[at(d)];) {
            seen[at(d)] = true;
            face.loop.push_back(d);
            face.area += 0.5 * cross2(graph.points[at(rotation.origin[at(d)])],
                                      graph.points[at(rotation.target(d))]);
            // Arriving at the target, turn to the neighbour of the way back.
            d = rotation.prev[at(RotationSystem::twin(d))];
        }
        faces.push_back(std::move(face));
    }
    return faces;
}

std::vector<bool> outerVertices(const PlaneGraph& graph) {
    std::vector<bool> outer(graph.points.size(), false);
    const RotationSystem rotation = rotationOf(graph);
    const std::vector<PlaneFace> faces = facesOf(graph, rotation);
    const auto widest = std::max_element(
        faces.begin(), faces.end(),
        [](const PlaneFace& a, const PlaneFace& b) { return std::abs(a.area) < std::abs(b.area); });
    if (widest == faces.end()) return outer;
    for (const int d : widest->loop) outer[at(rotation.origin[at(d)])] = true;
    return outer;
}

}  // namespace ew
