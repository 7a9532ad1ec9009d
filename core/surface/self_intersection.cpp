// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/self_intersection.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <cmath>
#include <limits>
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

/// A triangle or, where two of one group make one, a quadrangle.
struct Part {
    std::array<int, 4> loop{};  ///< points, counter-clockwise from outside
    int size = 3;
    int first = 0;  ///< its triangles, one or two
    int count = 1;

    std::span<const int> points() const { return {loop.data(), at(size)}; }
};

/// The quadrangle of two triangles that share a side; false where they do not.
bool joined(const std::array<int, 3>& s, const std::array<int, 3>& t, std::array<int, 4>& loop) {
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (s[i] != t[(k + 1) % 3] || s[(i + 1) % 3] != t[k]) continue;
            loop = {s[i], t[(k + 2) % 3], s[(i + 1) % 3], s[(i + 2) % 3]};
            return true;
        }
    }
    return false;
}

std::vector<Part> partsOf(const std::vector<std::array<int, 3>>& triangles,
                          const std::vector<int>& group) {
    std::vector<Part> parts;
    parts.reserve(triangles.size());
    const std::size_t n = triangles.size();
    for (std::size_t t = 0; t < n; ++t) {
        Part part;
        part.first = static_cast<int>(t);
        std::copy(triangles[t].begin(), triangles[t].end(), part.loop.begin());
        const auto same = [&](std::size_t a, std::size_t b) {
            return b < n && group[a] >= 0 && group[a] == group[b];
        };
        const bool begins = t == 0 || !same(t, t - 1);
        if (begins && same(t, t + 1) && !same(t, t + 2) &&
            joined(triangles[t], triangles[t + 1], part.loop)) {
            part.size = 4;
            part.count = 2;
            ++t;
        }
        parts.push_back(part);
    }
    return parts;
}

class Finder {
  public:
    Finder(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles,
           const std::vector<int>& group)
        : points_(points), triangles_(triangles), parts_(partsOf(triangles, group)) {
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
        boxes.reserve(parts_.size());
        for (const Part& part : parts_) {
            Box3& box = boxes.emplace_back();
            for (const int i : part.points()) box.extend(point(i));
        }
        return BoxTree(boxes);
    }

    const Part& part(int index) const { return parts_[at(index)]; }

    /// Calls visit(a, b) for triangles of two parts that meet.
    template <class Visit>
    void meetings(const Part& p, const Part& q, Visit&& visit) const {
        if (areApart(p, q)) return;
        for (int a = p.first; a < p.first + p.count; ++a) {
            for (int b = q.first; b < q.first + q.count; ++b) {
                if (meet(a, b)) visit(a, b);
            }
        }
    }

  private:
    bool meet(int a, int b) const {
        std::array<int, 3> s = triangles_[at(a)];
        std::array<int, 3> t = triangles_[at(b)];
        switch (sharedFirst(s, t)) {
            case 0:
                return !separated(corners(s), corners(t), normals_[at(a)], normals_[at(b)]);
            case 1:
                // Most are wholly on one side of the other's plane.
                if (onOneSide(a, s, t) || onOneSide(b, t, s)) return false;
                return conesMeet(s, t, normals_[at(a)], normals_[at(b)]);
            case 2:
                return folded(s, t);
            default:
                return true;
        }
    }

    const Vec3& point(int i) const { return points_[at(i)]; }
    Triangle corners(const std::array<int, 3>& t) const {
        return {point(t[0]), point(t[1]), point(t[2])};
    }

    /// Finds quickly that two parts meet in no more than the points that they share.
    bool areApart(const Part& p, const Part& q) const {
        bool shared = false;
        for (const int i : p.points()) {
            for (const int k : q.points()) {
                if (i != k) continue;
                if (spread_[at(i)]) return true;
                shared = true;
            }
        }
        return !shared && (isBeside(p, q) || isBeside(q, p));
    }

    /// Whether a plane along the first triangle of `p`, or upright on it through a side of `p`, has
    /// the two on its two sides.
    bool isBeside(const Part& p, const Part& q) const {
        const Vec3& normal = normals_[at(p.first)];
        if (divides(normal, lengths_[at(p.first)], p, q)) return true;
        for (std::size_t k = 0; k < at(p.size); ++k) {
            const Vec3 side = point(p.loop[(k + 1) % at(p.size)]) - point(p.loop[k]);
            const Vec3 axis = normal.cross(side);
            if (divides(axis, axis.norm(), p, q)) return true;
        }
        return false;
    }

