// SPDX-License-Identifier: GPL-3.0-or-later
// Few lines that stand for a whole drawing.
#include "core/reading/propose/gesture.h"

#include <cmath>

#include "tests/reading/reading_fixture.h"
#include "tests/support/hand_model.h"

namespace ew::test {
namespace {

const OrthographicCamera kCamera;
constexpr double kDistance = 14.0;

/// A corner of a box of 60 x 40 x 50 mm; the camera sees +x, -y and +z.
Vec2 corner(double x, double y, double z) { return kCamera.project(Vec3(60 * x, 40 * y, 50 * z)); }

/// Three edges from the corner that is nearest to the eye.
std::vector<Line2> nearCorner() {
    const Vec2 p = corner(1, 0, 1);
    return {{p, corner(0, 0, 1)}, {p, corner(1, 1, 1)}, {p, corner(1, 0, 0)}};
}

/// Three edges from a corner of the outline.
std::vector<Line2> farCorner() {
    const Vec2 p = corner(1, 0, 0);
    return {{p, corner(1, 0, 1)}, {p, corner(0, 0, 0)}, {p, corner(1, 1, 0)}};
}

std::vector<Stroke> strokesOf(const std::vector<Line2>& lines) {
    std::vector<Stroke> out;
    for (const Line2& l : lines) out.push_back(line(l[0], l[1]));
    return out;
}

Interpretation readLines(const std::vector<Line2>& lines) { return readStrokes(strokesOf(lines)); }

std::size_t completions(const std::vector<Line2>& lines) {
    return completedGestures(readInk(strokesOf(lines), kDistance), kDistance).size();
}

/// What is offered first, unasked.
const Candidate* offered(const Interpretation& reading) {
    if (reading.accepted || reading.candidates.empty() || !reading.problem) return nullptr;
    return reading.problem->code == Errc::Ambiguous ? &reading.candidates.front() : nullptr;
}

TEST(Gesture, ThreeLinesFromAPointAreABlockOfTheseLengths) {
    for (const auto& lines : {nearCorner(), farCorner()}) {
        const Interpretation reading = readLines(lines);
        const Candidate* c = offered(reading);
        ASSERT_NE(c, nullptr);
        EXPECT_EQ(c->templateId, "cube");
        EXPECT_NEAR(volumeOf(c->spec), 60 * 40 * 50, 1.0);
        EXPECT_EQ(c->notes.back(), "6 edges that were not drawn were added.");
        EXPECT_TRUE(c->unusedStrokes.empty());
        EXPECT_FALSE(reading.repairs.empty());
    }
}

TEST(Gesture, AHandDrawsThem) {
    int right = 0;
    for (std::uint64_t n = 0; n < 20; ++n) {
        Random random(Random::mix(3, n));
        const Interpretation reading =
            readStrokes(drawByHand(n % 2 == 0 ? nearCorner() : farCorner(), kLightHand, random));
        const Candidate* c = offered(reading);
        if (c == nullptr || c->templateId != "cube") continue;
        right += std::abs(volumeOf(c->spec) / 120000.0 - 1.0) < 0.25 ? 1 : 0;
    }
    EXPECT_GE(right, 17);
}

TEST(Gesture, AnOutlineAndALineAreAPrismOfThatDepth) {
    // The front of a gabled house, and its depth.
    const auto p = [](double x, double y, double z) { return kCamera.project(Vec3(x, y, z)); };
    const Interpretation reading = readLines({{p(0, 0, 0), p(60, 0, 0)},
                                              {p(60, 0, 0), p(60, 0, 40)},
                                              {p(60, 0, 40), p(30, 0, 60)},
                                              {p(30, 0, 60), p(0, 0, 40)},
                                              {p(0, 0, 40), p(0, 0, 0)},
                                              {p(60, 0, 0), p(60, 80, 0)}});
    const Candidate* c = offered(reading);
    ASSERT_NE(c, nullptr);
    EXPECT_EQ(c->spec.vertices.size(), 10U);
    EXPECT_NEAR(volumeOf(c->spec), (60 * 40 + 30 * 20) * 80, 100.0);
}

TEST(Gesture, OtherDrawingsAreNone) {
    EXPECT_EQ(completions({}), 0U);
    std::vector<Line2> lines = nearCorner();
    lines.push_back({corner(0, 0, 1), corner(0, 1, 1)});
    EXPECT_EQ(completions(lines), 0U);
    // Two of three in line.
    EXPECT_EQ(completions({{Vec2(400, 400), Vec2(200, 400)},
                           {Vec2(400, 400), Vec2(600, 400)},
                           {Vec2(400, 400), Vec2(400, 600)}}),
              0U);
    // Three that do not meet.
    EXPECT_EQ(completions({{Vec2(100, 100), Vec2(300, 100)},
                           {Vec2(100, 200), Vec2(300, 200)},
                           {Vec2(100, 300), Vec2(300, 300)}}),
              0U);
    // A line into the outline leaves no side to be seen.
    EXPECT_EQ(completions({{Vec2(200, 200), Vec2(400, 200)},
                           {Vec2(400, 200), Vec2(400, 400)},
                           {Vec2(400, 400), Vec2(200, 400)},
                           {Vec2(200, 400), Vec2(200, 200)},
                           {Vec2(200, 200), Vec2(300, 280)}}),
              0U);
}

}  // namespace
}  // namespace ew::test
