// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/modeling/ink_on_solid.h"

#include <algorithm>
#include <cmath>

#include "core/base/tolerance.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

double handNoisePx(const InkReading& ink) {
    return std::max(tol::kMissPerWobble * ink.wobblePx,
                    std::min(tol::kMissAtLeastPx, tol::kMissPerSteadyWobble * ink.wobblePx));
}

double endSpread(const std::vector<Segment>& segments, double distancePx) {
    std::vector<double> squares;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        for (const Vec2& p : {segments[i].a, segments[i].b}) {
            double least = distancePx * distancePx;
            bool found = false;
            for (std::size_t j = 0; j < segments.size(); ++j) {
                if (segments[j].stroke == segments[i].stroke) continue;
                for (const Vec2& q : {segments[j].a, segments[j].b}) {
                    if ((p - q).squaredNorm() > least) continue;
                    least = (p - q).squaredNorm();
                    found = true;
                }
            }
            if (found) squares.push_back(least);
        }
    }
    if (squares.empty()) return 0.0;
    // Half of the pairs lie within 2.77 variances per axis of the difference of two ends, which has
    // twice the variance of one: the median is not misled by ends that meet by chance.
    const auto middle = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
    std::nth_element(squares.begin(), middle, squares.end());
    return std::sqrt(*middle / 2.77);
}

namespace {

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

}  // namespace

double unexplainedInk(const InkReading& ink, const Placement& p, const GraphMatch& m,
                      const ModelView& view, double distancePx, double noisePx) {
    const double near = std::min(distancePx, std::max(0.5 * distancePx, 3.0 * noisePx));
    const bool adds = p.operation == Operation::Add;
    const std::vector<std::size_t> around =
        view.piecesNear(grown(boundsOf(ink.segments), tol::kAlongModel * distancePx));
    double length = 0;
    for (const Segment& s : ink.segments) {
        std::size_t far = 0;
        for (const Vec2& q : s.points) {
            const auto& edges = m.entry->analysis.edges;
            const bool drawn = std::any_of(edges.begin(), edges.end(), [&](const AnalysedEdge& e) {
                return alongEdge(q, p.points[at(e.ends[0])], p.points[at(e.ends[1])], adds, view,
                                 near, distancePx);
            });
            const bool redrawn =
                !drawn && std::any_of(around.begin(), around.end(), [&](std::size_t i) {
                    const auto& px = view.pieces()[i].px;
                    return distanceToSegment(q, px[0], px[1], 0.0) <= tol::kAlongModel * distancePx;
                });
            if (!drawn && !redrawn) ++far;
        }
        length += s.inkPx * static_cast<double>(far) / static_cast<double>(s.points.size());
    }
    return length;
}

}  // namespace ew
