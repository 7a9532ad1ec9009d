// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/crossing_check.h"

#include <algorithm>
#include <string>

#include "core/base/tolerance.h"
#include "core/solid/side_face_pairs.h"

namespace ew {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

class Crossings {
  public:
    Crossings(const ExactBrep& brep, const FacePlanes& planes, const Box3* within)
        : brep_(brep),
          planes_(planes),
          rounded_(roundedPoints(brep)),
          pairs_(rounded_, brep.faces, within, 0.0) {}

    Result<void> run() {
        const auto visit = [this](const Side& side, const Face& face) { return meet(side, face); };
        if (pairs_.any(visit)) return found();
        return {};
    }

  private:
    using Side = SideFacePairs::Side;
    using Face = SideFacePairs::Face;

    static std::vector<Vec3> roundedPoints(const ExactBrep& brep) {
        std::vector<Vec3> out;
        out.reserve(brep.points.size());
        for (const Point3& p : brep.points) out.push_back(rounded(p));
        return out;
    }

    PointView point(int v) const { return {&brep_.points[idx(v)], rounded_[idx(v)]}; }
    const RPlane& plane(int face) const { return *planes_[idx(face)]; }
    bool isCorner(int face, int v) const { return pairs_.isCorner(face, v); }
    bool holds(int face, const PointView& p) const {
        const InFace at = locateInLoops(brep_.faces[idx(face)], plane(face).axis, p,
                                        [this](int v) { return point(v); });
        return at.where != InFace::Where::Outside;
    }
    bool coplanar(int f, int g) const {
        return planes_[idx(f)] == planes_[idx(g)] ||
               (plane(f).d == plane(g).d && plane(f).n == plane(g).n && plane(f) == plane(g));
    }

    /// Does a side meet a face in anything but corners of the face?
    bool meet(const Side& side, const Face& other) {
        const int face = other.face;
        culprits_ = {side.faces[0], face};
        if (coplanar(side.faces[0], face) ||
            (side.faces[1] >= 0 && coplanar(side.faces[1], face))) {
            return meetInPlane(side, face);
        }
        const bool cornerA = isCorner(face, side.a);
        const bool cornerB = isCorner(face, side.b);
        const int sa = cornerA ? 0 : sideOf(plane(face), point(side.a));
        const int sb = cornerB ? 0 : sideOf(plane(face), point(side.b));
        if (sa == 0 && sb == 0) return meetInPlane(side, face);
        if (sa == 0) return !cornerA && holds(face, point(side.a));
        if (sb == 0) return !cornerB && holds(face, point(side.b));
        if (sa == sb) return false;
        // Far off by the doubles, in most cases.
        const Vec3& a = rounded_[idx(side.a)];
        const Vec3& b = rounded_[idx(side.b)];
        const double da = plane(face).n.dot(a) - plane(face).d;
        const double db = plane(face).n.dot(b) - plane(face).d;
        if (std::abs(da - db) >
            tol::kSurelyBeside * (std::abs(plane(face).d) + a.norm() + b.norm())) {
            const Vec3 x = a + da / (da - db) * (b - a);
            if (other.box.exteriorDistance(x) > tol::kSurelyBeside * (1.0 + x.norm())) return false;
        }
        return holds(face, crossing(plane(face), point(side.a), point(side.b)).view());
    }

    bool meetInPlane(const Side& side, int face) const {
        const PointView a = point(side.a);
        const PointView b = point(side.b);
        const bool cornerA = isCorner(face, side.a);
        const bool cornerB = isCorner(face, side.b);
        if (!cornerA && holds(face, a)) return true;
        if (!cornerB && holds(face, b)) return true;
        const int u = (plane(face).axis + 1) % 3;
        const int v = (plane(face).axis + 2) % 3;
        for (const std::vector<int>& loop : brep_.faces[idx(face)]) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const int ic = loop[i];
                const PointView c = point(ic);
                const PointView d = point(loop[i + 1 < loop.size() ? i + 1 : 0]);
                Box3 box;
                box.extend(c.r);
                box.extend(d.r);
                if (!box.intersects(side.box)) continue;
                const int oc = orient2(a, b, c, u, v);
                if (oc == 0 && ic != side.a && ic != side.b && between(a, b, c, u, v)) return true;
                if (oc * orient2(a, b, d, u, v) >= 0) continue;
                if (orient2(c, d, a, u, v) * orient2(c, d, b, u, v) < 0) return true;
            }
        }
        // Without a crossing it is inside or outside as a whole.
        return cornerA && cornerB && holds(face, midpoint(a, b).view());
    }

    /// \pre on the line through a and b.
    static bool between(const PointView& a, const PointView& b, const PointView& c, int u, int v) {
        const int k = a.r[u] == b.r[u] && compare(a, b, u) == 0 ? v : u;
        return compare(a, c, k) * compare(c, b, k) > 0;
    }

    Unexpected<Error> found() const {
        return fail(Errc::SelfIntersecting,
                    "Faces " + std::to_string(std::min(culprits_[0], culprits_[1])) + " and " +
                        std::to_string(std::max(culprits_[0], culprits_[1])) +
                        " cut through or touch each other.");
    }

    const ExactBrep& brep_;
    const FacePlanes& planes_;
    std::vector<Vec3> rounded_;
    SideFacePairs pairs_;
    std::array<int, 2> culprits_{-1, -1};
};

}  // namespace

Result<void> checkCrossings(const ExactBrep& brep, const FacePlanes& planes, const Box3* within) {
    return Crossings(brep, planes, within).run();
}

}  // namespace ew
