// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/solid.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/solid/mesh_kernel.h"

namespace ew {

/// Predicates and constructions of the booleans: rational numbers, each asked only where the
/// rounded doubles beside them leave the answer open. Rounding is monotone, so doubles that differ
/// are in the order of the exact numbers.

/// A point that lives elsewhere, with its rounded coordinates. Cheap to copy.
struct PointView {
    const Point3* exact = nullptr;
    Vec3 r = Vec3::Zero();

    const Rational& operator[](int k) const {
        const auto& e = CGAL::exact(*exact);
        return k == 0 ? e.x() : k == 1 ? e.y() : e.z();
    }
};

/// A point of its own.
struct OwnPoint {
    Point3 exact;
    Vec3 r = Vec3::Zero();

    OwnPoint() = default;
    explicit OwnPoint(const RVec& q)
        : exact(Exact(q[0]), Exact(q[1]), Exact(q[2])), r(rounded(exact)) {}
    PointView view() const { return {&exact, r}; }
};

RVec minus(const PointView& a, const PointView& b);
RVec cross(const RVec& a, const RVec& b);
Rational dot(const RVec& a, const RVec& b);
inline bool isZero(const RVec& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }
RVec coordinates(const PointView& p);
RVec coordinates(const Vec3& p);

/// Sign of a[k] - b[k].
int compare(const PointView& a, const PointView& b, int k);
bool equal(const PointView& a, const PointView& b);

/// Orientation of a, b, c projected to the axes u and v: +1 for a left turn.
int orient2(const PointView& a, const PointView& b, const PointView& c, int u, int v);
bool collinear(const PointView& a, const PointView& b, const PointView& c);

/// Sign of normal . p - offset.
int sideOf(const RPlane& plane, const PointView& p);

/// The plane with this normal through this point; `sign` receives +1 where the given normal and the
/// plane's point the same way, else -1.
/// \pre normal is not zero.
RPlane makePlane(const RVec& normal, const Rational& offset, int& sign);

/// The plane of a polygon and the sense in which its outer loop runs round the normal; nothing
/// where all points are on one line.
std::optional<RPlane> planeOfLoop(const std::vector<PointView>& loop, int& sign);

/// Where a point of a face's plane lies in the face.
struct InFace {
    enum class Where { Outside, Inside, OnSide, AtCorner };
    Where where = Where::Outside;
    int a = -1, b = -1;  ///< the side a -> b, or the corner a
};

/// \param pointAt  PointView of a vertex index.
/// \param axis  of the face's plane.
template <class PointAt>
InFace locateInLoops(const FaceLoops& loops, int axis, const PointView& p, const PointAt& pointAt) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    bool inside = false;
    for (const std::vector<int>& loop : loops) {
        PointView b = pointAt(loop[0]);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const PointView a = b;
            const int ib = loop[i + 1 < loop.size() ? i + 1 : 0];
            b = pointAt(ib);
            // Most sides are out of the way, by the doubles alone.
            if ((a.r[v] < p.r[v] && b.r[v] < p.r[v]) || (a.r[v] > p.r[v] && b.r[v] > p.r[v])) {
                continue;
            }
            if (a.r[u] < p.r[u] && b.r[u] < p.r[u]) continue;
            const int ca = compare(a, p, v);
            const int cb = compare(b, p, v);
            if (ca == cb && ca != 0) continue;
            const int ua = compare(a, p, u);
            const int ub = compare(b, p, u);
            if (ca == 0 && ua == 0) return {InFace::Where::AtCorner, loop[i], -1};
            if (cb == 0 && ub == 0) return {InFace::Where::AtCorner, ib, -1};
            if (ca == 0 && cb == 0) {
                if (ua != ub) return {InFace::Where::OnSide, loop[i], ib};
                continue;
            }
            const int turn = orient2(a, b, p, u, v);
            if (turn == 0) return {InFace::Where::OnSide, loop[i], ib};
            if ((ca > 0) == (cb > 0)) continue;
            if (cb > 0 ? turn > 0 : turn < 0) inside = !inside;
        }
    }
    return {inside ? InFace::Where::Inside : InFace::Where::Outside, -1, -1};
}

/// Length of the longest numerator or denominator [bits].
std::size_t bitsOf(const RPlane& plane);
std::size_t bitsOf(const Point3& p);

/// Where the segment crosses the plane.
/// \pre its ends lie on different sides.
OwnPoint crossing(const RPlane& plane, const PointView& a, const PointView& b);

OwnPoint midpoint(const PointView& a, const PointView& b);

}  // namespace ew
