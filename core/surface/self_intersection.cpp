// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/self_intersection.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/tolerance.h"
#include "core/surface/box_tree.h"

namespace ew {
namespace {

using Triangle = std::array<Vec3, 3>;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Puts shared corners first, in the same order, and counts them.
std::size_t sharedFirst(std::array<int, 3>& s, std::array<int, 3>& t) {
    std::size_t shared = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = shared; k < 3; ++k) {
            if (s[i] != t[k]) continue;
            std::swap(s[shared], s[i]);
            std::swap(t[shared], t[k]);
            ++shared;
            break;
        }
    }
    return shared;
}

class Finder {
  public:
    Finder(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles)
        : points_(points), triangles_(triangles) {
        Box3 whole;
        for (const Vec3& p : points) whole.extend(p);
        apart_ = tol::kApartRelative * (whole.isEmpty() ? 0.0 : whole.diagonal().norm());
        normals_.reserve(triangles.size());
        lengths_.reserve(triangles.size());
        for (const auto& t : triangles) {
            normals_.push_back((point(t[1]) - point(t[0])).cross(point(t[2]) - point(t[0])));
            lengths_.push_back(normals_.back().norm());
        }
        findSpread();
    }

    BoxTree tree() const {
        std::vector<Box3> boxes;
        boxes.reserve(triangles_.size());
        for (const auto& t : triangles_) {
            Box3 box(point(t[0]));
            box.extend(point(t[1]));
            box.extend(point(t[2]));
            boxes.push_back(box);
        }
        return BoxTree(boxes);
    }

    bool meet(int a, int b) const {
        std::array<int, 3> s = triangles_[at(a)];
        std::array<int, 3> t = triangles_[at(b)];
        switch (sharedFirst(s, t)) {
            case 0:
                return !separated(corners(s), corners(t), normals_[at(a)], normals_[at(b)]);
            case 1:
                if (spread_[at(s[0])]) return false;
                // Most are wholly on one side of the other's plane.
                if (onOneSide(a, s, t) || onOneSide(b, t, s)) return false;
                return conesMeet(s, t, normals_[at(a)], normals_[at(b)]);
            case 2:
                return !spread_[at(s[0])] && !spread_[at(s[1])] && folded(s, t);
            default:
                return true;
        }
    }

  private:
    const Vec3& point(int i) const { return points_[at(i)]; }
    Triangle corners(const std::array<int, 3>& t) const {
        return {point(t[0]), point(t[1]), point(t[2])};
    }

