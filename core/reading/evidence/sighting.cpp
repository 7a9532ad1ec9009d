// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/evidence/sighting.h"

#include <algorithm>
#include <cmath>

#include "core/base/tolerance.h"

namespace ew {
namespace {
std::size_t at(int i) { return static_cast<std::size_t>(i); }
}  // namespace

Sighting sightingOf(const EdgeGraph& graph, const GraphMatch& match, double distancePx) {
    Sighting s;
    const std::size_t n = match.entry->tmpl.shape.vertices.size();
    s.vertexPx.assign(n, Vec2::Zero());
    s.seen.assign(n, false);
    s.acrossPx = tol::kEndSpreadAcross * distancePx;
    s.alongPx = tol::kEndSpreadAlong * distancePx;
    Eigen::AlignedBox2d box;
    for (std::size_t j = 0; j < graph.junctions.size(); ++j) {
        box.extend(graph.junctions[j].position);
        const int v = match.vertex[j];
        if (v < 0) continue;
        s.vertexPx[at(v)] = graph.junctions[j].position;
        s.seen[at(v)] = true;
    }
    s.sizePx = std::max(1.0, box.diagonal().norm());
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
        DrawnEdge d;
        d.edge = match.edge[e];
        d.tips = graph.edges[e].tips;
        d.penEnd = graph.edges[e].penEnd;
        const auto& ends = match.entry->analysis.edges[at(d.edge)].ends;
        for (std::size_t side = 0; side < 2; ++side) {
            // Where an edge disappears behind a corner it has no end of its own.
            const int v = match.vertex[at(graph.edges[e].ends[side])];
            d.vertex[side] = v == ends[0] || v == ends[1] ? v : -1;
        }
        s.edges.push_back(d);
    }
    s.visibleFaces = match.aspect->visibleFaces;
    return s;
}

double stopWeight(const Sighting& sighting) {
    constexpr double kLeast = 0.03;
    return std::max(kLeast, sighting.doubt);
}

double residualPx(const Sighting& sighting, const TemplateAnalysis& analysis,
                  const CameraPoints& points) {
    double sum = 0;
    for (const DrawnEdge& d : sighting.edges) {
        const auto& ends = analysis.edges[at(d.edge)].ends;
        const Vec2 a = points[at(ends[0])].head<2>();
        const Vec2 u = points[at(ends[1])].head<2>() - a;
        const double len = u.norm();
        for (const Vec2& tip : d.tips) {
            const double off = len > 1e-9 ? cross2(u, tip - a) / len : (tip - a).norm();
            sum += off * off;
        }
    }
    return std::sqrt(sum / static_cast<double>(2 * sighting.edges.size()));
}

bool facesLookRight(const Template& tmpl, const Sighting& sighting, const CameraPoints& points,
                    bool& mirrored) {
    double volume = 0;
    std::vector<double> facing;
    std::vector<double> span;  // longest projected edge
    for (const auto& loop : tmpl.shape.faces) {
        double projected = 0;  // twice the signed area on the screen
        const Vec3& a = points[at(loop[0])];
        for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
            const Vec3& b = points[at(loop[i])];
            const Vec3& c = points[at(loop[i + 1])];
            volume += a.dot(b.cross(c));
            projected += (b - a).cross(c - a).z();
        }
        facing.push_back(projected);
        double longest = 0;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec3 e = points[at(loop[(i + 1) % loop.size()])] - points[at(loop[i])];
            longest = std::max(longest, e.head<2>().norm());
        }
        span.push_back(longest);
    }
    mirrored = volume < 0;
    const double sign = mirrored ? -1.0 : 1.0;
    std::vector<bool> visible(facing.size(), false);
    for (const int f : sighting.visibleFaces) visible[at(f)] = true;
    const double small = 1e-9 * sighting.sizePx * sighting.sizePx;
    for (std::size_t f = 0; f < facing.size(); ++f) {
        // An outward normal towards the eye has negative z. A hidden face may come out as a sliver
        // that a hand would not have drawn.
        const double value = sign * facing[f];
        const double sliver = 2 * tol::kSliverSpreads * sighting.acrossPx * span[f];
        if (visible[f] ? value > -small : value < -sliver) return false;
    }
    return true;
}

}  // namespace ew
