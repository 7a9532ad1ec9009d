// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/ink_on_solid.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/tolerance.h"
#include "core/reading/evidence/stroke_shares.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Eigen::AlignedBox2d boundsOf(const std::vector<Segment>& segments) {
    Eigen::AlignedBox2d box;
    for (const Segment& s : segments) {
        for (const Vec2& p : s.points) box.extend(p);
    }
    return box;
}

Eigen::AlignedBox2d grown(const Eigen::AlignedBox2d& box, double by) {
    return {box.min() - Vec2::Constant(by), box.max() + Vec2::Constant(by)};
}

/// Is a point of camera space behind the face that is seen at a place? By less than the hand can
/// tell is not behind.
bool behindFace(const ModelView& view, const Vec2& px, const Vec3& p, double distancePx) {
    const auto face = view.faceAt(px);
    if (!face) return false;
    const CameraPlane& plane = view.plane(*face);
    // The normal of a face that is seen points to the eye.
    return plane.normal.dot(p) < plane.offset - distancePx;
}

/// Does ink at q run along an edge of the placed template? What is added is not drawn where the
/// solid hides it.
bool alongEdge(const Vec2& q, const Vec3& a, const Vec3& b, bool adds, const ModelView& view,
               double near, double distancePx) {
    const Vec2 pa = a.head<2>();
    const Vec2 pb = b.head<2>();
    if (distanceToSegment(q, pa, pb, distancePx) > near) return false;
    if (!adds) return true;
    const Vec2 along = pb - pa;
    const double square = along.squaredNorm();
    const double t = square > 0.0 ? std::clamp((q - pa).dot(along) / square, 0.0, 1.0) : 0.0;
    const Vec3 p = a + t * (b - a);
    // Both places: beside a silhouette the ink may lie over what does not hide the edge.
    return !behindFace(view, q, p, distancePx) || !behindFace(view, p.head<2>(), p, distancePx);
}

/// Says of each segment of the ink how much of it runs along no edge of a placed template and along
/// none of the model.
class InkOnSolid {
  public:
    InkOnSolid(const InkReading& ink, const Placement& p, const GraphMatch& m,
               const ModelView& view, double near, double distancePx)
        : placement_(p),
          edges_(m.entry->analysis.edges),
          view_(view),
          around_(view.piecesNear(grown(boundsOf(ink.segments), tol::kAlongModel * distancePx))),
          near_(near),
          distancePx_(distancePx) {}

    double farPx(const Segment& s) const {
        const auto far = std::count_if(s.points.begin(), s.points.end(),
                                       [&](const Vec2& q) { return !drawn(q) && !redrawn(q); });
        return s.inkPx * static_cast<double>(far) / static_cast<double>(s.points.size());
    }

  private:
    bool drawn(const Vec2& q) const {
        const bool adds = placement_.operation == Operation::Add;
        const CameraPoints& points = placement_.points;
        return std::any_of(edges_.begin(), edges_.end(), [&](const AnalysedEdge& e) {
            return alongEdge(q, points[at(e.ends[0])], points[at(e.ends[1])], adds, view_, near_,
                             distancePx_);
        });
    }
    bool redrawn(const Vec2& q) const {
        return std::any_of(around_.begin(), around_.end(), [&](std::size_t i) {
            const auto& px = view_.pieces()[i].px;
            return distanceToSegment(q, px[0], px[1], 0.0) <= tol::kAlongModel * distancePx_;
        });
    }

    const Placement& placement_;
    const std::vector<AnalysedEdge>& edges_;
    const ModelView& view_;
    std::vector<std::size_t> around_;
    double near_;
    double distancePx_;
};

}  // namespace

double unexplainedInk(const InkReading& ink, const Placement& p, const GraphMatch& m,
                      const ModelView& view, double distancePx, double noisePx) {
    const double near = std::min(distancePx, std::max(0.5 * distancePx, 3.0 * noisePx));
    const InkOnSolid picture(ink, p, m, view, near, distancePx);
    double length = 0;
    for (const Segment& s : ink.segments) length += picture.farPx(s);
    return length;
}

std::vector<int> strokesBeside(const InkReading& ink, const Placement& p, const GraphMatch& m,
                               const ModelView& view, double distancePx) {
    const InkOnSolid picture(ink, p, m, view, distancePx, distancePx);
    std::map<int, StrokeShare> shares;
    for (const Segment& s : ink.segments) {
        shares[s.stroke].beside += picture.farPx(s);
        shares[s.stroke].all += s.inkPx;
    }
    return strokesLeftOut(shares, ink.noise);
}

double shareOver(const InkReading& ink, const ModelView& view) {
    constexpr std::size_t kMostAsked = 200;
    std::size_t points = 0;
    for (const Segment& s : ink.segments) points += s.points.size();
    const std::size_t step = 1 + points / kMostAsked;
    std::size_t i = 0;
    std::size_t asked = 0;
    std::size_t over = 0;
    for (const Segment& s : ink.segments) {
        for (const Vec2& p : s.points) {
            if (i++ % step != 0) continue;
            ++asked;
            if (view.faceAt(p)) ++over;
        }
    }
    return static_cast<double>(over) / static_cast<double>(std::max<std::size_t>(1, asked));
}

}  // namespace ew
