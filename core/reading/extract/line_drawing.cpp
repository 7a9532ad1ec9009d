// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/extract/line_drawing.h"

#include <algorithm>
#include <cmath>

#include "core/base/disjoint_sets.h"
#include "core/reading/extract/plane_geometry.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The stem of a T junction: the one line of three that is not part of a straight pair. Of several
/// pairs that may be one the straightest counts.
int stemOf(const LineDrawing& drawing, const LineDrawing::Node& node) {
    if (node.out.size() != 3) return -1;
    int stem = -1;
    double least = drawing.straightDeg;
    for (std::size_t k = 0; k < 3; ++k) {
        const double turn = angleBetweenDeg(-drawing.vector(node.out[(k + 1) % 3]),
                                            drawing.vector(node.out[(k + 2) % 3]));
        if (turn >= least) continue;
        least = turn;
        stem = node.out[k];
    }
    return stem;
}

void addRegion(LineDrawing& drawing, const PlaneFace& face) {
    LineDrawing::Region region;
    region.loop = face.loop;
    region.areaPx = std::abs(face.area);
    const std::size_t n = face.loop.size();
    for (std::size_t k = 0; k < n; ++k) {
        const int in = face.loop[k];
        const int out = face.loop[(k + 1) % n];
        if (drawing.straightThrough(in, out)) continue;
        const int node = drawing.to(in);
        region.corners.push_back(node);
        const int stem = drawing.nodes[at(node)].stem;
        if (stem >= 0 && (stem == out || stem == LineDrawing::twin(in))) region.partly = true;
    }
    const int id = static_cast<int>(drawing.regions.size());
    for (const int d : face.loop) drawing.left[at(d)] = id;
    drawing.regions.push_back(std::move(region));
}

/// The outline of a connected part becomes a hole of the smallest region of another one round it.
void addIsland(LineDrawing& drawing, DisjointSets& part, const std::vector<int>& loop) {
    const int node = drawing.from[at(loop.front())];
    int around = -1;
    for (std::size_t r = 0; r < drawing.regions.size(); ++r) {
        const LineDrawing::Region& region = drawing.regions[r];
        if (part.root(drawing.from[at(region.loop.front())]) == part.root(node)) continue;
        if (around >= 0 && region.areaPx >= drawing.regions[at(around)].areaPx) continue;
        if (insidePolygon(drawing.polygon(region.loop), drawing.nodes[at(node)].at)) {
            around = static_cast<int>(r);
        }
    }
    if (around < 0) return;
    for (const int d : loop) drawing.left[at(d)] = around;
    drawing.regions[at(around)].holes.push_back(loop);
}

}  // namespace

std::array<Vec2, 2> LineDrawing::bounds() const {
    Vec2 low = nodes.front().at;
    Vec2 high = low;
    for (const Node& n : nodes) {
        low = low.cwiseMin(n.at);
        high = high.cwiseMax(n.at);
    }
    return {low, high};
}

std::vector<Vec2> LineDrawing::polygon(const std::vector<int>& loop) const {
    std::vector<Vec2> out;
    for (const int d : loop) out.push_back(nodes[at(from[at(d)])].at);
    return out;
}

bool LineDrawing::straightThrough(int in, int out) const {
    return angleBetweenDeg(vector(in), vector(out)) < straightDeg;
}

LineDrawing lineDrawing(const EdgeGraph& graph, double straightDeg) {
    LineDrawing drawing;
    drawing.straightDeg = straightDeg;
    PlaneGraph plane;
    for (const Junction& j : graph.junctions) {
        plane.points.push_back(j.position);
        drawing.nodes.push_back({j.position, {}, -1});
    }
    for (const GraphEdge& e : graph.edges) plane.edges.push_back(e.ends);
    const RotationSystem rotation = rotationOf(plane);
    drawing.from = rotation.origin;
    drawing.left.assign(drawing.from.size(), -1);
    for (int d = 0; d < rotation.directedCount(); ++d) {
        LineDrawing::Node& node = drawing.nodes[at(rotation.origin[at(d)])];
        if (!node.out.empty()) continue;
        int next = d;
        do {
            node.out.push_back(next);
            next = rotation.next[at(next)];
        } while (next != d);
    }
    for (LineDrawing::Node& node : drawing.nodes) node.stem = stemOf(drawing, node);
    const std::vector<PlaneFace> faces = facesOf(plane, rotation);
    // Bounded regions run clockwise, outlines of connected parts the other way round.
    const PlaneFace* widest = nullptr;
    std::vector<const PlaneFace*> outlines;
    for (const PlaneFace& face : faces) {
        if (face.area > 0.0) {
            addRegion(drawing, face);
            continue;
        }
        outlines.push_back(&face);
        if (widest == nullptr || face.area < widest->area) widest = &face;
    }
    if (widest != nullptr) drawing.outline = widest->loop;
    DisjointSets part(drawing.nodes.size());
    for (const auto& e : plane.edges) part.join(e[0], e[1]);
    for (const PlaneFace* outline : outlines) addIsland(drawing, part, outline->loop);
    return drawing;
}

}  // namespace ew
