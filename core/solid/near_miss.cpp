// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/near_miss.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/solid/side_face_pairs.h"

namespace ew {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

struct Segment3 {
    Vec3 a;
    Vec3 b;
};

/// The point of a segment that is nearest to p.
Vec3 nearestOn(const Segment3& s, const Vec3& p) {
    const Vec3 d = s.b - s.a;
    const double t = (p - s.a).dot(d) / d.squaredNorm();
    return s.a + std::clamp(std::isfinite(t) ? t : 0.0, 0.0, 1.0) * d;
}

/// Distance of two segments, measured at their ends and where their lines come nearest; `where`
/// receives the place on the first one.
double distanceOf(const Segment3& s, const Segment3& t, Vec3& where) {
    double least = std::numeric_limits<double>::infinity();
    const auto take = [&](const Vec3& p, const Vec3& q) {
        const double d = (p - q).norm();
        if (d >= least) return;
        least = d;
        where = p;
    };
    take(s.a, nearestOn(t, s.a));
    take(s.b, nearestOn(t, s.b));
    take(nearestOn(s, t.a), t.a);
    take(nearestOn(s, t.b), t.b);
    const Vec3 u = s.b - s.a;
    const Vec3 v = t.b - t.a;
    const double uv = u.dot(v);
    const double area = u.squaredNorm() * v.squaredNorm() - uv * uv;
    if (area <= 0.0) return least;
    const Vec3 w = t.a - s.a;
    const double k = (w.dot(u) * v.squaredNorm() - w.dot(v) * uv) / area;
    if (k <= 0.0 || k >= 1.0) return least;
    const Vec3 p = s.a + k * u;
    take(p, nearestOn(t, p));
    return least;
}

class NearMisses {
  public:
    NearMisses(const std::vector<Vec3>& points, const std::vector<FaceLoops>& faces,
               const Box3& within, double reach)
        : points_(points),
          faces_(faces),
          within_(within.min() - Vec3::Constant(reach), within.max() + Vec3::Constant(reach)),
          reach_(reach),
          pairs_(points, faces, &within_, reach) {}

    std::vector<Vec3> run() {
        pairs_.any([this](const SideFacePairs::Side& side, const SideFacePairs::Face& face) {
            compare(side, face);
            return found_.size() >= kMost;
        });
        return std::move(found_);
    }

  private:
    static constexpr std::size_t kMost = 1000;

    void compare(const SideFacePairs::Side& side, const SideFacePairs::Face& other) {
        const int face = other.face;
        const bool cornerA = pairs_.isCorner(face, side.a);
        const bool cornerB = pairs_.isCorner(face, side.b);
        if (!cornerA) compareCorner(side.a, face, other.box);
        if (!cornerB) compareCorner(side.b, face, other.box);
        const Segment3 own{points_[idx(side.a)], points_[idx(side.b)]};
        for (const std::vector<int>& loop : faces_[idx(face)]) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const int c = loop[i];
                const int d = loop[i + 1 < loop.size() ? i + 1 : 0];
                if (c == side.a || c == side.b || d == side.a || d == side.b) continue;
                const Segment3 wall{points_[idx(c)], points_[idx(d)]};
                Box3 box(wall.a);
                box.extend(wall.b);
                // The side's box has the reach around it already.
                if (!box.intersects(side.box)) continue;
                Vec3 where;
                if (distanceOf(own, wall, where) <= reach_) note(where);
            }
        }
    }

    /// A corner over the middle of a face; what is near its border is near a side.
    void compareCorner(int corner, int face, const Box3& box) {
        const Vec3& p = points_[idx(corner)];
        if (!box.contains(p)) return;
        const std::vector<int>& outer = faces_[idx(face)][0];
        const Vec3 normal = newellNormal(points_, outer);
        if (std::abs(normal.dot(p - points_[idx(outer[0])])) > reach_) return;
        int axis = 0;
        normal.cwiseAbs().maxCoeff(&axis);
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        bool inside = false;
        for (const std::vector<int>& loop : faces_[idx(face)]) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Vec3& a = points_[idx(loop[i])];
                const Vec3& b = points_[idx(loop[i + 1 < loop.size() ? i + 1 : 0])];
                if ((a[v] > p[v]) == (b[v] > p[v])) continue;
                if (p[u] < a[u] + (p[v] - a[v]) / (b[v] - a[v]) * (b[u] - a[u])) inside = !inside;
            }
        }
        if (inside) note(p);
    }

    void note(const Vec3& p) {
        if (within_.contains(p)) found_.push_back(p);
    }

    const std::vector<Vec3>& points_;
    const std::vector<FaceLoops>& faces_;
    const Box3 within_;
    double reach_;
    SideFacePairs pairs_;
    std::vector<Vec3> found_;
};

}  // namespace

std::vector<Vec3> nearMisses(const std::vector<Vec3>& points, const std::vector<FaceLoops>& faces,
                             const Box3& within, double reach) {
    return NearMisses(points, faces, within, reach).run();
}

}  // namespace ew
