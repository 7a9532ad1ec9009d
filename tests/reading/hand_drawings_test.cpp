// SPDX-License-Identifier: GPL-3.0-or-later
// What people draw besides the lines of one solid seen from one place: corners by eye, perspective,
// hidden lines, details, two faces, flat outlines.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tests/reading/reading_fixture.h"
#include "tests/support/line_changes.h"
#include "tests/support/sketch_generator.h"

namespace ew {
namespace {

using test::line;
using test::Random;
using test::readStrokes;

struct Tally {
    int right = 0;
    int wrong = 0;
};

/// Reads `count` random drawings of a template.
template <class Draw>
Tally tally(const std::string& id, int count, const Draw& draw) {
    Tally out;
    for (int i = 0; i < count; ++i) {
        Random shape(Random::mix(13, static_cast<std::uint64_t>(i)));
        const test::SketchCase sketch = test::randomSketch(id, shape);
        Random hand(Random::mix(13, static_cast<std::uint64_t>(i), 1));
        InterpretOptions options;
        options.camera = sketch.camera;
        const Interpretation r = readStrokes(draw(sketch, hand), options);
        if (!r.accepted) continue;
        const bool right = r.candidates[static_cast<std::size_t>(*r.accepted)].templateId == id;
        ++(right ? out.right : out.wrong);
    }
    return out;
}

TEST(HandDrawings, RuledBoxesWithCornersByEyeAreBoxes) {
    for (const double offPx : {2.0, 4.0}) {
        const Tally t = tally("cube", 24, [&](const test::SketchCase& sketch, Random& hand) {
            return test::ruledStrokes(test::withMovedCorners(sketch.drawing.lines(), offPx, hand));
        });
        EXPECT_EQ(t.wrong, 0) << offPx << " px";
        EXPECT_GE(t.right, offPx < 3.0 ? 24 : 21) << offPx << " px";
    }
}

TEST(HandDrawings, BoxesInPerspectiveAreBoxes) {
    const auto drawn = [](double eyeWidths) {
        return [eyeWidths](const test::SketchCase& sketch, Random& hand) {
            return test::drawByHand(test::linesInPerspective(sketch, eyeWidths), test::kLightHand,
                                    hand);
        };
    };
    const Tally mild = tally("cube", 30, drawn(4.0));
    EXPECT_LE(mild.wrong, 1);
    EXPECT_GE(mild.right, 24);
    const Tally strong = tally("cube", 30, drawn(3.0));
    EXPECT_LE(strong.wrong, 1);
    EXPECT_GE(strong.right, 20);
}

TEST(HandDrawings, TrueFrustaAreStillFrusta) {
    const Tally t = tally("wedge-frustum", 24, [](const test::SketchCase& sketch, Random& hand) {
        return test::ruledStrokes(test::withMovedCorners(sketch.drawing.lines(), 2.0, hand));
    });
    EXPECT_EQ(t.wrong, 0);
    EXPECT_GE(t.right, 23);
}

/// The corners of a box's picture: front left bottom, right bottom, right top, left top, then the
/// back ones.
std::vector<Vec2> boxCorners() {
    return {{525.0, 456.4}, {672.4, 504.9}, {672.4, 398.9}, {525.0, 350.5},
            {607.6, 401.1}, {755.0, 449.5}, {755.0, 343.6}, {607.6, 295.1}};
}

std::vector<Stroke> visibleBox() {
    const auto p = boxCorners();
    return {line(p[0], p[1]), line(p[1], p[2]), line(p[2], p[3]),
            line(p[3], p[0]), line(p[2], p[6]), line(p[6], p[7]),
            line(p[7], p[3]), line(p[1], p[5]), line(p[5], p[6])};
}

TEST(HandDrawings, HiddenEdgesMayBeDrawn) {
    const auto p = boxCorners();
    std::vector<Stroke> strokes = visibleBox();
    for (const int v : {0, 5, 7}) strokes.push_back(line(p[4], p[static_cast<std::size_t>(v)]));
    const Interpretation r = readStrokes(strokes);
    ASSERT_TRUE(r.accepted);
    EXPECT_EQ(r.candidates[0].templateId, "cube");
    EXPECT_TRUE(r.candidates[0].unusedStrokes.empty());
}

/// A round mark of a few px more than a dot.
Stroke circle(const Vec2& center, double radius) {
    Stroke s;
    for (int i = 0; i <= 40; ++i) {
        const double a = 2.0 * std::numbers::pi * i / 40.0;
        s.samples.push_back({center + radius * Vec2(std::cos(a), std::sin(a)), 1.0, 0.0});
    }
    return s;
}

TEST(HandDrawings, InkInsideAFaceIsDetailAndStays) {
    std::vector<Stroke> strokes = visibleBox();
    const std::size_t edges = strokes.size();
    strokes.push_back(circle({600.0, 430.0}, 16.0));
    // A window, as one stroke.
    Stroke window = line({690.0, 430.0}, {735.0, 400.0});
    for (const Vec2& q : {Vec2(735.0, 370.0), Vec2(690.0, 400.0), Vec2(690.0, 430.0)}) {
        window.samples.push_back({q, 1.0, 0.0});
    }
    strokes.push_back(window);
    const Interpretation r = readStrokes(strokes);
    ASSERT_TRUE(r.accepted) << (r.problem ? r.problem->message : "");
    EXPECT_EQ(r.candidates[0].templateId, "cube");
    EXPECT_EQ(r.candidates[0].unusedStrokes,
              (std::vector<int>{static_cast<int>(edges), static_cast<int>(edges) + 1}));
}

TEST(HandDrawings, AFlatOutlineIsNoSolid) {
    const std::vector<std::vector<Vec2>> outlines{
        {{540, 300}, {740, 304}, {737, 470}, {710, 500}, {542, 498}},
        {{500, 300}, {700, 300}, {700, 450}, {500, 450}},
        {{500, 500}, {600, 300}, {720, 500}}};
    for (const auto& corners : outlines) {
        Stroke s;
        for (std::size_t i = 0; i <= corners.size(); ++i) {
            s.samples.push_back({corners[i % corners.size()], 1.0, 0.0});
        }
        const Interpretation r = readStrokes({s});
        EXPECT_FALSE(r.accepted);
        EXPECT_TRUE(r.candidates.empty());
        ASSERT_TRUE(r.problem);
        EXPECT_EQ(r.problem->code, Errc::FlatDrawing) << r.problem->message;
        EXPECT_FALSE(r.problem->where.empty());
    }
}

TEST(HandDrawings, TwoFacesAreAQuestionAndABoxFirst) {
    // Front and a narrow right side; front and top.
    const std::vector<std::vector<std::vector<Vec2>>> drawings{
        {{{480, 330}, {680, 328}, {684, 500}, {478, 504}, {480, 330}},
         {{680, 328}, {710, 334}, {714, 496}, {684, 500}}},
        {{{500, 400}, {700, 400}, {700, 540}, {500, 540}, {500, 400}},
         {{500, 400}, {560, 330}, {760, 330}, {700, 400}}}};
    for (const auto& drawing : drawings) {
        std::vector<Stroke> strokes;
        for (const auto& points : drawing) {
            strokes.emplace_back();
            for (const Vec2& p : points) strokes.back().samples.push_back({p, 1.0, 0.0});
        }
        const Interpretation r = readStrokes(strokes);
        EXPECT_FALSE(r.accepted);
        ASSERT_FALSE(r.candidates.empty());
        EXPECT_EQ(r.candidates[0].templateId, "cube");
        EXPECT_TRUE(r.problem);
    }
}

TEST(HandDrawings, AGapUnderTheThresholdIsNoReason) {
    // A gable house and a tick beside an edge of it.
    const std::vector<std::array<Vec2, 2>> lines{
        {{{546.6, 456.7}, {664.6, 495.4}}}, {{{664.6, 495.4}, {664.6, 410.7}}},
        {{{664.6, 410.7}, {605.6, 338.3}}}, {{{605.6, 338.3}, {546.6, 371.9}}},
        {{{546.6, 371.9}, {546.6, 456.7}}}, {{{664.6, 495.4}, {754.0, 435.4}}},
        {{{754.0, 435.4}, {754.0, 350.7}}}, {{{664.6, 410.7}, {754.0, 350.7}}},
        {{{605.6, 338.3}, {695.1, 278.3}}}, {{{754.0, 350.7}, {695.1, 278.3}}},
        {{{651.6, 455.8}, {660.6, 458.2}}}};
    std::vector<Stroke> strokes;
    for (const auto& l : lines) strokes.push_back(line(l[0], l[1]));
    const Interpretation r = readStrokes(strokes);
    ASSERT_TRUE(r.accepted) << r.problem->message;
    const PolyhedronSpec& spec = r.candidates[static_cast<std::size_t>(*r.accepted)].spec;
    EXPECT_EQ(spec.vertices.size(), 10U);
    EXPECT_EQ(spec.faces.size(), 7U);
}

TEST(HandDrawings, NoSolidIsMuchDeeperThanItWasDrawn) {
    // A cabinet cube: a square front, edges that run away at 45 degrees, half as long.
    const double side = 180.0;
    for (const double turnDeg : {0.0, 0.4, 1.0, 2.0}) {
        const double t = turnDeg * std::numbers::pi / 180.0;
        const Vec2 x = side * Vec2(std::cos(t), std::sin(t));
        const Vec2 y = side * Vec2(0.0, -1.0);
        const Vec2 z = 0.5 * side * Vec2(std::sqrt(0.5), -std::sqrt(0.5));
        const Vec2 o(500.0, 500.0);
        const std::vector<Stroke> strokes{
            line(o, o + x),         line(o + x, o + x + y),         line(o + x + y, o + y),
            line(o + y, o),         line(o + y, o + y + z),         line(o + x + y, o + x + y + z),
            line(o + x, o + x + z), line(o + y + z, o + x + y + z), line(o + x + z, o + x + y + z)};
        const Interpretation r = readStrokes(strokes);
        if (!r.accepted) continue;
        Eigen::AlignedBox3d box;
        for (const Vec3& v : r.candidates[0].spec.vertices) box.extend(v);
        EXPECT_LT(box.sizes().maxCoeff(), 3.0 * side * InterpretOptions{}.camera.worldPerPixel)
            << turnDeg;
    }
}

}  // namespace
}  // namespace ew