    bool divides(const Vec3& axis, double length, const Part& p, const Part& q) const {
        if (length <= 0.0) return false;
        const Vec3& origin = point(p.loop[0]);
        const auto range = [&](const Part& part) {
            std::array<double, 2> out{std::numeric_limits<double>::infinity(),
                                      -std::numeric_limits<double>::infinity()};
            for (const int i : part.points()) {
                const double d = axis.dot(point(i) - origin);
                out = {std::min(out[0], d), std::max(out[1], d)};
            }
            return out;
        };
        const auto one = range(p);
        const auto other = range(q);
        return std::max(one[0] - other[1], other[0] - one[1]) > apart_ * length;
    }

    /// Finds the points whose parts lie beside each other, without overlap, seen from some
    /// direction: those meet nowhere else.
    void findSpread() {
        std::vector<std::size_t> start(points_.size() + 1, 0);
        for (const Part& part : parts_) {
            for (const int i : part.points()) ++start[at(i) + 1];
        }
        for (std::size_t i = 0; i < points_.size(); ++i) start[i + 1] += start[i];
        std::vector<int> around(start.back());
        std::vector<std::size_t> fill(start.begin(), start.end() - 1);
        for (std::size_t k = 0; k < parts_.size(); ++k) {
            for (const int i : parts_[k].points()) around[fill[at(i)]++] = static_cast<int>(k);
        }
        spread_.resize(points_.size());
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const std::size_t count = start[i + 1] - start[i];
            spread_[i] = isSpread(static_cast<int>(i), {around.data() + start[i], count});
        }
    }

    bool isSpread(int center, std::span<const int> around) const {
        Vec3 axis = Vec3::Zero();
        for (const int k : around) {
            const int t = parts_[at(k)].first;
            axis += normals_[at(t)] / lengths_[at(t)];
        }
        axis.normalize();
        const Vec3 up = axis.unitOrthogonal();
        // Seen along the axis the second one is on the left of the first one.
        const auto turnsLeft = [&](const Vec3& a, const Vec3& b) {
            const Vec3 normal = a.cross(b);
            const double length = normal.norm();
            return length > tol::kFoldedSine * (a.squaredNorm() + b.squaredNorm()) &&
                   normal.dot(axis) > tol::kSpreadCosine * length;
        };
        int turns = 0;
        for (const int index : around) {
            const Part& part = parts_[at(index)];
            const auto n = at(part.size);
            const auto k = at(static_cast<int>(
                std::find(part.loop.begin(), part.loop.end(), center) - part.loop.begin()));
            const auto to = [&](std::size_t step) -> Vec3 {
                return point(part.loop[(k + step) % n]) - point(center);
            };
            const Vec3 one = to(1);
            const Vec3 other = to(n - 1);
            if (!turnsLeft(one, other)) return false;
            // All of a quadrangle lies between its sides.
            if (n == 4 && !(turnsLeft(one, to(2)) && turnsLeft(to(2), other))) return false;
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
        // Most that are left are neighbours in nearly one plane.
        for (std::size_t i = 0; i < 3; ++i) {
            if (splits(ns.cross(s[(i + 1) % 3] - s[i]), s, t)) return true;
            if (splits(nt.cross(t[(i + 1) % 3] - t[i]), s, t)) return true;
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 e = s[(i + 1) % 3] - s[i];
            for (std::size_t k = 0; k < 3; ++k) {
                if (splits(e.cross(t[(k + 1) % 3] - t[k]), s, t)) return true;
            }
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
    std::vector<Part> parts_;
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
    const Finder finder(points, triangles, group);
    std::vector<std::pair<int, int>> out;
    finder.tree().overlappingPairs([&](int i, int k) {
        if (out.size() >= limit) return;
        const Part& p = finder.part(i);
        const Part& q = finder.part(k);
        if (group[at(p.first)] >= 0 && group[at(p.first)] == group[at(q.first)]) return;
        finder.meetings(p, q, [&](int a, int b) { out.emplace_back(a, b); });
    });
    if (out.size() > limit) out.resize(limit);
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
