// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/overlay/outline_reading.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/reading/reading_fixture.h"
#include "tests/support/sketch_generator.h"

namespace ew {
namespace {

InkReading boxInk(const std::vector<std::size_t>& leftOut = {}) {
    const std::vector<Stroke> all = test::boxStrokes({}, Vec3(60, 40, 30), Vec3(-30, -20, 0));
    std::vector<Stroke> strokes;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (std::find(leftOut.begin(), leftOut.end(), i) == leftOut.end())
            strokes.push_back(all[i]);
    }
    return readInk(strokes, 14.0);
}

TEST(OutlineReading, LaysABoxOnABox) {
    const auto found = readingsByOutline(boxInk(), test::entryOf("cube"), {});
    ASSERT_FALSE(found.empty());
    const OutlineReading& r = found.front();
    EXPECT_EQ(r.graph.junctions.size(), 7u);
    EXPECT_EQ(r.graph.edges.size(), 9u);
    EXPECT_EQ(r.barePx, 0.0);
    EXPECT_LT(r.match.parallelDeg, 0.1);
    const OrthographicCamera camera;
    // Every corner of the drawing is a junction.
    for (const Vec3& p : {Vec3(30, -20, 30), Vec3(-30, -20, 30), Vec3(30, 20, 30), Vec3(30, -20, 0),
                          Vec3(-30, 20, 30), Vec3(30, 20, 0), Vec3(-30, -20, 0)}) {
        const Vec2 px = camera.project(p);
        EXPECT_TRUE(std::any_of(r.graph.junctions.begin(), r.graph.junctions.end(),
                                [&](const Junction& j) { return (j.position - px).norm() < 0.5; }))
            << px.transpose();
    }
}

TEST(OutlineReading, SaysHowMuchOfItsEdgesIsBare) {
    // Half of an inner edge is not drawn.
    std::vector<Stroke> strokes = test::boxStrokes({}, Vec3(60, 40, 30), Vec3(-30, -20, 0));
    auto& samples = strokes.front().samples;
    const double length = (samples[1].position - samples[0].position).norm();
    samples[1].position = 0.5 * (samples[0].position + samples[1].position);
    const auto found = readingsByOutline(readInk(strokes, 14.0), test::entryOf("cube"), {});
    ASSERT_FALSE(found.empty());
    EXPECT_NEAR(found.front().barePx, 0.5 * length - 14.0, 8.0);
}

TEST(OutlineReading, NeedsInkForEveryEdge) {
    EXPECT_TRUE(readingsByOutline(boxInk({0}), test::entryOf("cube"), {}).empty());
}

TEST(OutlineReading, FindsNoLPrismInABox) {
    EXPECT_TRUE(readingsByOutline(boxInk(), test::entryOf("l-prism"), {}).empty());
}

// Where the outline is not convex the corners of its convex hull are laid on those of the ink.
TEST(OutlineReading, LaysAnLPrismOnAnLPrism) {
    int found = 0;
    constexpr int kDrawings = 20;
    for (std::uint64_t index = 0; index < kDrawings; ++index) {
        test::Random shape(test::Random::mix(5, index));
        const auto lines = test::randomSketch("l-prism", shape).drawing.lines();
        std::vector<Stroke> strokes;
        for (const auto& l : lines) strokes.push_back(test::line(l[0], l[1]));
        const auto onAnEnd = [&](const Junction& j) {
            return std::any_of(lines.begin(), lines.end(), [&](const auto& l) {
                return std::min((l[0] - j.position).norm(), (l[1] - j.position).norm()) < 1.0;
            });
        };
        const auto readings =
            readingsByOutline(readInk(strokes, 14.0), test::entryOf("l-prism"), {});
        found += std::any_of(readings.begin(), readings.end(), [&](const OutlineReading& r) {
            return r.graph.edges.size() == lines.size() && r.barePx == 0.0 &&
                   std::all_of(r.graph.junctions.begin(), r.graph.junctions.end(), onAnEnd);
        });
    }
    // The others show T junctions, which are not laid.
    EXPECT_GE(found, kDrawings / 2);
}

// Corners of these boxes lie so close together that a normal hand's ends join wrongly.
TEST(OutlineReading, BoxesWithANarrowFaceAreStillBoxes) {
    for (const std::uint64_t index : {9u, 105u, 298u, 913u, 962u}) {
        SCOPED_TRACE(index);
        test::Random shape(test::Random::mix(21, index));
        const test::SketchCase sketch = test::randomSketch("cube", shape);
        test::Random hand(test::Random::mix(21, index, 3));
        InterpretOptions o;
        o.camera = sketch.camera;
        const auto r =
            test::readStrokes(test::drawByHand(sketch.drawing.lines(), test::kNormalHand, hand), o);
        ASSERT_TRUE(r.accepted);
        EXPECT_EQ(r.candidates[static_cast<std::size_t>(*r.accepted)].templateId, "cube");
    }
}

}  // namespace
}  // namespace ew
