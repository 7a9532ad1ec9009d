// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/hand_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/hand/hand_plan.h"
#include "tests/support/sketch_generator.h"

namespace ew::test {
namespace {

double distance(const Vec2& p, const Line2& s) {
    const Vec2 d = s[1] - s[0];
    const double t = std::clamp((p - s[0]).dot(d) / d.squaredNorm(), 0.0, 1.0);
    return (p - (s[0] + t * d)).norm();
}

std::vector<Line2> drawing(const std::string& id, std::uint64_t seed) {
    Random random(seed);
    return randomSketch(id, random).drawing.lines();
}

TEST(HandModel, TheExactHandIsExactAndComplete) {
    for (const std::string& id : sketchTemplates()) {
        for (std::uint64_t seed = 0; seed < 40; ++seed) {
            const std::vector<Line2> lines = drawing(id, seed);
            Random random(seed);
            const std::vector<Stroke> strokes = drawByHand(lines, kExactHand, random);
            std::vector<double> drawn(lines.size(), 0.0);
            for (const Stroke& stroke : strokes) {
                for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
                    const Vec2& p = stroke.samples[i].position;
                    double nearest = 1e9;
                    for (std::size_t k = 0; k < lines.size(); ++k) {
                        nearest = std::min(nearest, distance(p, lines[k]));
                        if (i == 0) continue;
                        // A step between two samples of one line draws that much of it: no step
                        // may cut a corner.
                        const Vec2& before = stroke.samples[i - 1].position;
                        if (distance(p, lines[k]) < 1e-9 && distance(before, lines[k]) < 1e-9) {
                            drawn[k] += (p - before).norm();
                        }
                    }
                    EXPECT_LT(nearest, 1e-9);
                }
            }
            for (std::size_t k = 0; k < lines.size(); ++k) {
                EXPECT_GE(drawn[k], (lines[k][1] - lines[k][0]).norm() - 1e-6) << id << seed;
            }
        }
    }
}

TEST(HandModel, TimeRunsAndSamplesAreClose) {
    Random random(4);
    for (const HandLevel& level : {kExactHand, kLightHand, kNormalHand, kRoughHand}) {
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            for (const Stroke& s : drawByHand(drawing("cube", seed), level, random)) {
                ASSERT_TRUE(validateStroke(s));
                ASSERT_GE(s.samples.size(), 3U);
                EXPECT_EQ(s.samples.front().timeMs, 0.0);
                for (std::size_t i = 1; i < s.samples.size(); ++i) {
                    EXPECT_GT(s.samples[i].timeMs, s.samples[i - 1].timeMs);
                    EXPECT_LT((s.samples[i].position - s.samples[i - 1].position).norm(), 9.0);
                    EXPECT_GE(s.samples[i].pressure, 0.0);
                    EXPECT_LE(s.samples[i].pressure, 1.0);
                }
            }
        }
    }
}

TEST(HandModel, WobbleIsTheStandardDeviationAcrossAndEndsStayInTheirDisc) {
    const std::vector<Line2> line{{Vec2(100, 300), Vec2(500, 300)}};
    for (const HandLevel& named : {kLightHand, kNormalHand, kRoughHand}) {
        HandLevel level = named;
        level.hookPx = level.overtraceProbability = level.breakProbability = 0;
        HandHabits habits;
        habits.cutProbability = 0;
        Random random(9);
        double sum = 0;
        int count = 0;
        double farthestEnd = 0;
        for (int i = 0; i < 400; ++i) {
            const auto strokes = drawByHand(line, level, random, habits);
            ASSERT_EQ(strokes.size(), 1U);
            const auto& samples = strokes[0].samples;
            for (const Vec2& end : {samples.front().position, samples.back().position}) {
                farthestEnd = std::max(
                    farthestEnd, std::min((end - line[0][0]).norm(), (end - line[0][1]).norm()));
            }
            const Vec2 a = samples.front().position;
            const Vec2 d = (samples.back().position - a).normalized();
            for (const PenSample& s : samples) {
                const double along = (s.position - a).dot(d);
                if (along < 20 || along > 380) continue;
                sum += std::pow(cross2(d, s.position - a), 2);
                ++count;
            }
        }
        EXPECT_NEAR(std::sqrt(sum / count) / level.wobblePx, 1.0, 0.08);
        // The tremor of a tenth of the wobble comes on top.
        EXPECT_LT(farthestEnd, level.endErrorPx + 0.6 * level.wobblePx);
        EXPECT_GT(farthestEnd, 0.9 * level.endErrorPx);
    }
}

TEST(HandModel, EdgesAreOvertracedAndBrokenAsOftenAsNamed) {
    const std::vector<Line2> line{{Vec2(100, 300), Vec2(400, 200)}};
    HandHabits habits;
    habits.cutProbability = 0;
    Random random(2);
    int overtraced = 0;
    int broken = 0;
    constexpr int kDrawings = 4000;
    for (int i = 0; i < kDrawings; ++i) {
        const auto plans = planStrokes(line, kRoughHand, habits, random);
        const auto brokenEnds = std::count_if(
            plans.begin(), plans.end(), [](const auto& p) { return p.brokenStart || p.brokenEnd; });
        broken += brokenEnds > 0 ? 1 : 0;
        overtraced += static_cast<int>(plans.size()) - (brokenEnds > 0 ? 2 : 1);
    }
    EXPECT_NEAR(1.0 * overtraced / kDrawings, kRoughHand.overtraceProbability, 0.03);
    EXPECT_NEAR(1.0 * broken / kDrawings, kRoughHand.breakProbability, 0.03);
}

TEST(HandModel, DrawsSingleEdgesAndWholeDrawings) {
    const std::vector<Line2> lines = drawing("cube", 1);
    HandHabits single{1, 0, 0, 0};
    single.cutProbability = 0;
    Random random(1);
    EXPECT_EQ(planStrokes(lines, kExactHand, single, random).size(), 9U);
    HandHabits whole{0, 0, 0, 1};
    whole.cutProbability = 0;
    whole.withoutLifting = 1;
    EXPECT_EQ(planStrokes(lines, kExactHand, whole, random).size(), 1U);
    HandHabits faces{0, 0, 1, 0};
    faces.cutProbability = 0;
    bool closed = false;
    for (const PlannedStroke& p : planStrokes(lines, kExactHand, faces, random)) {
        closed |= p.points.size() == 5 && p.points.front() == p.points.back();
    }
    EXPECT_TRUE(closed);
}

TEST(HandModel, IsDeterministic) {
    const std::vector<Line2> lines = drawing("l-prism", 3);
    Random a(6), b(6);
    const auto first = drawByHand(lines, kRoughHand, a);
    const auto second = drawByHand(lines, kRoughHand, b);
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i) {
        ASSERT_EQ(first[i].samples.size(), second[i].samples.size());
        for (std::size_t k = 0; k < first[i].samples.size(); ++k) {
            EXPECT_EQ(first[i].samples[k].position, second[i].samples[k].position);
        }
    }
}

}  // namespace
}  // namespace ew::test
