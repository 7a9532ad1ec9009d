// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stroke/rounded_corners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/random.h"

namespace ew {
namespace {

constexpr double kThreshold = 14.0;
constexpr double kWobble = 0.5;

/// A polygon whose corners are arcs of a radius, of so many pieces, as one closed stroke.
std::vector<Vec2> rounded(const std::vector<Vec2>& corners, double radius, int pieces) {
    std::vector<Vec2> out;
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 in = (corners[i] - corners[(i + n - 1) % n]).normalized();
        const Vec2 next = (corners[(i + 1) % n] - corners[i]).normalized();
        const double turn = std::atan2(cross2(in, next), in.dot(next));
        const double back = radius * std::tan(std::abs(turn) / 2.0);
        const Vec2 side = (turn > 0 ? 1.0 : -1.0) * Vec2(-in.y(), in.x());
        const Vec2 start = corners[i] - back * in;
        for (int k = 0; k <= pieces; ++k) {
            const double a = std::abs(turn) * k / pieces;
            out.push_back(start + radius * (std::sin(a) * in + (1.0 - std::cos(a)) * side));
        }
    }
    out.push_back(out.front());
    return out;
}

Stroke strokeOf(const std::vector<Vec2>& points) {
    Stroke s;
    for (const Vec2& p : points) s.samples.push_back({p, 1.0, 0.0});
    return s;
}

/// The same path, with a sample every so many px, and moved by noise.
Stroke sampled(const std::vector<Vec2>& points, double step, double noise) {
    Random random(5);
    Stroke s;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Vec2 d = points[i + 1] - points[i];
        const int n = std::max(1, static_cast<int>(d.norm() / step));
        for (int k = 0; k < n; ++k) {
            const Vec2 off(random.uniform(-noise, noise), random.uniform(-noise, noise));
            s.samples.push_back({points[i] + d * (static_cast<double>(k) / n) + off, 1.0, 0.0});
        }
    }
    s.samples.push_back({points.back(), 1.0, 0.0});
    return s;
}

const std::vector<Vec2> kFront{{500, 300}, {660, 350}, {660, 470}, {500, 420}};

void expectSides(const StrokeReading& r, const std::vector<Vec2>& corners, double nearPx) {
    ASSERT_EQ(r.kind, StrokeKind::Polyline);
    ASSERT_GE(r.segments.size(), corners.size());
    for (const Vec2& c : corners) {
        double near = 1e9;
        for (const Segment& s : r.segments) {
            near = std::min({near, (s.a - c).norm(), (s.b - c).norm()});
        }
        EXPECT_LT(near, nearPx) << c.transpose();
    }
}

TEST(RoundedCorners, AreTheCornersInWhichTheSidesMeet) {
    for (const double radius : {12.0, 22.0, 30.0}) {
        SCOPED_TRACE(radius);
        const StrokeReading r =
            readStroke(strokeOf(rounded(kFront, radius, 4)), 0, kThreshold, kWobble);
        expectSides(r, kFront, 0.5);
        EXPECT_EQ(r.segments.size(), 4U);
    }
}

TEST(RoundedCorners, AHandMayRoundThem) {
    expectSides(readStroke(sampled(rounded(kFront, 22.0, 12), 3.0, 0.4), 0, kThreshold, kWobble),
                kFront, 3.0);
}

TEST(RoundedCorners, AStrokeMayBeginInTheMiddleOfASide) {
    std::vector<Vec2> loop = rounded(kFront, 22.0, 4);
    loop.pop_back();
    // Between the last point of the first arc and the first of the second.
    const Vec2 middle = 0.5 * (loop[4] + loop[5]);
    std::rotate(loop.begin(), loop.begin() + 5, loop.end());
    loop.insert(loop.begin(), middle);
    loop.push_back(middle);
    const StrokeReading r = readStroke(strokeOf(loop), 0, kThreshold, kWobble);
    expectSides(r, kFront, 0.5);
    EXPECT_EQ(r.segments.size(), 5U);
}

TEST(RoundedCorners, CurvesHaveNone) {
    std::vector<Vec2> circle;
    std::vector<Vec2> ellipse;
    for (int k = 0; k <= 60; ++k) {
        const double a = 2.0 * std::numbers::pi * k / 60;
        circle.emplace_back(400 + 80 * std::cos(a), 400 + 80 * std::sin(a));
        ellipse.emplace_back(400 + 150 * std::cos(a), 400 + 40 * std::sin(a));
    }
    EXPECT_EQ(readStroke(strokeOf(circle), 0, kThreshold, kWobble).kind, StrokeKind::Curve);
    EXPECT_EQ(readStroke(strokeOf(ellipse), 0, kThreshold, kWobble).kind, StrokeKind::Curve);
    // A slot: two sides, and half a circle at both ends.
    const std::vector<Vec2> ends{{300, 300}, {600, 300}, {600, 360}, {300, 360}};
    EXPECT_GT(readStroke(strokeOf(rounded(ends, 30.0, 12)), 0, kThreshold, kWobble).segments.size(),
              6U);
}

TEST(RoundedCorners, AChamferIsASide) {
    const std::vector<Vec2> cut{{300, 300}, {480, 300}, {510, 330},
                                {510, 450}, {300, 450}, {300, 300}};
    const StrokeReading r = readStroke(strokeOf(cut), 0, kThreshold, kWobble);
    ASSERT_EQ(r.kind, StrokeKind::Polyline);
    EXPECT_EQ(r.segments.size(), 5U);
    // Two in a row.
    const std::vector<Vec2> twice{{300, 300}, {470, 300}, {496, 311}, {507, 337},
                                  {507, 480}, {300, 480}, {300, 300}};
    EXPECT_EQ(readStroke(strokeOf(twice), 0, kThreshold, kWobble).segments.size(), 6U);
}

}  // namespace
}  // namespace ew
