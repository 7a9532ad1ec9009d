// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/tool_fixing.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "core/base/tolerance.h"
#include "core/solid/validity.h"

namespace ew {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

Vec3 roundedVec(const RVec& a) {
    return {CGAL::to_double(a[0]), CGAL::to_double(a[1]), CGAL::to_double(a[2])};
}
RVec minus(const RVec& a, const RVec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Rational heightOver(const RPlane& plane, const RVec& p) {
    return dot(plane.normal, p) - plane.offset;
}

/// A direction scaled to a largest component of 1 and rounded.
RVec fewBits(const Vec3& d) {
    const Vec3 scaled = d / d.cwiseAbs().maxCoeff();
    RVec out;
    for (int k = 0; k < 3; ++k) {
        out[idx(k)] = Rational(std::round(scaled[k] / tol::kPlaneGrid) * tol::kPlaneGrid);
    }
    return out;
}

/// The first directions of a list that are independent, two at most.
void addIndependent(const RVec& direction, std::vector<RVec>& out) {
    if (out.size() >= 2 || isZero(direction)) return;
    if (out.empty() || !isZero(cross(out[0], direction))) out.push_back(direction);
}

std::vector<RVec> normalsOf(const std::vector<RPlane>& planes) {
    std::vector<RVec> out;
    for (const RPlane& plane : planes) addIndependent(plane.normal, out);
    return out;
}

}  // namespace

ToolFixing::ToolFixing(const PolyhedronSpec& shape)
    : shape_(shape),
      reach_(tol::kToolMove * sizeOf(shape.vertices)),
      planeOf_(shape.faces.size(), -1) {
    for (FittedPlane& plane : fitPlanes(shape)) {
        for (const int f : plane.faces) planeOf_[idx(f)] = static_cast<int>(planes_.size());
        planes_.push_back({std::move(plane), {}, {}, std::nullopt});
    }
    points_.resize(shape.vertices.size());
}

ToolFixing::ToolFixing(std::vector<Vec3> points, std::vector<FittedPlane> planes, double reach)
    : reach_(reach) {
    points_.resize(points.size());
    shape_.vertices = std::move(points);
    for (FittedPlane& plane : planes) {
        shape_.faces.push_back(plane.points);
        planeOf_.push_back(static_cast<int>(planes_.size()));
        planes_.push_back({std::move(plane), {}, {}, std::nullopt});
    }
}

void ToolFixing::faceIn(int face, const RPlane& plane) {
    PlaneNode& node = planes_[idx(planeOf(face))];
    if (!node.fixed) node.fixed = plane;
    Demand demand;
    demand.face = face;
    demand.plane = plane;
    demands_.push_back(demand);
}

void ToolFixing::faceAlong(int face, const RVec& direction) {
    planes_[idx(planeOf(face))].along.push_back(direction);
    Demand demand;
    demand.face = face;
    demand.along = direction;
    demands_.push_back(demand);
}

void ToolFixing::faceThrough(int face, const RVec& point) {
    planes_[idx(planeOf(face))].through.push_back(point);
    Demand demand;
    demand.face = face;
    demand.point = point;
    demands_.push_back(demand);
}

void ToolFixing::vertexAt(int vertex, const RVec& point) {
    PointNode& node = points_[idx(vertex)];
    if (!node.fixed) node.fixed = point;
    Demand demand;
    demand.vertex = vertex;
    demand.point = point;
    demands_.push_back(demand);
}

void ToolFixing::vertexOn(int vertex, const RPlane& plane) {
    points_[idx(vertex)].on.push_back(plane);
    Demand demand;
    demand.vertex = vertex;
    demand.plane = plane;
    demands_.push_back(demand);
}

// One node ---------------------------------------------------------------------------------------

/// Directions that the plane contains for certain, two at most.
std::vector<RVec> ToolFixing::spansOf(const PlaneNode& node) {
    std::vector<RVec> out;
    for (const RVec& d : node.along) addIndependent(d, out);
    for (std::size_t i = 1; i < node.through.size() && out.size() < 2; ++i) {
        addIndependent(minus(node.through[i], node.through[0]), out);
    }
    return out;
}

/// A normal for a plane that contains at most one direction exactly: that of a fixed face that is
/// parallel; at a right angle to a fixed face where they both contain the direction; else as
/// fitted.
std::optional<RVec> ToolFixing::softNormal(const PlaneNode& node,
                                           const std::vector<RVec>& spans) const {
    const auto fits = [&](const RVec& normal) {
        return spans.empty() || dot(normal, spans[0]) == 0;
    };
    for (const PlaneNode& other : planes_) {
        if (&other == &node || !other.fixed || other.wish.normal != node.wish.normal) continue;
        if (fits(other.fixed->normal)) return other.fixed->normal;
    }
    if (spans.empty()) return coordinates(node.wish.normal);
    const Vec3 wish = node.wish.normal.normalized();
    for (const PlaneNode& other : planes_) {
        if (&other == &node || !other.fixed || !fits(other.fixed->normal)) continue;
        if (std::abs(other.fixed->n.normalized().dot(wish)) > tol::kToolRightAngle) continue;
        return cross(spans[0], other.fixed->normal);
    }
    const Vec3 across = wish.cross(roundedVec(spans[0]).normalized());
    if (across.norm() < 0.1) return std::nullopt;
    return cross(spans[0], fewBits(across));
}

std::optional<RPlane> ToolFixing::planeFrom(const PlaneNode& node) const {
    const std::vector<RVec> spans = spansOf(node);
    std::optional<RVec> normal;
    if (spans.size() == 2) {
        normal = cross(spans[0], spans[1]);
    } else {
        normal = softNormal(node, spans);
    }
    if (!normal || isZero(*normal)) return std::nullopt;
    Rational offset;
    if (!node.through.empty()) {
        offset = dot(*normal, node.through[0]);
    } else if (*normal == coordinates(node.wish.normal)) {
        offset = Rational(node.wish.offset);
    } else {
        // Through the corner that is nearest to the middle of the face's heights.
        const Vec3 n = roundedVec(*normal);
        double middle = 0.0;
        for (const int v : node.wish.points) {
            middle += n.dot(shape_.vertices[idx(v)]) / static_cast<double>(node.wish.points.size());
        }
        const auto nearest =
            std::min_element(node.wish.points.begin(), node.wish.points.end(), [&](int a, int b) {
                return std::abs(n.dot(shape_.vertices[idx(a)]) - middle) <
                       std::abs(n.dot(shape_.vertices[idx(b)]) - middle);
            });
        offset = dot(*normal, coordinates(shape_.vertices[idx(*nearest)]));
    }
    int sign = 0;
    return makePlane(*normal, offset, sign);
}

std::optional<RVec> ToolFixing::pointFrom(const PointNode& node, const Vec3& wish) const {
    std::vector<const RPlane*> planes;
    for (const RPlane& plane : node.on) {
        std::vector<RVec> normals;
        for (const RPlane* p : planes) normals.push_back(p->normal);
        const bool fresh =
            planes.empty() || (planes.size() == 1 && !isZero(cross(normals[0], plane.normal))) ||
            (planes.size() == 2 && dot(cross(normals[0], normals[1]), plane.normal) != 0);
        if (fresh) planes.push_back(&plane);
    }
    RVec p = coordinates(wish);
    if (planes.size() == 1) {
        // Along the plane's axis: the component of the normal is 1 there.
        p[idx(planes[0]->axis)] -= heightOver(*planes[0], p);
    } else if (planes.size() == 2) {
        const RVec& n = planes[0]->normal;
        const RVec& m = planes[1]->normal;
        const RVec along = cross(n, m);
        std::size_t k = 0;
        for (std::size_t i = 1; i < 3; ++i) k = abs(along[i]) > abs(along[k]) ? i : k;
        const std::size_t u = (k + 1) % 3;
        const std::size_t v = (k + 2) % 3;
        const Rational r0 = planes[0]->offset - n[k] * p[k];
        const Rational r1 = planes[1]->offset - m[k] * p[k];
        const Rational pu = (r0 * m[v] - r1 * n[v]) / along[k];
        p[v] = (r1 * n[u] - r0 * m[u]) / along[k];
        p[u] = pu;
    } else if (planes.size() == 3) {
        const RVec mo = cross(planes[1]->normal, planes[2]->normal);
        const RVec on = cross(planes[2]->normal, planes[0]->normal);
        const RVec nm = cross(planes[0]->normal, planes[1]->normal);
        const Rational det = dot(planes[0]->normal, mo);
        for (std::size_t k = 0; k < 3; ++k) {
            p[k] = (planes[0]->offset * mo[k] + planes[1]->offset * on[k] +
                    planes[2]->offset * nm[k]) /
                   det;
        }
    }
    return p;
}

// The order --------------------------------------------------------------------------------------

bool ToolFixing::isFixed(std::size_t node) const {
    return node < points_.size() ? points_[node].fixed.has_value()
                                 : planes_[node - points_.size()].fixed.has_value();
}

/// How many more links a node can take.
int ToolFixing::freedom(std::size_t node) const {
    if (node < points_.size()) {
        const auto& on = points_[node].on;
        const auto two = normalsOf(on);
        if (two.size() < 2) return 3 - static_cast<int>(two.size());
        const RVec along = cross(two[0], two[1]);
        const bool third = std::any_of(on.begin(), on.end(), [&](const RPlane& plane) {
            return dot(plane.normal, along) != 0;
        });
        return third ? 0 : 1;
    }
    const PlaneNode& plane = planes_[node - points_.size()];
    return 3 - static_cast<int>(spansOf(plane).size()) - (plane.through.empty() ? 0 : 1);
}

/// Tells a node of a fixed neighbour.
void ToolFixing::bind(std::size_t node, std::size_t other) {
    if (node < points_.size()) {
        points_[node].on.push_back(*planes_[other - points_.size()].fixed);
    } else {
        planes_[node - points_.size()].through.push_back(*points_[other].fixed);
    }
}

bool ToolFixing::fixNode(std::size_t node) {
    if (isFixed(node)) return true;
    if (node < points_.size()) {
        points_[node].fixed = pointFrom(points_[node], shape_.vertices[node]);
        return points_[node].fixed.has_value();
    }
    PlaneNode& plane = planes_[node - points_.size()];
    plane.fixed = planeFrom(plane);
    return plane.fixed.has_value();
}

/// A point that can only move in directions that a plane contains binds the plane, not itself.
bool ToolFixing::bindSliding(std::size_t point, std::size_t plane) {
    PlaneNode& node = planes_[plane - points_.size()];
    const std::vector<RVec> spans = spansOf(node);
    const std::vector<RVec> normals = normalsOf(points_[point].on);
    bool slides = false;
    if (normals.size() == 2 && !spans.empty()) {
        const RVec along = cross(normals[0], normals[1]);
        slides = spans.size() == 1 ? isZero(cross(spans[0], along))
                                   : dot(cross(spans[0], spans[1]), along) == 0;
    } else if (normals.size() == 1 && spans.size() == 2) {
        slides = isZero(cross(cross(spans[0], spans[1]), normals[0]));
    }
    if (!slides) return false;
    const auto anywhere = pointFrom(points_[point], shape_.vertices[point]);
    if (!anywhere) return false;
    node.through.push_back(*anywhere);
    links_[point].erase(plane);
    links_[plane].erase(point);
    return true;
}

/// What the rules settle alone, and what follows from that. Contradictions show at the end.
void ToolFixing::settle() {
    spread();
    for (bool again = true; again;) {
        again = false;
        for (std::size_t p = 0; p < points_.size(); ++p) {
            if (isFixed(p)) continue;
            const auto planes = links_[p];
            for (const std::size_t plane : planes) again |= bindSliding(p, plane);
        }
        if (again) spread();
    }
}

/// Fixes what has no freedom left, and what follows from that.
void ToolFixing::spread() {
    std::vector<std::size_t> pending;
    for (std::size_t n = 0; n < links_.size(); ++n) {
        if (isFixed(n) || freedom(n) == 0) pending.push_back(n);
    }
    while (!pending.empty()) {
        const std::size_t n = pending.back();
        pending.pop_back();
        if (!fixNode(n)) continue;
        const auto others = links_[n];
        for (const std::size_t o : others) {
            links_[o].erase(n);
            links_[n].erase(o);
            if (isFixed(o)) continue;
            bind(o, n);
            if (freedom(o) == 0) pending.push_back(o);
        }
    }
}

/// Peels off nodes that can take all their links, last one first: points before planes, and
/// planes with rules at the very end.
bool ToolFixing::fixRest() {
    std::set<std::size_t> open;
    for (std::size_t n = 0; n < links_.size(); ++n) {
        if (!isFixed(n)) open.insert(n);
    }
    std::vector<std::size_t> order;
    auto links = links_;
    // Peeling only takes links away, so the freedoms stay.
    std::vector<int> free(links.size(), 0);
    for (const std::size_t n : open) free[n] = freedom(n);
    while (!open.empty()) {
        const auto rank = [&](std::size_t n) {
            const int excess = static_cast<int>(links[n].size()) - free[n];
            const bool isPlane = n >= points_.size();
            const bool triangle = isPlane && planes_[n - points_.size()].wish.points.size() == 3;
            const int kind = !isPlane ? 0 : triangle ? 1 : 2;
            return std::tuple(std::max(0, excess), kind, n);
        };
        const std::size_t next = *std::min_element(
            open.begin(), open.end(), [&](auto a, auto b) { return rank(a) < rank(b); });
        if (std::get<0>(rank(next)) > 0) return false;
        open.erase(next);
        order.push_back(next);
        for (const std::size_t o : links[next]) links[o].erase(next);
    }
    std::reverse(order.begin(), order.end());
    for (const std::size_t n : order) {
        if (!fixNode(n)) return false;
        const auto others = links_[n];
        for (const std::size_t o : others) {
            links_[o].erase(n);
            links_[n].erase(o);
            if (!isFixed(o)) bind(o, n);
        }
    }
    return true;
}

Result<std::vector<RVec>> ToolFixing::solve() {
    links_.assign(points_.size() + planes_.size(), {});
    for (std::size_t i = 0; i < planes_.size(); ++i) {
        for (const int v : planes_[i].wish.points) {
            links_[idx(v)].insert(points_.size() + i);
            links_[points_.size() + i].insert(idx(v));
        }
    }
    settle();
    if (!fixRest()) {
        return fail(Errc::Contradiction,
                    "The new part's faces cannot all be flat with these constraints.");
    }
    if (auto ok = check(); !ok) return fail(ok.error());
    std::vector<RVec> out;
    for (const PointNode& node : points_) out.push_back(*node.fixed);
    return out;
}

Result<void> ToolFixing::check() const {
    for (std::size_t v = 0; v < points_.size(); ++v) {
        const double move = (roundedVec(*points_[v].fixed) - shape_.vertices[v]).norm();
        if (move <= reach_) continue;
        return fail(Errc::Contradiction, "Corner " + std::to_string(v) +
                                             " of the new part would have to move by " +
                                             std::to_string(move) + " mm.");
    }
    for (std::size_t f = 0; f < shape_.faces.size(); ++f) {
        const RPlane& plane = *planes_[idx(planeOf_[f])].fixed;
        for (const int v : shape_.faces[f]) {
            if (heightOver(plane, *points_[idx(v)].fixed) == 0) continue;
            return fail(Errc::Contradiction, "Corner " + std::to_string(v) +
                                                 " of the new part cannot lie in its face " +
                                                 std::to_string(f) + " as asked.");
        }
    }
    for (const Demand& demand : demands_) {
        bool holds = true;
        if (demand.face >= 0) {
            const RPlane& plane = *planes_[idx(planeOf_[idx(demand.face)])].fixed;
            if (demand.plane) holds = plane == *demand.plane;
            if (demand.along) holds = dot(plane.normal, *demand.along) == 0;
            if (demand.point) holds = heightOver(plane, *demand.point) == 0;
        } else {
            const RVec& point = *points_[idx(demand.vertex)].fixed;
            if (demand.plane) holds = heightOver(*demand.plane, point) == 0;
            if (demand.point) holds = point == *demand.point;
        }
        if (holds) continue;
        return fail(Errc::Contradiction,
                    demand.face >= 0 ? "Face " + std::to_string(demand.face) +
                                           " of the new part cannot lie to the solid as asked."
                                     : "Corner " + std::to_string(demand.vertex) +
                                           " of the new part cannot lie on the solid as asked.");
    }
    return {};
}

}  // namespace ew
