// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/operand.h"

#include <algorithm>

namespace ew {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

std::uint64_t pairKey(int a, int b) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(std::min(a, b))) << 32U) |
           static_cast<std::uint32_t>(std::max(a, b));
}

/// The ray upwards from p, moved by (e, e^2) to the side so that it meets no edge: does it run
/// through the outline (seen from above, in x and y)? The same for both faces of an edge.
bool inOutline(const FaceLoops& loops, const PointView& p, const Operand& solid) {
    bool inside = false;
    for (const std::vector<int>& loop : loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const PointView a = solid.point(loop[i]);
            const PointView b = solid.point(loop[(i + 1) % loop.size()]);
            const bool aAbove = compare(a, p, 1) > 0;
            const bool bAbove = compare(b, p, 1) > 0;
            if (aAbove == bAbove) continue;
            if (a.r.x() < p.r.x() && b.r.x() < p.r.x()) continue;
            const int turn = orient2(a, b, p, 0, 1);
            if (bAbove ? turn > 0 : turn < 0) inside = !inside;
        }
    }
    return inside;
}

/// \pre the plane is not upright, the point not on it.
bool isAbove(const RPlane& plane, const PointView& p) {
    return sideOf(plane, p) * sgn(plane.normal[2]) < 0;
}

}  // namespace

Operand::Operand(const Solid::Impl& solid, const Box3& reach)
    : solid_(solid), reach_(reach), near_(solid.faces.size(), false) {
    faceBoxes_.reserve(solid.faces.size());
    std::size_t t = 0;
    for (std::size_t f = 0; f < solid.faces.size(); ++f) {
        Box3 box;
        for (const int v : solid.faces[f].loops[0]) box.extend(solid.vertices[idx(v)]);
        faceBoxes_.push_back(box);
        near_[f] = reach.intersects(box);
        while (t < solid.triangles.size() && solid.triangles[t].face < static_cast<int>(f)) ++t;
        if (!near_[f]) continue;
        if (solid.planes[f]) {
            addFacet(static_cast<int>(f), solid.faces[f].loops, true);
            continue;
        }
        for (std::size_t k = t;
             k < solid.triangles.size() && solid.triangles[k].face == static_cast<int>(f); ++k) {
            const auto& [a, b, c] = solid.triangles[k].vertices;
            triangles_.push_back({{a, b, c}});
            addFacet(static_cast<int>(f), triangles_.back(), false);
        }
    }
    listEdges();
}

void Operand::addFacet(int face, const FaceLoops& loops, bool whole) {
    Facet facet;
    facet.face = face;
    facet.loops = &loops;
    facet.whole = whole;
    for (const int v : loops[0]) facet.box.extend(solid_.vertices[idx(v)]);
    if (whole) {
        facet.plane = solid_.planes[idx(face)];
        facet.sign = facet.plane->n.dot(solid_.faces[idx(face)].normal) > 0.0 ? 1 : -1;
    } else {
        std::vector<PointView> corners;
        for (const int v : loops[0]) corners.push_back(point(v));
        const auto plane = planeOfLoop(corners, facet.sign);
        if (!plane) return;  // a valid solid has no such triangle
        facet.plane = std::make_shared<const RPlane>(*plane);
    }
    const int index = static_cast<int>(facets_.size());
    for (const std::vector<int>& loop : loops) {
        for (const int v : loop) {
            if (!reach_.contains(solid_.vertices[idx(v)])) continue;
            auto& list = facetsAt_[v];
            if (list.empty() || list.back() != index) list.push_back(index);
        }
    }
    facets_.push_back(std::move(facet));
}

