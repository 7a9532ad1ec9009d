// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/sketch_generator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/support/random_shapes.h"

namespace ew::test {
namespace {

TEST(SketchGenerator, KeepsItsPromises) {
    for (const std::string& id : sketchTemplates()) {
        ReadabilityCounts counts;
        for (std::uint64_t seed = 0; seed < 100; ++seed) {
            Random random(seed);
            const SketchCase s = randomSketch(id, random, &counts);
            EXPECT_EQ(unreadableBecause(s, {}), "");
            EXPECT_EQ(s.truth.templateId, id);
            EXPECT_GT(s.truth.volume, 0.0);
            EXPECT_EQ(s.truth.vertices - s.truth.edges + s.truth.faces, 2);
            ASSERT_TRUE(s.camera.validate());
            const double tilt = std::asin(-s.camera.direction.z()) * 180 / std::numbers::pi;
            EXPECT_GE(tilt, 15.0);
            EXPECT_LE(tilt, 65.0);
            Vec2 low(1e9, 1e9), high(-1e9, -1e9);
            for (const Line2& line : s.drawing.lines()) {
                for (const Vec2& p : line) {
                    low = low.cwiseMin(p);
                    high = high.cwiseMax(p);
                }
            }
            EXPECT_GE((high - low).norm(), 150.0 - 1e-6);
            EXPECT_LE((high - low).norm(), 500.0 + 1e-6);
            EXPECT_LT(((high + low) / 2 - Vec2(640, 400)).norm(), 1e-6);
        }
        EXPECT_EQ(counts.tried - counts.rejectedTotal(), 100) << id;
    }
}

TEST(SketchGenerator, IsDeterministic) {
    for (const std::string& id : sketchTemplates()) {
        Random a(7), b(7), c(8);
        const SketchCase first = randomSketch(id, a);
        EXPECT_EQ(first.spec.vertices, randomSketch(id, b).spec.vertices);
        EXPECT_NE(first.spec.vertices, randomSketch(id, c).spec.vertices);
    }
}

TEST(SketchGenerator, KnowsTheCornerAnglesOfACubeSeenFromItsDiagonal) {
    SketchCase s;
    Random random(3);
    s = randomSketch("cube", random);
    ASSERT_TRUE(s.truth.yAnglesDeg);
    double sum = 0;
    for (const double angle : *s.truth.yAnglesDeg) {
        EXPECT_GT(angle, 90.0);  // Perkins' law
        sum += angle;
    }
    EXPECT_NEAR(sum, 360.0, 1e-9);
}

TEST(SketchGenerator, RefusesWhatNobodyCanRead) {
    Random random(11);
    const SketchCase good = randomSketch("cube", random);
    ReadabilityRules rules;
    rules.shortestEdgePx = 1000;
    EXPECT_EQ(unreadableBecause(good, rules), "short-edge");
    rules = {};
    rules.nearestJunctionsPx = 1000;
    EXPECT_EQ(unreadableBecause(good, rules), "near-junctions");
    rules = {};
    rules.nearestLinePx = 1000;
    EXPECT_EQ(unreadableBecause(good, rules), "near-line");
    rules = {};
    rules.sharpestDeg = 170;
    EXPECT_EQ(unreadableBecause(good, rules), "sharp-corner");
    rules = {};
    rules.straightestDeg = 179;
    EXPECT_EQ(unreadableBecause(good, rules), "straight-corner");
    rules = {};
    rules.fewestFaces = 4;
    EXPECT_EQ(unreadableBecause(good, rules), "few-faces");
    const SketchCase frustum = randomSketch("wedge-frustum", random);
    rules = {};
    rules.frustumTaperDeg = 180;
    EXPECT_EQ(unreadableBecause(frustum, rules), "looks-like-box");
}

TEST(SketchScriptText, ReadsBackToTheBit) {
    Random random(5);
    const SketchCase s = randomSketch("wedge-frustum", random);
    const std::vector<Stroke> strokes = drawByHand(s.drawing.lines(), kNormalHand, random);
    const auto json = nlohmann::json::parse(
        sketchScriptText("a \"title\"\n", s.camera, Thresholds{14.5, 12}, strokes));
    EXPECT_EQ(json["format"], "edgewright-sketch");
    EXPECT_EQ(json["title"], "a \"title\" ");
    EXPECT_EQ(json["thresholds"]["distance_px"], 14.5);
    const auto& steps = json["steps"];
    ASSERT_EQ(steps.size(), strokes.size() + 2);
    EXPECT_EQ(steps[0]["world_per_pixel"].get<double>(), s.camera.worldPerPixel);
    EXPECT_EQ(steps[0]["direction"][1].get<double>(), s.camera.direction.y());
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        const auto& points = steps[i + 1]["points"];
        ASSERT_EQ(points.size(), strokes[i].samples.size());
        for (std::size_t k = 0; k < points.size(); ++k) {
            EXPECT_EQ(points[k][0].get<double>(), strokes[i].samples[k].position.x());
            EXPECT_EQ(points[k][1].get<double>(), strokes[i].samples[k].position.y());
            EXPECT_EQ(points[k][3].get<double>(), strokes[i].samples[k].timeMs);
        }
    }
    EXPECT_EQ(steps.back()["do"], "apply");
}

}  // namespace
}  // namespace ew::test
