// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/exact_geometry.h"

#include <algorithm>
#include <cmath>

#include "core/base/tolerance.h"

namespace ew {
namespace {

std::size_t idx(int k) { return static_cast<std::size_t>(k); }

double determinant2(const Vec3& a, const Vec3& b, const Vec3& c, int u, int v) {
    return (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
}

}  // namespace

RVec minus(const PointView& a, const PointView& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
RVec cross(const RVec& a, const RVec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot(const RVec& a, const RVec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
RVec coordinates(const PointView& p) { return {p[0], p[1], p[2]}; }
RVec coordinates(const Vec3& p) { return {Rational(p.x()), Rational(p.y()), Rational(p.z())}; }

int compare(const PointView& a, const PointView& b, int k) {
    if (a.r[k] != b.r[k]) return a.r[k] < b.r[k] ? -1 : 1;
    if (a.exact == b.exact) return 0;
    return sgn(Rational(a[k] - b[k]));
}

bool equal(const PointView& a, const PointView& b) {
    return a.r == b.r && (a.exact == b.exact || (a[0] == b[0] && a[1] == b[1] && a[2] == b[2]));
}

int orient2(const PointView& a, const PointView& b, const PointView& c, int u, int v) {
    const double det = determinant2(a.r, b.r, c.r, u, v);
    const double mu = std::max({std::abs(a.r[u]), std::abs(b.r[u]), std::abs(c.r[u])});
    const double mv = std::max({std::abs(a.r[v]), std::abs(b.r[v]), std::abs(c.r[v])});
    if (std::abs(det) > tol::kOrientError * mu * mv) return det > 0 ? 1 : -1;
    const Rational exact = (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
    return sgn(exact);
}

bool collinear(const PointView& a, const PointView& b, const PointView& c) {
    return orient2(a, b, c, 0, 1) == 0 && orient2(a, b, c, 1, 2) == 0 &&
           orient2(a, b, c, 2, 0) == 0;
}

int sideOf(const RPlane& plane, const PointView& p) {
    const Vec3 terms = plane.n.cwiseProduct(p.r);
    const double value = terms.sum() - plane.d;
    const double bound = tol::kSideError * (terms.cwiseAbs().sum() + std::abs(plane.d));
    if (std::abs(value) > bound) return value > 0 ? 1 : -1;
    Rational sum = -plane.offset;
    for (int k = 0; k < 3; ++k) {
        if (plane.normal[idx(k)] != 0) sum += plane.normal[idx(k)] * p[k];
    }
    return sgn(sum);
}

RPlane makePlane(const RVec& normal, const Rational& offset, int& sign) {
    RPlane plane;
    plane.axis = 0;
    for (int k = 1; k < 3; ++k) {
        if (abs(normal[idx(k)]) > abs(normal[idx(plane.axis)])) plane.axis = k;
    }
    const Rational& scale = normal[idx(plane.axis)];
    sign = sgn(scale);
    for (int k = 0; k < 3; ++k) {
        plane.normal[idx(k)] = normal[idx(k)] / scale;
        plane.n[k] = CGAL::to_double(plane.normal[idx(k)]);
    }
    plane.offset = offset / scale;
    plane.d = CGAL::to_double(plane.offset);
    return plane;
}

std::optional<RPlane> planeOfLoop(const std::vector<PointView>& loop, int& sign) {
    // The widest triangle with the first point: well away from a line, whatever the outline.
    const PointView& a = loop[0];
    std::size_t far = 0;
    for (std::size_t i = 1; i < loop.size(); ++i) {
        if ((loop[i].r - a.r).squaredNorm() > (loop[far].r - a.r).squaredNorm()) far = i;
    }
    std::size_t wide = 0;
    double best = -1.0;
    Vec3 newell = Vec3::Zero();
    for (std::size_t i = 1; i < loop.size(); ++i) {
        const double w = (loop[far].r - a.r).cross(loop[i].r - a.r).squaredNorm();
        if (w > best && i != far) {
            best = w;
            wide = i;
        }
        newell += (loop[i].r - a.r).cross(loop[(i + 1) % loop.size()].r - a.r);
    }
    if (far == 0 || wide == 0) return std::nullopt;
    const RVec normal = cross(minus(loop[far], a), minus(loop[wide], a));
    if (isZero(normal)) return std::nullopt;
    RPlane plane = makePlane(normal, dot(normal, coordinates(a)), sign);
    const double area = newell.dot(plane.n);
    const double reach = a.r.cwiseAbs().maxCoeff() + (loop[far].r - a.r).norm();
    if (std::abs(area) > tol::kOrientError * static_cast<double>(loop.size()) * reach * reach) {
        sign = area > 0.0 ? 1 : -1;
        return plane;
    }
    const int u = (plane.axis + 1) % 3;
    const int v = (plane.axis + 2) % 3;
    Rational exact = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const PointView& p = loop[i];
        const PointView& q = loop[(i + 1) % loop.size()];
        exact += p[u] * q[v] - p[v] * q[u];
    }
    sign = sgn(exact);
    if (sign == 0) return std::nullopt;
    return plane;
}

namespace {

std::size_t bitsOf(const Rational& x) {
    return std::max(mpz_sizeinbase(x.get_num_mpz_t(), 2), mpz_sizeinbase(x.get_den_mpz_t(), 2));
}

}  // namespace

std::size_t bitsOf(const RPlane& plane) {
    std::size_t bits = bitsOf(plane.offset);
    for (const Rational& x : plane.normal) bits = std::max(bits, bitsOf(x));
    return bits;
}

std::size_t bitsOf(const Point3& p) {
    const auto& e = CGAL::exact(p);
    return std::max({bitsOf(e.x()), bitsOf(e.y()), bitsOf(e.z())});
}

OwnPoint crossing(const RPlane& plane, const PointView& a, const PointView& b) {
    const RVec p = coordinates(a);
    const RVec q = coordinates(b);
    const Rational da = dot(plane.normal, p) - plane.offset;
    const Rational db = dot(plane.normal, q) - plane.offset;
    const Rational t = da / (da - db);
    RVec x;
    for (std::size_t k = 0; k < 3; ++k) x[k] = p[k] + t * (q[k] - p[k]);
    return OwnPoint(x);
}

OwnPoint midpoint(const PointView& a, const PointView& b) {
    RVec x;
    for (int k = 0; k < 3; ++k) x[idx(k)] = (a[k] + b[k]) / 2;
    return OwnPoint(x);
}

}  // namespace ew