    /// Finds the points whose triangles lie beside each other, without overlap, seen from some
    /// direction: those meet nowhere else.
    void findSpread() {
        std::vector<std::size_t> start(points_.size() + 1, 0);
        for (const auto& t : triangles_) {
            for (const int i : t) ++start[at(i) + 1];
        }
        for (std::size_t i = 0; i < points_.size(); ++i) start[i + 1] += start[i];
        std::vector<int> around(3 * triangles_.size());
        std::vector<std::size_t> fill(start.begin(), start.end() - 1);
        for (std::size_t t = 0; t < triangles_.size(); ++t) {
            for (const int i : triangles_[t]) around[fill[at(i)]++] = static_cast<int>(t);
        }
        spread_.resize(points_.size());
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const std::size_t count = start[i + 1] - start[i];
            spread_[i] = isSpread(static_cast<int>(i), {around.data() + start[i], count});
        }
    }

    bool isSpread(int center, std::span<const int> around) const {
        Vec3 axis = Vec3::Zero();
        for (const int t : around) axis += normals_[at(t)] / lengths_[at(t)];
        const Vec3 across = axis.unitOrthogonal();
        const Vec3 up = axis.cross(across);
        const double least = tol::kSpreadCosine * axis.norm();
        int turns = 0;
        for (const int t : around) {
            const auto& ids = triangles_[at(t)];
            const std::size_t k = ids[0] == center ? 0 : ids[1] == center ? 1 : 2;
            const Vec3 one = point(ids[(k + 1) % 3]) - point(center);
            const Vec3 other = point(ids[(k + 2) % 3]) - point(center);
            const double sliver = tol::kFoldedSine * (one.squaredNorm() + other.squaredNorm());
            if (!(lengths_[at(t)] > sliver)) return false;
            if (!(normals_[at(t)].dot(axis) > least * lengths_[at(t)])) return false;
            // All turn to the left: they go round as often as one direction lies in them.
            if (up.dot(one) <= 0.0 && up.dot(other) > 0.0) ++turns;
        }
        return turns == 1;
    }

    /// Whether the other two corners of `t` are off the plane of triangle `index`, which is `s`, on
    /// one side. The first corner is that of both.
    bool onOneSide(int index, const std::array<int, 3>& s, const std::array<int, 3>& t) const {
        const Vec3& p = point(s[0]);
        const double one = normals_[at(index)].dot(point(t[1]) - p);
        const double other = normals_[at(index)].dot(point(t[2]) - p);
        const double slack = apart_ * lengths_[at(index)];
        return std::min(one, other) > slack || std::max(one, other) < -slack;
    }

    bool splits(const Vec3& axis, const Triangle& s, const Triangle& t) const {
        const double length = axis.norm();
        if (length <= 0.0) return false;
        const double s0 = axis.dot(s[0] - t[0]);
        const double s1 = axis.dot(s[1] - t[0]);
        const double s2 = axis.dot(s[2] - t[0]);
        const double t1 = axis.dot(t[1] - t[0]);
        const double t2 = axis.dot(t[2] - t[0]);
        const double gap = std::max(std::min({s0, s1, s2}) - std::max({0.0, t1, t2}),
                                    std::min({0.0, t1, t2}) - std::max({s0, s1, s2}));
        return gap > apart_ * length;
    }

    /// Separating axes of two triangles, those of coplanar ones included.
    bool separated(const Triangle& s, const Triangle& t, const Vec3& ns, const Vec3& nt) const {
        if (splits(ns, s, t) || splits(nt, s, t)) return true;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 e = s[(i + 1) % 3] - s[i];
            for (std::size_t k = 0; k < 3; ++k) {
                if (splits(e.cross(t[(k + 1) % 3] - t[k]), s, t)) return true;
            }
        }
        for (std::size_t i = 0; i < 3; ++i) {
            if (splits(ns.cross(s[(i + 1) % 3] - s[i]), s, t)) return true;
            if (splits(nt.cross(t[(i + 1) % 3] - t[i]), s, t)) return true;
        }
        return false;
    }

    /// Two triangles at one corner are apart elsewhere where a plane through the corner has one
    /// wholly on its one side and the other on the other, and what they have in the plane are not
    /// edges in one direction.
    bool conesMeet(const std::array<int, 3>& s, const std::array<int, 3>& t, const Vec3& ns,
                   const Vec3& nt) const {
        const Vec3& p = point(s[0]);
        const std::array<Vec3, 2> a{point(s[1]) - p, point(s[2]) - p};
        const std::array<Vec3, 2> b{point(t[1]) - p, point(t[2]) - p};
        const auto splitsCones = [&](const Vec3& axis) {
            const double slack = apart_ * axis.norm();
            const double a0 = axis.dot(a[0]);
            const double a1 = axis.dot(a[1]);
            const double b0 = axis.dot(b[0]);
            const double b1 = axis.dot(b[1]);
            const auto strictly = [&](double x, double y) {
                return std::min(x, y) > slack || std::max(x, y) < -slack;
            };
            const double middleA = a0 + a1;
            const double middleB = b0 + b1;
            if (strictly(a0, a1)) {
                return middleA > 0.0 ? std::max(b0, b1) <= slack : std::min(b0, b1) >= -slack;
            }
            if (strictly(b0, b1)) {
                return middleB > 0.0 ? std::max(a0, a1) <= slack : std::min(a0, a1) >= -slack;
            }
            // One edge of each lies in the plane: those of faces that cross in the corner go on in
            // each other's line.
            const std::size_t inA = std::abs(a0) <= slack ? 0 : 1;
            const std::size_t inB = std::abs(b0) <= slack ? 0 : 1;
            const double sideA = inA == 0 ? a1 : a0;
            const double sideB = inB == 0 ? b1 : b0;
            const bool inPlane =
                std::abs(inA == 0 ? a0 : a1) <= slack && std::abs(inB == 0 ? b0 : b1) <= slack;
            const bool opposite = std::min(sideA, sideB) < -slack && std::max(sideA, sideB) > slack;
            return inPlane && opposite && a[inA].dot(b[inB]) < 0.0;
        };
        if (splitsCones(ns) || splitsCones(nt)) return false;
        for (const Vec3& x : a) {
            if (splitsCones(ns.cross(x))) return false;
        }
        for (const Vec3& y : b) {
            if (splitsCones(nt.cross(y))) return false;
        }
        for (std::size_t i = 0; i < 2; ++i) {
            for (std::size_t k = 0; k < 2; ++k) {
                const Vec3 axis = a[i].cross(b[k]);
                const double length = axis.norm();
                if (length <= tol::kFoldedSine * a[i].norm() * b[k].norm()) continue;
                const double other = axis.dot(a[1 - i]);
                const double back = axis.dot(b[1 - k]);
                const double slack = apart_ * length;
                if ((other > slack && back < -slack) || (other < -slack && back > slack)) {
                    return false;
                }
            }
        }
        return true;
    }

    bool folded(const std::array<int, 3>& s, const std::array<int, 3>& t) const {
        const Vec3 side = point(s[1]) - point(s[0]);
        const Vec3 one = point(s[2]) - point(s[0]);
        const Vec3 other = point(t[2]) - point(t[0]);
        if (one.dot(other) * side.squaredNorm() <= side.dot(one) * side.dot(other)) return false;
        const Vec3 edge = side.normalized();
        const auto away = [&](int i) -> Vec3 {
            const Vec3 d = point(i) - point(s[0]);
            return d - edge * edge.dot(d);
        };
        const Vec3 u = away(s[2]);
        const Vec3 w = away(t[2]);
        return u.cross(w).norm() <= tol::kFoldedSine * u.norm() * w.norm();
    }

    const std::vector<Vec3>& points_;
    const std::vector<std::array<int, 3>>& triangles_;
    std::vector<Vec3> normals_;
    std::vector<double> lengths_;  ///< of the normals
    std::vector<char> spread_;     ///< by point
    double apart_ = 0.0;
};

}  // namespace

