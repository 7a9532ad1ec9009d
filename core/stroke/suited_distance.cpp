// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stroke/suited_distance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/base/camera.h"

namespace ew {
namespace {

/// Widest threshold, and widest gap that is looked at, as shares of the drawing's diagonal.
constexpr double kMostShare = 0.06;
constexpr double kReachShare = 0.12;
/// The threshold is so much wider than the gap that it is told by.
constexpr double kMargin = 1.3;
constexpr double kBridged = 0.8;
/// An end is compared with its own stroke only beyond this share of its length.
constexpr double kOwnShare = 0.5;

using Box = Eigen::AlignedBox2d;

Box boundsOf(const Stroke& stroke) {
    Box box;
    for (const PenSample& s : stroke.samples) box.extend(s.position);
    return box;
}

double nearest(const Vec2& p, const Stroke& stroke, std::size_t first, std::size_t last,
               double limit) {
    for (std::size_t i = first; i + 1 <= last; ++i) {
        limit = std::min(limit, distanceToSegment(p, stroke.samples[i].position,
                                                  stroke.samples[i + 1].position));
    }
    return limit;
}

}  // namespace

double suitedDistancePx(const std::vector<Stroke>& strokes) {
    constexpr double kDefault = Thresholds{}.distancePx;
    if (strokes.size() > kMostStrokesMeasured) return kDefault;
    std::vector<Box> boxes;
    Box all;
    for (const Stroke& s : strokes) {
        boxes.push_back(boundsOf(s));
        all.extend(boxes.back());
    }
    const double diagonal = all.isEmpty() ? 0.0 : all.diagonal().norm();
    const double most = kMostShare * diagonal;
    if (!(most > kDefault)) return kDefault;
    const double reach = kReachShare * diagonal;
    std::vector<double> gaps;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const std::size_t n = strokes[i].samples.size();
        if (n < 2) continue;
        const auto far = static_cast<std::size_t>(kOwnShare * static_cast<double>(n - 1));
        for (const bool start : {true, false}) {
            const Vec2& p =
                start ? strokes[i].samples.front().position : strokes[i].samples.back().position;
            double gap = reach;
            if (far > 0) {
                gap = start ? nearest(p, strokes[i], far, n - 1, reach)
                            : nearest(p, strokes[i], 0, n - 1 - far, reach);
            }
            for (std::size_t j = 0; j < strokes.size(); ++j) {
                if (j == i || boxes[j].exteriorDistance(p) >= gap) continue;
                const std::size_t m = strokes[j].samples.size();
                gap = std::min(gap, (p - strokes[j].samples.front().position).norm());
                gap = nearest(p, strokes[j], 0, m - 1, gap);
            }
            if (gap < reach) gaps.push_back(gap);
        }
    }
    if (gaps.empty()) return kDefault;
    const auto at =
        gaps.begin() + static_cast<std::ptrdiff_t>(kBridged * static_cast<double>(gaps.size() - 1));
    std::nth_element(gaps.begin(), at, gaps.end());
    return std::round(std::clamp(kMargin * *at, kDefault, most));
}

}  // namespace ew
