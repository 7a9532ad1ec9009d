// SPDX-License-Identifier: GPL-3.0-or-later
// Several drawings beside each other.
#include "core/reading/propose/apart.h"

#include <algorithm>

#include "core/solid/polyhedron_spec.h"
#include "tests/reading/reading_fixture.h"

namespace ew::test {
namespace {

/// Two boxes beside each other on the ground z = 0, the second one farther off.
std::vector<Stroke> twoBoxes(const OrthographicCamera& camera) {
    std::vector<Stroke> out = boxStrokes(camera, Vec3(40, 30, 30), Vec3(-50, -40, 0));
    for (Stroke& s : boxStrokes(camera, Vec3(20, 30, 40), Vec3(60, 40, 0))) {
        out.push_back(std::move(s));
    }
    return out;
}

const Candidate& taken(const Interpretation& reading) {
    return reading.candidates[static_cast<std::size_t>(*reading.accepted)];
}

/// Least and greatest height of a body above the world's z = 0 [mm].
std::pair<double, double> heights(const PolyhedronSpec& body, const Pose& pose) {
    double low = 1e9;
    double high = -1e9;
    for (const Vec3& v : body.vertices) {
        low = std::min(low, pose.toWorld(v).z());
        high = std::max(high, pose.toWorld(v).z());
    }
    return {low, high};
}

TEST(Apart, TwoBoxesAreTwoBodiesOnOneGround) {
    const InterpretOptions options;
    const Interpretation reading = readStrokes(twoBoxes(options.camera), options);
    ASSERT_TRUE(reading.accepted);
    const Candidate& c = taken(reading);
    EXPECT_EQ(c.templateName, "2 solids");
    const std::vector<PolyhedronSpec> bodies = separateBodies(c.spec);
    ASSERT_EQ(bodies.size(), 2U);
    EXPECT_NEAR(volumeOf(c.spec), 40 * 30 * 30 + 20 * 30 * 40, 1.0);
    const auto first = heights(bodies[0], c.pose);
    const auto second = heights(bodies[1], c.pose);
    EXPECT_NEAR(first.first, second.first, 1e-6);
    EXPECT_NEAR(std::max(first.second, second.second) - first.first, 40.0, 1e-3);
    EXPECT_EQ(c.junctionVertex.size(), reading.graph.junctions.size());
    EXPECT_TRUE(c.unusedStrokes.empty());
}

TEST(Apart, EachBodyIsWhereItWasDrawn) {
    const InterpretOptions options;
    const Interpretation reading = readStrokes(twoBoxes(options.camera), options);
    ASSERT_TRUE(reading.accepted);
    const Candidate& c = taken(reading);
    for (std::size_t j = 0; j < c.junctionVertex.size(); ++j) {
        ASSERT_GE(c.junctionVertex[j], 0);
        const Vec3 v =
            c.pose.toWorld(c.spec.vertices[static_cast<std::size_t>(c.junctionVertex[j])]);
        EXPECT_LT((options.camera.project(v) - reading.graph.junctions[j].position).norm(), 1e-3);
    }
}

TEST(Apart, TheOrderOfStrokesDoesNotMatter) {
    const InterpretOptions options;
    std::vector<Stroke> strokes = twoBoxes(options.camera);
    std::rotate(strokes.begin(), strokes.begin() + 7, strokes.end());
    const Interpretation reading = readStrokes(strokes, options);
    ASSERT_TRUE(reading.accepted);
    EXPECT_NEAR(volumeOf(taken(reading).spec), 60000.0, 1.0);
}

TEST(Apart, ADotStaysInk) {
    const InterpretOptions options;
    std::vector<Stroke> strokes = twoBoxes(options.camera);
    strokes.push_back(line({640, 20}, {641, 20}));
    const Interpretation reading = readStrokes(strokes, options);
    ASSERT_TRUE(reading.accepted);
    EXPECT_EQ(taken(reading).unusedStrokes, std::vector<int>{18});
}

/// What readApart makes of strokes when every drawing is read as the library does.
std::optional<Interpretation> apart(const std::vector<Stroke>& strokes) {
    const InterpretOptions options;
    const double distance = options.thresholds.distancePx;
    return readApart(readInk(strokes, distance), options, [&](const InkReading& own) {
        std::vector<Stroke> mine;
        for (const Segment& s : own.segments) mine.push_back(line(s.a, s.b));
        return readStrokes(mine, options);
    });
}

TEST(Apart, OneDrawingIsNone) {
    const InterpretOptions options;
    EXPECT_FALSE(apart(boxStrokes(options.camera, Vec3(40, 30, 30))));
    EXPECT_FALSE(apart({}));
}

TEST(Apart, AWindowInAFaceIsNoBody) {
    const InterpretOptions options;
    std::vector<Stroke> strokes = boxStrokes(options.camera, Vec3(60, 60, 60));
    // A small drawing of a box on the face that looks right.
    for (const Stroke& s : boxStrokes(options.camera, Vec3(12, 12, 12), Vec3(48, 20, 22))) {
        strokes.push_back(s);
    }
    EXPECT_FALSE(apart(strokes));
}

TEST(Apart, WhatIsNoSolidKeepsTheOthersFromBeingTaken) {
    const InterpretOptions options;
    std::vector<Stroke> strokes = boxStrokes(options.camera, Vec3(40, 30, 30), Vec3(-50, -40, 0));
    const std::vector<Vec2> flat{{900, 300}, {1050, 340}, {960, 480}};
    for (std::size_t k = 0; k < 3; ++k) strokes.push_back(line(flat[k], flat[(k + 1) % 3]));
    EXPECT_FALSE(apart(strokes));
}

}  // namespace
}  // namespace ew::test
