// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stroke/segmenting.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/hand_model.h"
#include "tests/support/random.h"

namespace ew {
namespace {

constexpr double kThreshold = 14.0;
constexpr double kWobble = 0.5;

Stroke strokeThrough(const std::vector<Vec2>& corners, double step) {
    Stroke s;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        const Vec2 d = corners[i + 1] - corners[i];
        const int n = std::max(1, static_cast<int>(d.norm() / step));
        for (int k = 0; k < n; ++k) {
            s.samples.push_back({corners[i] + d * (static_cast<double>(k) / n), 1.0, 0.0});
        }
    }
    s.samples.push_back({corners.back(), 1.0, 0.0});
    return s;
}

Stroke arc(double radius, double fromDeg, double toDeg) {
    Stroke s;
    for (double a = fromDeg; a <= toDeg; a += 2.0) {
        const double t = a * std::numbers::pi / 180.0;
        s.samples.push_back(
            {Vec2(400 + radius * std::cos(t), 400 + radius * std::sin(t)), 1.0, 0.0});
    }
    return s;
}

TEST(ReadStroke, ALineOfTwoSamplesIsExact) {
    const StrokeReading r =
        readStroke(strokeThrough({{100, 100}, {300, 180}}, 1e9), 3, kThreshold, kWobble);
    ASSERT_EQ(r.kind, StrokeKind::Polyline);
    ASSERT_EQ(r.segments.size(), 1u);
    EXPECT_EQ(r.segments[0].stroke, 3);
    EXPECT_LT((r.segments[0].a - Vec2(100, 100)).norm(), 1e-9);
    EXPECT_LT((r.segments[0].b - Vec2(300, 180)).norm(), 1e-9);
}

TEST(ReadStroke, CornersOfAnExactPolylineAreExactAtAnyDensity) {
    const std::vector<Vec2> corners{{100, 100}, {260, 120}, {240, 260}, {120, 300}, {100, 100}};
    for (const double step : {0.4, 3.0, 7.0, 1e9}) {
        const StrokeReading r = readStroke(strokeThrough(corners, step), 0, kThreshold, kWobble);
        ASSERT_EQ(r.segments.size(), 4u) << "step " << step;
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_LT((r.segments[i].a - corners[i]).norm(), 1e-6) << "step " << step;
            EXPECT_LT((r.segments[i].b - corners[i + 1]).norm(), 1e-6) << "step " << step;
            EXPECT_EQ(r.segments[i].joinedToNext, i < 3);
        }
    }
}

TEST(ReadStroke, ALineDrawnThereAndBackIsOneSegment) {
    const StrokeReading r =
        readStroke(strokeThrough({{100, 100}, {300, 100}, {100, 101}}, 4), 0, kThreshold, kWobble);
    ASSERT_EQ(r.kind, StrokeKind::Polyline);
    double longest = 0;
    for (const Segment& s : r.segments) {
        EXPECT_LT(std::abs((s.b - s.a).normalized().y()), 0.02);
        longest = std::max(longest, (s.b - s.a).norm());
    }
    EXPECT_NEAR(longest, 200, 1);
}

TEST(ReadStroke, AHookIsTrimmed) {
    const StrokeReading r = readStroke(
        strokeThrough({{97, 106}, {100, 100}, {300, 100}, {303, 95}}, 1.5), 0, kThreshold, kWobble);
    ASSERT_EQ(r.segments.size(), 1u);
    EXPECT_LT((r.segments[0].a - Vec2(100, 100)).norm(), 3.0);
    EXPECT_LT((r.segments[0].b - Vec2(300, 100)).norm(), 3.0);
}

TEST(ReadStroke, AShortEdgeAtTheEndIsNoHook) {
    // It turns back as a hook does, but it is longer than one.
    const std::vector<Vec2> corners{{345, 340}, {358.8, 355.2}, {335, 361.8}};
    const StrokeReading r = readStroke(strokeThrough(corners, 1.5), 0, kThreshold, kWobble);
    ASSERT_EQ(r.segments.size(), 2u);
    EXPECT_LT((r.segments[0].a - corners[0]).norm(), 0.1);
    EXPECT_LT((r.segments[0].b - corners[1]).norm(), 0.1);
    EXPECT_LT((r.segments[1].b - corners[2]).norm(), 0.1);
}

TEST(ReadStroke, DotsCirclesAndScribblesAreNoLines) {
    EXPECT_EQ(readStroke(strokeThrough({{5, 5}, {8, 7}}, 1), 0, kThreshold, kWobble).kind,
              StrokeKind::Dot);
    Stroke one;
    one.samples.push_back({Vec2(5, 5), 1, 0});
    EXPECT_EQ(readStroke(one, 0, kThreshold, kWobble).kind, StrokeKind::Dot);
    EXPECT_EQ(readStroke(arc(80, 0, 358), 0, kThreshold, kWobble).kind, StrokeKind::Curve);
    EXPECT_EQ(readStroke(arc(120, 10, 170), 0, kThreshold, kWobble).kind, StrokeKind::Curve);
    test::Random random(7);
    std::vector<Vec2> tangle;
    for (int i = 0; i < 60; ++i)
        tangle.emplace_back(random.uniform(100, 160), random.uniform(100, 160));
    EXPECT_EQ(readStroke(strokeThrough(tangle, 3), 0, kThreshold, kWobble).kind,
              StrokeKind::Scribble);
}

