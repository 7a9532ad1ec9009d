// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stroke/suited_distance.h"

#include <gtest/gtest.h>

namespace ew {
namespace {

constexpr double kDefault = Thresholds{}.distancePx;

Stroke line(const Vec2& a, const Vec2& b) {
    Stroke s;
    for (int i = 0; i <= 20; ++i) s.samples.push_back({a + i / 20.0 * (b - a), 1.0, 0.0});
    return s;
}

/// A triangle whose corners stay open by a gap.
std::vector<Stroke> openTriangle(double sizePx, double gapPx) {
    const std::vector<Vec2> p{{0, 0}, {sizePx, 0}, {0.5 * sizePx, 0.8 * sizePx}};
    std::vector<Stroke> out;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec2 d = (p[(i + 1) % 3] - p[i]).normalized();
        out.push_back(line(p[i] + gapPx * d, p[(i + 1) % 3]));
    }
    return out;
}

TEST(SuitedDistance, ASteadyHandKeepsTheDefault) {
    EXPECT_EQ(suitedDistancePx({}), kDefault);
    EXPECT_EQ(suitedDistancePx(openTriangle(500, 0)), kDefault);
    EXPECT_EQ(suitedDistancePx(openTriangle(500, 8)), kDefault);
    EXPECT_EQ(suitedDistancePx({line({0, 0}, {600, 10})}), kDefault);
}

TEST(SuitedDistance, WideGapsInALargeDrawingWidenIt) {
    const double suited = suitedDistancePx(openTriangle(500, 20));
    EXPECT_GT(suited, 20.0);
    EXPECT_LT(suited, 40.0);
    EXPECT_GT(suitedDistancePx(openTriangle(1000, 40)), 40.0);
}

TEST(SuitedDistance, SmallDrawingsDoNot) {
    EXPECT_EQ(suitedDistancePx(openTriangle(120, 12)), kDefault);
}

TEST(SuitedDistance, MoreStrokesThanAreReadAtOnceAreNotMeasured) {
    std::vector<Stroke> strokes;
    while (strokes.size() < kMostStrokesMeasured) {
        // Each somewhere else, so that its gaps are open.
        const Vec2 at(3000.0 * static_cast<double>(strokes.size()), 0.0);
        for (Stroke& s : openTriangle(500, 20)) {
            for (PenSample& p : s.samples) p.position += at;
            strokes.push_back(std::move(s));
        }
    }
    ASSERT_EQ(strokes.size(), kMostStrokesMeasured);
    EXPECT_GT(suitedDistancePx(strokes), kDefault);
    strokes.push_back(strokes.front());
    EXPECT_EQ(suitedDistancePx(strokes), kDefault);
}

TEST(SuitedDistance, ItIsTheSameForEveryOrderAndDirection) {
    std::vector<Stroke> strokes = openTriangle(500, 20);
    const double suited = suitedDistancePx(strokes);
    std::reverse(strokes.begin(), strokes.end());
    for (Stroke& s : strokes) std::reverse(s.samples.begin(), s.samples.end());
    EXPECT_EQ(suitedDistancePx(strokes), suited);
}

TEST(SuitedDistance, ABoundedShareOfTheDrawing) {
    EXPECT_LT(suitedDistancePx(openTriangle(500, 60)), 0.061 * 650);
}

}  // namespace
}  // namespace ew
