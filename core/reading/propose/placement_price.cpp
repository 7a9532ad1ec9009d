// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/placement_price.h"

#include <algorithm>

#include "core/base/tolerance.h"
#include "core/reading/extract/model_directions.h"

namespace ew {
namespace {
std::size_t at(int i) { return static_cast<std::size_t>(i); }
}  // namespace

double misfitOf(const Sighting& sighting, const TemplateAnalysis& analysis,
                const CameraPoints& points, double noisePx) {
    const double variance = std::max(noisePx * noisePx, tol::kNoiseFloorPx * tol::kNoiseFloorPx);
    double sum = 0;
    for (const DrawnEdge& d : sighting.edges) {
        const auto& ends = analysis.edges[at(d.edge)].ends;
        const Vec2 a = points[at(ends[0])].head<2>();
        const Vec2 u = points[at(ends[1])].head<2>() - a;
        for (const Vec2& tip : d.tips) {
            const double off = cross2(u, tip - a) / std::max(u.norm(), 1e-9);
            sum += off * off / variance;
        }
    }
    return sum;
}

int strangeDirections(const Placement& placement, const TemplateAnalysis& analysis,
                      const ModelView& model) {
    const std::vector<ModelDirection>& known =
        directionsNear(model, solidFacesOf(placement.coinciding));
    std::vector<bool> strange(at(analysis.classCount), true);
    for (const AnalysedEdge& e : analysis.edges) {
        const Vec3 d =
            (placement.points[at(e.ends[1])] - placement.points[at(e.ends[0])]).normalized();
        if (std::any_of(known.begin(), known.end(), [&](const ModelDirection& k) {
                return k.direction.cross(d).norm() < tol::kSolidDirection;
            })) {
            strange[at(e.directionClass)] = false;
        }
    }
    return static_cast<int>(std::count(strange.begin(), strange.end(), true));
}

Evidence evidenceOf(const Placement& placement, double cost) {
    Evidence evidence;
    evidence.fit = placement.misfit;
    evidence.freedoms = tol::kFreedomCost * placement.parameters;
    evidence.bare = tol::kUnseenPlaneCost * placement.open;
    evidence.stray = std::max(0.0, cost - placement.cost);
    evidence.prior = cost - evidence.cost();
    return evidence;
}

}  // namespace ew