// Cut into four, a circle turns by a right angle at each cut, as a rectangle does; only that it
// turns all the way tells them apart.
TEST(ReadStroke, CirclesOfEverySizeAndHandAreCurves) {
    int lines = 0;
    for (const double radius : {10.0, 16.0, 25.0, 40.0, 60.0, 90.0}) {
        for (int i = 0; i < 12; ++i) {
            test::Random random(test::Random::mix(3, static_cast<std::uint64_t>(i)));
            Stroke s = arc(radius, 30.0 * i, 30.0 * i + 372.0);
            const double wave = random.uniform(2.0, 3.0);
            const double bend = random.uniform(0.0, 0.07) * radius;
            for (PenSample& p : s.samples) {
                const Vec2 out = (p.position - Vec2(400, 400)).normalized();
                p.position += bend * std::sin(wave * std::atan2(out.y(), out.x()) + i) * out;
            }
            const StrokeKind kind = readStroke(s, 0, kThreshold, 1.0).kind;
            lines += kind == StrokeKind::Polyline ? 1 : 0;
        }
    }
    EXPECT_LE(lines, 1);
}

TEST(ReadStroke, RoundedRectanglesAreNoCircles) {
    for (const double radius : {4.0, 8.0, 14.0}) {
        Stroke s;
        const std::vector<Vec2> centers{{600, 480}, {400, 480}, {400, 400}, {600, 400}};
        for (std::size_t c = 0; c < 4; ++c) {
            for (double a = 0; a <= 90; a += 6) {
                const double t = (90.0 * static_cast<double>(c) + a) * std::numbers::pi / 180.0;
                s.samples.push_back(
                    {centers[c] + radius * Vec2(std::cos(t), std::sin(t)), 1.0, 0.0});
            }
        }
        s.samples.push_back(s.samples.front());
        EXPECT_EQ(readStroke(s, 0, kThreshold, 1.0).kind, StrokeKind::Polyline) << radius;
    }
}

TEST(ReadStroke, AHexagonIsNoCircle) {
    std::vector<Vec2> corners;
    for (int i = 0; i <= 6; ++i) {
        const double t = i * std::numbers::pi / 3;
        corners.emplace_back(300 + 90 * std::cos(t), 300 + 90 * std::sin(t));
    }
    const StrokeReading r = readStroke(strokeThrough(corners, 4), 0, kThreshold, kWobble);
    EXPECT_EQ(r.kind, StrokeKind::Polyline);
    EXPECT_EQ(r.segments.size(), 6u);
}

TEST(ReadStroke, AMillionSamplesReadAsTheirOutlineDoes) {
    const std::vector<Vec2> corners{{100, 100}, {400, 130}, {380, 400}};
    const StrokeReading dense = readStroke(strokeThrough(corners, 0.0006), 0, kThreshold, kWobble);
    ASSERT_EQ(dense.segments.size(), 2u);
    EXPECT_LT((dense.segments[0].b - corners[1]).norm(), 0.01);
}

RC_GTEST_PROP(ReadStroke, AWobblyEdgeStaysOneSegment, ()) {
    const auto seed = *rc::gen::inRange<std::uint64_t>(0, 1u << 20);
    test::Random random(seed);
    const Vec2 a(random.uniform(100, 300), random.uniform(100, 300));
    const Vec2 b = a + random.uniform(80, 260) * random.direction();
    test::HandHabits habits;
    habits.cutProbability = 0;
    const auto strokes =
        test::drawByHand({{a, b}}, test::HandLevel{1.2, 3, 0, 0, 0}, random, habits);
    RC_ASSERT(strokes.size() == 1u);
    const StrokeReading r = readStroke(strokes[0], 0, kThreshold, 2.2);
    RC_ASSERT(r.segments.size() == 1u);
}

RC_GTEST_PROP(ReadStroke, ReversingAStrokeGivesTheSameLines, ()) {
    const auto seed = *rc::gen::inRange<std::uint64_t>(0, 1u << 20);
    test::Random random(seed);
    std::vector<Vec2> corners{{300, 300}};
    double angle = random.uniform(0, 6);
    for (int i = 0; i < 4; ++i) {
        corners.push_back(corners.back() +
                          random.uniform(60, 150) * Vec2(std::cos(angle), std::sin(angle)));
        angle += random.uniform(0.7, 2.2) * (random.chance(0.5) ? 1 : -1);
    }
    const Stroke forward = strokeThrough(corners, 3.7);
    Stroke backward = forward;
    std::reverse(backward.samples.begin(), backward.samples.end());
    const auto f = readStroke(forward, 0, kThreshold, kWobble);
    const auto b = readStroke(backward, 0, kThreshold, kWobble);
    RC_ASSERT(f.segments.size() == 4u);
    RC_ASSERT(b.segments.size() == 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        RC_ASSERT((f.segments[i].a - b.segments[3 - i].b).norm() < 1e-6);
        RC_ASSERT((f.segments[i].b - b.segments[3 - i].a).norm() < 1e-6);
    }
}

TEST(ValidateStroke, RefusesWhatIsNoPosition) {
    Stroke s = strokeThrough({{0, 0}, {10, 10}}, 1);
    EXPECT_TRUE(validateStroke(s));
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e308, -1e7}) {
        Stroke t = s;
        t.samples[3].position.x() = bad;
        const auto r = validateStroke(t);
        ASSERT_FALSE(r);
        EXPECT_EQ(r.error().code, Errc::BadCoordinates);
        EXPECT_NE(r.error().message.find("3"), std::string::npos);
    }
    Stroke huge;
    huge.samples.resize(kMaxSamplesPerStroke + 1);
    EXPECT_EQ(validateStroke(huge).error().code, Errc::TooManyPoints);
    EXPECT_EQ(validateStroke(Stroke{}).error().code, Errc::EmptySketch);
}

}  // namespace
}  // namespace ew
