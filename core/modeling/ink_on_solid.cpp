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

double unexplainedInk(const InkReading& ink, const Placement& p, const GraphMatch& m,
                      const ModelView& view, double distancePx, double noisePx) {
    const double near = std::min(distancePx, std::max(0.5 * distancePx, 3.0 * noisePx));
    double length = 0;
    for (const Segment& s : ink.segments) {
        std::size_t far = 0;
        for (const Vec2& q : s.points) {
            const auto& edges = m.entry->analysis.edges;
            const bool drawn = std::any_of(edges.begin(), edges.end(), [&](const AnalysedEdge& e) {
                return distanceToSegment(q, p.points[at(e.ends[0])].head<2>(),
                                         p.points[at(e.ends[1])].head<2>(), distancePx) <= near;
            });
            const bool redrawn =
                !drawn &&
                std::any_of(view.pieces().begin(), view.pieces().end(), [&](const VisiblePiece& v) {
                    return distanceToSegment(q, v.px[0], v.px[1], 0.0) <=
                           tol::kAlongModel * distancePx;
                });
            if (!drawn && !redrawn) ++far;
        }
        length += s.inkPx * static_cast<double>(far) / static_cast<double>(s.points.size());
    }
    return length;
}

}  // namespace ew
