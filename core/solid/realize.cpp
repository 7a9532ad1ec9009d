// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/realize.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "core/base/tolerance.h"
#include "core/solid/plane_fit.h"
#include "core/solid/validity.h"

namespace ew {
namespace {

using Triple = std::array<Exact, 3>;

Triple triple(const Point3& p) { return {p.x(), p.y(), p.z()}; }
Exact dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Triple minus(const Triple& a, const Triple& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Triple cross(const Triple& a, const Triple& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
bool isZero(const Triple& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }
int mainAxis(const Triple& a) {
    Vec3 v(CGAL::to_double(a[0]), CGAL::to_double(a[1]), CGAL::to_double(a[2]));
    int axis = 0;
    v.cwiseAbs().maxCoeff(&axis);
    return axis;
}
std::size_t idx(int i) { return static_cast<std::size_t>(i); }

/// normal . p = offset, exactly.
struct ExactPlane {
    Triple normal;
    Exact offset;
};

/// The point on up to three planes that is (nearly) the nearest to `wish`.
std::optional<Point3> pointOn(const std::vector<const ExactPlane*>& planes, const Vec3& wish) {
    Triple p{Exact(wish.x()), Exact(wish.y()), Exact(wish.z())};
    if (planes.size() == 1) {
        const auto& [n, d] = *planes[0];
        const auto k = idx(mainAxis(n));
        if (n[k] == 0) return std::nullopt;
        p[k] += (d - dot(n, p)) / n[k];
    } else if (planes.size() == 2) {
        const auto& [n, d] = *planes[0];
        const auto& [m, e] = *planes[1];
        const Triple along = cross(n, m);
        // The coordinate along the line stays, the other two are solved for.
        const int axis = mainAxis(along);
        const auto k = idx(axis);
        const auto u = idx((axis + 1) % 3);
        const auto v = idx((axis + 2) % 3);
        if (along[k] == 0) return std::nullopt;
        const Exact rhs0 = d - n[k] * p[k];
        const Exact rhs1 = e - m[k] * p[k];
        const Exact pu = (rhs0 * m[v] - rhs1 * n[v]) / along[k];
        const Exact pv = (rhs1 * n[u] - rhs0 * m[u]) / along[k];
        p[u] = pu;
        p[v] = pv;
    } else if (planes.size() == 3) {
        const auto& [n, d] = *planes[0];
        const auto& [m, e] = *planes[1];
        const auto& [o, f] = *planes[2];
        const Triple mo = cross(m, o);
        const Triple on = cross(o, n);
        const Triple nm = cross(n, m);
        const Exact det = dot(n, mo);
        if (det == 0) return std::nullopt;
        for (std::size_t k = 0; k < 3; ++k) p[k] = (d * mo[k] + e * on[k] + f * nm[k]) / det;
    }
    return Point3(p[0], p[1], p[2]);
}

/// The plane through up to three points whose normal is (nearly) the nearest to the fitted one.
std::optional<ExactPlane> planeThrough(const std::vector<const Point3*>& points,
                                       const FittedPlane& wish) {
    const Triple fitted{Exact(wish.normal.x()), Exact(wish.normal.y()), Exact(wish.normal.z())};
    if (points.empty()) return ExactPlane{fitted, Exact(wish.offset)};
    const Triple p = triple(*points[0]);
    Triple normal = fitted;
    if (points.size() > 1) {
        Triple side = minus(triple(*points[1]), p);
        if (isZero(side)) return std::nullopt;
        normal = cross(side, cross(fitted, side));
        if (points.size() > 2) {
            const Triple through = cross(side, minus(triple(*points[2]), p));
            if (!isZero(through)) normal = through;
        }
        if (isZero(normal)) return std::nullopt;
    }
    return ExactPlane{normal, dot(normal, p)};
}

/// Points and planes in the order in which they are fixed, each bound by at most three earlier
/// ones.
class FixingOrder {
  public:
    /// A plane through exactly three points binds nothing; `skipTriangles` leaves those out.
    FixingOrder(std::size_t pointCount, const std::vector<FittedPlane>& planes, bool skipTriangles)
        : pointCount_(pointCount), links_(pointCount + planes.size()), kind_(links_.size(), 0) {
        for (std::size_t i = 0; i < planes.size(); ++i) {
            const bool triangle = planes[i].points.size() == 3;
            kind_[pointCount + i] = planes[i].axis >= 0 ? 3 : triangle ? 1 : 2;
            if (triangle && skipTriangles) continue;
            used_.push_back(pointCount + i);
            for (const int p : planes[i].points) {
                links_[idx(p)].push_back(pointCount + i);
                links_[pointCount + i].push_back(idx(p));
            }
        }
    }

    struct Step {
        std::size_t node;                  ///< a point, or pointCount + a plane
        std::vector<std::size_t> binding;  ///< earlier nodes that it is incident with
    };

    /// Peels off elements with at most three links, last one first: points before planes and axis
    /// planes at the very end, so that planes, and axis planes above all, are free to be as fitted.
    std::optional<std::vector<Step>> find() const {
        std::vector<int> degree(links_.size(), 0);
        std::vector<bool> gone(links_.size(), true);
        std::set<std::pair<int, std::size_t>> ready;
        const auto enter = [&](std::size_t node) {
            gone[node] = false;
            degree[node] = static_cast<int>(links_[node].size());
            if (degree[node] <= 3) ready.emplace(kind_[node], node);
        };
        for (std::size_t p = 0; p < pointCount_; ++p) enter(p);
        for (const std::size_t plane : used_) enter(plane);
        std::vector<Step> steps;
        while (!ready.empty()) {
            const std::size_t node = ready.begin()->second;
            ready.erase(ready.begin());
            gone[node] = true;
            Step step{node, {}};
            for (const std::size_t other : links_[node]) {
                if (gone[other]) continue;
                step.binding.push_back(other);
                if (--degree[other] == 3) ready.emplace(kind_[other], other);
            }
            steps.push_back(std::move(step));
        }
        if (steps.size() != pointCount_ + used_.size()) return std::nullopt;
        std::reverse(steps.begin(), steps.end());
        return steps;
    }

  private:
    std::size_t pointCount_;
    std::vector<std::vector<std::size_t>> links_;
    std::vector<int> kind_;
    std::vector<std::size_t> used_;
};

/// Bits of the longest numerator or denominator.
std::size_t bitsOf(const Point3& p) {
    const auto& e = CGAL::exact(p);
    std::size_t bits = 0;
    for (const Rational& x : {e.x(), e.y(), e.z()}) {
        bits = std::max(
            {bits, mpz_sizeinbase(x.get_num_mpz_t(), 2), mpz_sizeinbase(x.get_den_mpz_t(), 2)});
    }
    return bits;
}

/// Fixes everything in the order; nothing where an intersection is missing, moves a point too far
/// or grows beyond all measure.
std::optional<std::vector<Point3>> fix(const std::vector<Vec3>& wish,
                                       const std::vector<FittedPlane>& fitted,
                                       const std::vector<FixingOrder::Step>& steps) {
    const double reach = tol::kPlanarRelative * sizeOf(wish);
    std::vector<Point3> points(wish.size());
    std::vector<ExactPlane> planes(fitted.size());
    for (const auto& [node, binding] : steps) {
        if (node < wish.size()) {
            std::vector<const ExactPlane*> on;
            for (const std::size_t b : binding) on.push_back(&planes[b - wish.size()]);
            const auto p = pointOn(on, wish[node]);
            if (!p || bitsOf(*p) > tol::kMaxRealizedBits) return std::nullopt;
            if ((rounded(*p) - wish[node]).norm() > reach) return std::nullopt;
            points[node] = *p;
        } else {
            std::vector<const Point3*> through;
            for (const std::size_t b : binding) through.push_back(&points[b]);
            const auto plane = planeThrough(through, fitted[node - wish.size()]);
            if (!plane) return std::nullopt;
            planes[node - wish.size()] = *plane;
        }
    }
    return points;
}

bool exactlyPlanar(const std::vector<Point3>& points, const FaceLoops& loops) {
    const std::vector<int>& loop = loops[0];
    if (loops.size() == 1 && loop.size() == 3) return true;
    const Point3& a = points[idx(loop[0])];
    const Point3& b = points[idx(loop[1])];
    const auto apex = std::find_if(loop.begin() + 2, loop.end(),
                                   [&](int i) { return !CGAL::collinear(a, b, points[idx(i)]); });
    if (apex == loop.end()) return true;
    for (const std::vector<int>& l : loops) {
        for (const int i : l) {
            if (!CGAL::coplanar(a, b, points[idx(*apex)], points[idx(i)])) return false;
        }
    }
    return true;
}

bool allPlanar(const ExactBrep& brep) {
    return std::all_of(brep.faces.begin(), brep.faces.end(),
                       [&](const FaceLoops& loops) { return exactlyPlanar(brep.points, loops); });
}

}  // namespace

Result<ExactBrep> realize(const PolyhedronSpec& spec) {
    ExactBrep brep;
    for (const Vec3& p : spec.vertices) brep.points.push_back(exactPoint(p));
    for (const auto& face : spec.faces) brep.faces.push_back({face});
    if (auto ok = checkPlanar(spec.vertices, brep.faces); !ok) return fail(ok.error());
    if (allPlanar(brep)) return brep;
    const std::vector<FittedPlane> planes = fitPlanes(spec);
    for (const bool skipTriangles : {false, true}) {
        const auto order = FixingOrder(spec.vertices.size(), planes, skipTriangles).find();
        if (!order) continue;
        auto points = fix(spec.vertices, planes, *order);
        if (!points) continue;
        ExactBrep moved{std::move(*points), brep.faces};
        if (allPlanar(moved)) return moved;
    }
    return brep;
}

}  // namespace ew