void Operand::listEdges() {
    for (std::size_t f = 0; f < facets_.size(); ++f) {
        for (const std::vector<int>& loop : *facets_[f].loops) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const int a = loop[i];
                const int b = loop[(i + 1) % loop.size()];
                Box3 box;
                box.extend(solid_.vertices[idx(a)]);
                box.extend(solid_.vertices[idx(b)]);
                if (!reach_.intersects(box)) continue;
                const auto [it, fresh] =
                    edgeAt_.emplace(pairKey(a, b), static_cast<int>(edges_.size()));
                if (!fresh) {
                    edges_[idx(it->second)].facets[1] = static_cast<int>(f);
                    continue;
                }
                OperandEdge edge;
                edge.ends = {a, b};
                edge.facets = {static_cast<int>(f), -1};
                edge.box = box;
                edges_.push_back(edge);
            }
        }
    }
    for (OperandEdge& e : edges_) {
        const Facet& left = facets_[idx(e.facets[0])];
        const Facet& right = facets_[idx(e.facets[1])];
        const RVec fold = cross(left.plane->normal, right.plane->normal);
        const RVec along = minus(point(e.ends[1]), point(e.ends[0]));
        e.convex = sgn(dot(fold, along)) * left.sign * right.sign >= 0;
    }
}

int Operand::edgeBetween(int a, int b) const {
    const auto it = edgeAt_.find(pairKey(a, b));
    return it == edgeAt_.end() ? -1 : it->second;
}

const std::vector<int>& Operand::facetsAt(int vertex) const {
    static const std::vector<int> kNone;
    const auto it = facetsAt_.find(vertex);
    return it == facetsAt_.end() ? kNone : it->second;
}

std::vector<int> Operand::facetsOf(const Spot& spot) const {
    switch (spot.kind) {
        case Spot::Kind::Facet:
            return {spot.index};
        case Spot::Kind::Edge: {
            const auto& [f, g] = edges_[idx(spot.index)].facets;
            return {f, g};
        }
        case Spot::Kind::Vertex:
            return facetsAt(spot.index);
        default:
            return {};
    }
}

Spot Operand::inFacet(int index, const PointView& p) const {
    const Facet& facet = facets_[idx(index)];
    const InFace at =
        locateInLoops(*facet.loops, facet.plane->axis, p, [this](int v) { return point(v); });
    switch (at.where) {
        case InFace::Where::AtCorner:
            return {Spot::Kind::Vertex, at.a};
        case InFace::Where::OnSide:
            return {Spot::Kind::Edge, edgeBetween(at.a, at.b)};
        case InFace::Where::Inside:
            return {Spot::Kind::Facet, index};
        default:
            return {};
    }
}

Spot Operand::onSurface(const PointView& p) const {
    for (std::size_t f = 0; f < facets_.size(); ++f) {
        if (!facets_[f].box.contains(p.r) || sideOf(*facets_[f].plane, p) != 0) continue;
        const Spot spot = inFacet(static_cast<int>(f), p);
        if (spot.onSurface()) return spot;
    }
    return {};
}

Spot Operand::locate(const PointView& p) const {
    const Spot spot = onSurface(p);
    if (spot.onSurface()) return spot;
    return {isInside(p) ? Spot::Kind::Inside : Spot::Kind::Outside, -1};
}

bool Operand::isInside(const PointView& p) const {
    bool inside = false;
    std::size_t t = 0;
    for (std::size_t f = 0; f < faceBoxes_.size(); ++f) {
        const Box3& box = faceBoxes_[f];
        if (box.max().z() < p.r.z() || box.min().x() > p.r.x() || box.max().x() < p.r.x() ||
            box.min().y() > p.r.y() || box.max().y() < p.r.y()) {
            continue;
        }
        const bool above = box.min().z() > p.r.z();
        if (solid_.planes[f]) {
            inside ^= inOutline(solid_.faces[f].loops, p, *this) &&
                      (above || isAbove(*solid_.planes[f], p));
            continue;
        }
        while (t < solid_.triangles.size() && solid_.triangles[t].face < static_cast<int>(f)) ++t;
        for (std::size_t k = t;
             k < solid_.triangles.size() && solid_.triangles[k].face == static_cast<int>(f); ++k) {
            const auto& [a, b, c] = solid_.triangles[k].vertices;
            if (!inOutline({{a, b, c}}, p, *this)) continue;
            int sign = 0;
            const auto plane = planeOfLoop({point(a), point(b), point(c)}, sign);
            inside ^= above || (plane && isAbove(*plane, p));
        }
    }
    return inside;
}

}  // namespace ew
