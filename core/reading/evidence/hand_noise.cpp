// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/evidence/hand_noise.h"

#include <algorithm>
#include <cmath>

#include "core/base/tolerance.h"

namespace ew {

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

}  // namespace ew
