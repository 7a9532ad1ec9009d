// SPDX-License-Identifier: GPL-3.0-or-later
// New solids are set level: upright on the ground, under the ink that drew them.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/document/replay.h"
#include "core/document/report.h"
#include "core/document/sketch_script.h"
#include "core/reading/interpret.h"
#include "tests/document/fixtures.h"
#include "tests/reading/reading_fixture.h"

namespace ew {
namespace {

using test::boxStrokes;

/// The camera of the document, rolled about its line of sight: what it sees leans.
OrthographicCamera rolled(OrthographicCamera camera, double degrees) {
    camera.up =
        Eigen::AngleAxisd(degrees * std::numbers::pi / 180.0, camera.direction) * camera.trueUp();
    return camera;
}

std::unique_ptr<Document> documentWith(const std::vector<Stroke>& strokes) {
    auto d = std::make_unique<Document>(test::shippedLibrary(), interpret);
    for (const Stroke& s : strokes) EXPECT_TRUE(d->addStroke(s));
    return d;
}

ApplyRequest level(bool on = true) {
    ApplyRequest request;
    request.level = on;
    return request;
}

std::array<Vec3, 2> boundsOf(const Document& d, std::size_t body = 0) {
    return summarize({d.state().bodies.at(body)}).bounds;
}

/// Least angle between a face's normal and the vertical [degrees].
double leanOf(const Body& body) {
    double most = 0.0;
    for (const SolidFace& f : body.solid.faces()) {
        most = std::max(most, std::abs((body.pose.rotation * f.normal).z()));
    }
    return std::acos(std::min(1.0, most)) * 180.0 / std::numbers::pi;
}

/// How far the nearest corner of the picture is from each end of the strokes, at most [px].
double offPicture(const Document& d, const std::vector<Stroke>& strokes) {
    const Body& body = d.state().bodies.front();
    double most = 0.0;
    for (const Stroke& s : strokes) {
        for (const Vec2& end : {s.samples.front().position, s.samples.back().position}) {
            double nearest = 1e9;
            for (const Vec3& v : body.solid.vertices()) {
                const Vec2 p = d.camera().project(body.pose.toWorld(v));
                nearest = std::min(nearest, (p - end).norm());
            }
            most = std::max(most, nearest);
        }
    }
    return most;
}

TEST(Level, AFirstSolidStandsOnTheGroundUnderItsInk) {
    const OrthographicCamera plain;
    for (const double lean : {0.0, 2.0, -6.0}) {
        const auto strokes = boxStrokes(rolled(plain, lean), Vec3(60, 40, 30), Vec3(-30, -20, -50));
        const auto d = documentWith(strokes);
        ASSERT_TRUE(d->apply(level())) << lean;
        EXPECT_LT(leanOf(d->state().bodies[0]), 1e-6) << lean;
        EXPECT_NEAR(boundsOf(*d)[0].z(), 0.0, 1e-9) << lean;
        EXPECT_LT(offPicture(*d, strokes), 1e-4) << lean;
    }
}

TEST(Level, TheViewGoesAlongFromWhereverOneLooks) {
    const auto strokes =
        boxStrokes(rolled(OrthographicCamera{}, 4.0), Vec3(60, 40, 30), Vec3(-30, -20, -50));
    OrthographicCamera elsewhere;
    elsewhere.direction = Vec3(-1, 0.2, -0.4).normalized();
    elsewhere.center = Vec3(5, 7, 11);
    elsewhere.width = 900;
    std::vector<std::vector<Vec2>> pictures;
    for (const bool on : {false, true}) {
        const auto d = documentWith(strokes);
        ASSERT_TRUE(d->setCamera(elsewhere));
        ASSERT_TRUE(d->apply(level(on)));
        const Body& body = d->state().bodies.front();
        pictures.emplace_back();
        for (const Vec3& v : body.solid.vertices()) {
            pictures.back().push_back(d->camera().project(body.pose.toWorld(v)));
        }
    }
    for (std::size_t v = 0; v < pictures[0].size(); ++v) {
        EXPECT_LT((pictures[0][v] - pictures[1][v]).norm(), 1e-6) << v;
    }
}

TEST(Level, AsDrawnUnlessItIsAskedFor) {
    const auto strokes =
        boxStrokes(rolled(OrthographicCamera{}, 3.0), Vec3(60, 40, 30), Vec3(-30, -20, -50));
    const auto d = documentWith(strokes);
    const OrthographicCamera before = d->camera();
    ASSERT_TRUE(d->apply(level(false)));
    EXPECT_GT(leanOf(d->state().bodies[0]), 1.0);
    EXPECT_EQ(d->camera(), before);
}

TEST(Level, WhatLeansMoreThanTheThresholdWasMeantTo) {
    const auto strokes =
        boxStrokes(rolled(OrthographicCamera{}, 25.0), Vec3(60, 40, 30), Vec3(-30, -20, 0));
    const auto d = documentWith(strokes);
    const OrthographicCamera before = d->camera();
    ASSERT_TRUE(d->apply(level()));
    EXPECT_GT(leanOf(d->state().bodies[0]), 12.0);
    EXPECT_EQ(d->camera(), before);
}

TEST(Level, AnotherReadingOfTheSolidIsLevelToo) {
    const auto strokes =
        boxStrokes(rolled(OrthographicCamera{}, 4.0), Vec3(60, 40, 30), Vec3(-30, -20, 0));
    const auto d = documentWith(strokes);
    ASSERT_TRUE(d->apply(level()));
    const OrthographicCamera first = d->camera();
    const auto count = static_cast<int>(d->lastApply()->interpretation.candidates.size());
    for (int i = 1; i < count; ++i) {
        if (!d->chooseReading(i)) continue;
        if (leanOf(d->state().bodies[0]) > d->thresholds().angleDeg) continue;  // was meant to
        EXPECT_LT(leanOf(d->state().bodies[0]), 1e-6) << i;
        EXPECT_NEAR(boundsOf(*d)[0].z(), 0.0, 1e-9) << i;
    }
    ASSERT_TRUE(d->chooseReading(0));
    EXPECT_LT((d->camera().direction - first.direction).norm(), 1e-12);
    EXPECT_LT(offPicture(*d, strokes), 1e-4);
}

TEST(Level, ASecondSolidStandsOnTheSameGroundAlongTheFirst) {
    const OrthographicCamera plain;
    const auto d = documentWith(boxStrokes(plain, Vec3(40, 40, 30), Vec3(0, 0, 0)));
    ASSERT_TRUE(d->apply(level()));
    // Drawn through a camera that is turned a little, so that it comes out askew.
    OrthographicCamera turned = d->camera();
    const Mat3 by = Eigen::AngleAxisd(0.02, Vec3::UnitZ()).toRotationMatrix();
    turned.direction = by * turned.direction;
    for (const Stroke& s : boxStrokes(turned, Vec3(20, 25, 15), Vec3(90, -20, 0))) {
        ASSERT_TRUE(d->addStroke(s));
    }
    const OrthographicCamera before = d->camera();
    ASSERT_TRUE(d->apply(level()));
    ASSERT_EQ(d->state().bodies.size(), 2U);
    EXPECT_EQ(d->camera(), before);
    EXPECT_NEAR(boundsOf(*d, 1)[0].z(), 0.0, 1e-9);
    // Its faces are parallel to the first one's: the box of its bounds is the body itself.
    const Vec3 size = boundsOf(*d, 1)[1] - boundsOf(*d, 1)[0];
    EXPECT_NEAR(size.prod(), d->state().bodies[1].solid.volume(), 1e-6 * size.prod());
}

TEST(Level, ScriptsSayItAndReplayToTheSame) {
    const auto strokes =
        boxStrokes(rolled(OrthographicCamera{}, 3.0), Vec3(60, 40, 30), Vec3(-30, -20, 0));
    const auto d = documentWith(strokes);
    ASSERT_TRUE(d->apply(level()));
    const std::string text = writeSketchScript(d->recordedScript());
    EXPECT_NE(text.find("\"level\": true"), std::string::npos);
    const auto script = readSketchScript(text);
    ASSERT_TRUE(script) << script.error().message;
    Document again(test::shippedLibrary(), interpret);
    ASSERT_EQ(replay(again, *script, {}).firstFailure(), nullptr);
    EXPECT_TRUE(test::sameState(d->state(), again.state()));
    EXPECT_EQ(d->camera(), again.camera());
    EXPECT_FALSE(readScriptStep(R"({"do": "apply", "level": 1})"));
}

}  // namespace
}  // namespace ew