std::vector<std::pair<int, int>> selfIntersections(const std::vector<Vec3>& points,
                                                   const std::vector<std::array<int, 3>>& triangles,
                                                   const std::vector<int>& group,
                                                   std::size_t limit) {
    const Finder finder(points, triangles);
    std::vector<std::pair<int, int>> out;
    finder.tree().overlappingPairs([&](int a, int b) {
        if (out.size() >= limit) return;
        if (group[at(a)] >= 0 && group[at(a)] == group[at(b)]) return;
        if (finder.meet(a, b)) out.emplace_back(a, b);
    });
    return out;
}

bool meetExactly(const std::vector<Vec3>& points, const std::array<int, 3>& s,
                 const std::array<int, 3>& t) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    std::array<int, 3> a = s;
    std::array<int, 3> b = t;
    const std::size_t shared = sharedFirst(a, b);
    const auto point = [&](int i) {
        const Vec3& p = points[at(i)];
        return Kernel::Point_3(p.x(), p.y(), p.z());
    };
    const std::array<Kernel::Point_3, 3> p{point(a[0]), point(a[1]), point(a[2])};
    const std::array<Kernel::Point_3, 3> q{point(b[0]), point(b[1]), point(b[2])};
    const Kernel::Triangle_3 one(p[0], p[1], p[2]);
    const Kernel::Triangle_3 other(q[0], q[1], q[2]);
    if (shared == 0) return CGAL::do_intersect(one, other);
    if (shared == 1) {
        return CGAL::do_intersect(Kernel::Segment_3(p[1], p[2]), other) ||
               CGAL::do_intersect(Kernel::Segment_3(q[1], q[2]), one);
    }
    return shared == 3 || (CGAL::coplanar(p[0], p[1], p[2], q[2]) &&
                           CGAL::coplanar_orientation(p[0], p[1], p[2], q[2]) == CGAL::POSITIVE);
}

}  // namespace ew
