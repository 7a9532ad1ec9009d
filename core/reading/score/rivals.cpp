// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/score/rivals.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "core/base/tolerance.h"
#include "core/reading/evidence/accidental.h"
#include "core/reading/types/reading_params.h"

namespace ew {
namespace {

/// Is one of them a box of which just those two faces are drawn that the other shows? Two faces
/// that people draw are mostly those of a box.
bool sameTwoFaces(const RatedCandidate& best, const RatedCandidate& other) {
    return other.match.aspect->edgeOn && best.match.aspect->visibleFaces.size() == 2 &&
           best.match.edge.size() == other.match.edge.size();
}

double clearMargin(const RatedCandidate& best, const RatedCandidate& other) {
    if (best.candidate.missingEdges + best.candidate.extraEdges > 0) {
        return tol::kClearMarginImperfect;
    }
    if (sameTwoFaces(best, other)) return params::kPlainerMarginPoor;
    if (other.parameters >= best.parameters) return tol::kClearMargin;
    return fitsPoorly(best) ? params::kPlainerMarginPoor : params::kPlainerMargin;
}

/// Width of the strip that holds the picture of all points [px].
double narrowest(const CameraPoints& points) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t k = i + 1; k < points.size(); ++k) {
            const Vec2 d = points[k].head<2>() - points[i].head<2>();
            if (d.norm() == 0.0) continue;
            const Vec2 across = Vec2(-d.y(), d.x()).normalized();
            double low = std::numeric_limits<double>::infinity();
            double high = -low;
            for (const Vec3& p : points) {
                low = std::min(low, across.dot(p.head<2>()));
                high = std::max(high, across.dot(p.head<2>()));
            }
            least = std::min(least, high - low);
        }
    }
    return least;
}

}  // namespace

bool fitsPoorly(const RatedCandidate& c) {
    const auto ends = static_cast<double>(2 * c.match.edge.size());
    return c.cost - params::kFreedomCost * c.parameters > params::kPoorFitPerEnd * ends;
}

bool isRival(const RatedCandidate& best, const RatedCandidate& other) {
    if (best.candidate.templateId == other.candidate.templateId) return false;
    return (sameTwoFaces(best, other) || other.withinThresholds) &&
           other.cost < best.cost + clearMargin(best, other);
}

bool isAbsurd(const RatedCandidate& c, double handPx, double distancePx, double worldPerPixel) {
    if (narrowest(c.drawn) < distancePx) return true;
    // Where relations leave depth open it is a choice, not what was drawn.
    const bool told = c.entry->analysis.rectilinear.has_value();
    for (const int e : c.match.edge) {
        if (!told) break;
        const auto& ends = c.entry->analysis.edges[static_cast<std::size_t>(e)].ends;
        const Vec3 along =
            c.drawn[static_cast<std::size_t>(ends[1])] - c.drawn[static_cast<std::size_t>(ends[0])];
        if (along.norm() > params::kMostForeshortening * along.head<2>().norm()) return true;
    }
    Eigen::AlignedBox3d body;
    for (const Vec3& v : c.candidate.spec.vertices) body.extend(v);
    const double thinnestPx = body.sizes().minCoeff() / worldPerPixel;
    return thinnestPx < handPx;
}

bool looksAccidental(const RatedCandidate& c) {
    return hidesItsTaper(*c.entry, *c.match.aspect, c.drawn);
}

void sortCandidates(std::vector<RatedCandidate>& candidates) {
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const RatedCandidate& a, const RatedCandidate& b) {
                         if (a.withinThresholds != b.withinThresholds) return a.withinThresholds;
                         return a.cost < b.cost;
                     });
}

}  // namespace ew
