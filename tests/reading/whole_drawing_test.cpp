// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings that no template of the library shows.
#include "core/reading/propose/whole_drawing.h"

#include <algorithm>
#include <cmath>

#include "core/reading/propose/prism_proposals.h"
#include "core/reading/propose/pyramid_proposals.h"
#include "core/reading/score/picture_evidence.h"
#include "core/solid/boolean.h"
#include "tests/reading/reading_fixture.h"
#include "tests/support/hand_model.h"
#include "tests/support/modification_shapes.h"
#include "tests/support/whole_shapes.h"

namespace ew::test {
namespace {

std::vector<Stroke> drawnBy(const WholeCase& c, const HandLevel& hand, std::uint64_t seed) {
    Random random(seed);
    return drawByHand(c.lines, hand, random);
}

Interpretation read(const WholeCase& c, const std::vector<Stroke>& strokes) {
    InterpretOptions options;
    options.camera = c.camera;
    return readStrokes(strokes, options);
}

/// The solid that was taken; nothing where none was.
std::optional<Solid> taken(const Interpretation& reading) {
    if (!reading.accepted) return std::nullopt;
    auto solid =
        Solid::fromSpec(reading.candidates[static_cast<std::size_t>(*reading.accepted)].spec);
    if (!solid) return std::nullopt;
    return *std::move(solid);
}

bool sameCounts(const Solid& a, const Solid& b) {
    return a.vertices().size() == b.vertices().size() && a.edges().size() == b.edges().size() &&
           a.faces().size() == b.faces().size();
}

/// An exact drawing, and its strokes the other way round.
void expectAnyOrder(const std::string& kind, std::uint64_t seed, double volumeError) {
    Random random(seed);
    const WholeCase c = randomWholeCase(kind, random);
    std::vector<Stroke> strokes = drawnBy(c, kExactHand, 3);
    const auto first = taken(read(c, strokes));
    std::reverse(strokes.begin(), strokes.end());
    const auto second = taken(read(c, strokes));
    ASSERT_TRUE(first && second);
    EXPECT_TRUE(sameCounts(*first, *second));
    EXPECT_NEAR(first->volume() / second->volume(), 1.0, volumeError);
}

class WholeDrawings : public testing::TestWithParam<std::string> {};

TEST_P(WholeDrawings, ExactOnesComeBack) {
    int right = 0;
    for (std::uint64_t n = 0; n < 12; ++n) {
        SCOPED_TRACE(n);
        Random random(Random::mix(7, n));
        const WholeCase c = randomWholeCase(GetParam(), random);
        const auto solid = taken(read(c, drawnBy(c, kExactHand, n)));
        if (!solid) continue;
        EXPECT_TRUE(sameCounts(*solid, c.solid));
        if (c.tellsVolume) {
            EXPECT_NEAR(solid->volume() / c.solid.volume(), 1.0, 1e-3);
        }
        ++right;
    }
    EXPECT_GE(right, 11);
}

TEST_P(WholeDrawings, LightHandsAreReadToo) {
    int right = 0;
    for (std::uint64_t n = 0; n < 12; ++n) {
        SCOPED_TRACE(n);
        Random random(Random::mix(8, n));
        const WholeCase c = randomWholeCase(GetParam(), random);
        const auto solid = taken(read(c, drawnBy(c, kLightHand, n)));
        if (!solid) continue;
        EXPECT_TRUE(sameCounts(*solid, c.solid))
            << solid->vertices().size() << " for " << c.solid.vertices().size();
        if (c.tellsVolume) {
            EXPECT_NEAR(solid->volume() / c.solid.volume(), 1.0, 0.12);
        }
        ++right;
    }
    EXPECT_GE(right, 8);
}

TEST_P(WholeDrawings, AnotherOrderOfStrokesIsTheSameSolid) {
    expectAnyOrder(GetParam(), Random::mix(9, 1), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Families, WholeDrawings, testing::Values("prism", "concave", "pyramid"));

class Compounds : public testing::TestWithParam<std::string> {};

TEST_P(Compounds, AreReadFromLightHands) {
    int right = 0;
    int wrong = 0;
    for (std::uint64_t n = 0; n < 12; ++n) {
        Random random(Random::mix(21, n));
        const WholeCase c = randomWholeCase(GetParam(), random);
        const auto solid = taken(read(c, drawnBy(c, kLightHand, n)));
        if (!solid) continue;
        const bool same = sameCounts(*solid, c.solid) &&
                          solid->shellCount() == c.solid.shellCount() &&
                          std::abs(solid->volume() / c.solid.volume() - 1.0) < 0.12;
        (same ? right : wrong) += 1;
    }
    EXPECT_GE(right, 9);
    EXPECT_LE(wrong, 2);  // what lies behind everything may be anything
}

TEST_P(Compounds, AnotherOrderOfStrokesIsTheSameSolid) {
    expectAnyOrder(GetParam(), Random::mix(22, 1), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Compounds, testing::Values("parts-2", "parts-5", "bodies"));

/// Drawings with all of their hidden lines, in pieces where something comes before them.
class HiddenLines : public testing::TestWithParam<std::string> {};

TEST_P(HiddenLines, AreEdgesOfTheSolid) {
    int right = 0;
    int wrong = 0;
    for (std::uint64_t n = 0; n < 12; ++n) {
        Random random(Random::mix(31, n));
        WholeCase c = randomWholeCase(GetParam(), random);
        c.lines.insert(c.lines.end(), c.hidden.begin(), c.hidden.end());
        const auto solid = taken(read(c, drawnBy(c, kLightHand, n)));
        if (!solid) continue;
        const bool same =
            sameCounts(*solid, c.solid) &&
            (!c.tellsVolume || std::abs(solid->volume() / c.solid.volume() - 1.0) < 0.12);
        (same ? right : wrong) += 1;
    }
    EXPECT_GE(right, 8);
    EXPECT_LE(wrong, 1);
}

INSTANTIATE_TEST_SUITE_P(Kinds, HiddenLines,
                         testing::Values("prism", "concave", "pyramid", "parts-2", "parts-5"));

/// The same beside a solid that is there already.
TEST(WholeDrawing, BesideASolidIsReadAsOnAnEmptySheet) {
    int right = 0;
    for (std::uint64_t n = 0; n < 6; ++n) {
        SCOPED_TRACE(n);
        Random random(Random::mix(51, n));
        const WholeCase c = randomWholeCase("prism", random);
        InterpretOptions options;
        options.camera = c.camera;
        const Vec3 aside = 1200.0 * c.camera.worldPerPixel * c.camera.right();
        options.bodies = {{c.solid, Pose{Mat3::Identity(), aside}}};
        const std::vector<Stroke> strokes = drawnBy(c, kLightHand, n);
        const auto alone = taken(read(c, strokes));
        const Interpretation beside = readStrokes(strokes, options);
        ASSERT_EQ(alone.has_value(), beside.accepted.has_value());
        if (!alone) continue;
        const Candidate& candidate = beside.candidates[static_cast<std::size_t>(*beside.accepted)];
        EXPECT_EQ(candidate.operation, Operation::Create);
        EXPECT_TRUE(sameCounts(*taken(beside), *alone));
        ++right;
    }
    EXPECT_GE(right, 4);
}

/// Drawings whose lines run past every corner.
class GuideLines : public testing::TestWithParam<std::string> {};

TEST_P(GuideLines, AreNoEdges) {
    int right = 0;
    for (std::uint64_t n = 0; n < 6; ++n) {
        SCOPED_TRACE(n);
        Random random(Random::mix(41, n));
        WholeCase c = randomWholeCase(GetParam(), random);
        c.lines = withGuides(c.lines, random);
        const Interpretation reading = read(c, drawnBy(c, kLightHand, n));
        const auto solid = taken(reading);
        if (!solid) continue;
        EXPECT_TRUE(sameCounts(*solid, c.solid))
            << solid->vertices().size() << " for " << c.solid.vertices().size();
        const bool tails =
            std::any_of(reading.graph.noise.begin(), reading.graph.noise.end(),
                        [](const NoiseItem& item) { return item.kind == NoiseKind::Overshoot; });
        EXPECT_TRUE(tails);
        ++right;
    }
    EXPECT_GE(right, GetParam() == "parts-2" ? 2 : 4);
}

INSTANTIATE_TEST_SUITE_P(Kinds, GuideLines,
                         testing::Values("prism", "concave", "pyramid", "parts-2"));

/// The far slope of the roof is seen all but edge-on: it runs nearly along the ridge, and nobody
/// draws the lines behind it.
TEST(WholeDrawing, AGableWhoseSlopeRunsNearlyAlongTheRidge) {
    const Vec2 left(676, 479), leftEaves(676, 369), top(753, 275), eaves(829, 318), right(829, 429);
    const Vec2 back(560, 401), backEaves(560, 291), backTop(636, 197);
    std::vector<Stroke> strokes;
    const std::vector<Line2> lines{{right, left},       {left, leftEaves},      {leftEaves, top},
                                   {top, eaves},        {eaves, right},         {left, back},
                                   {back, backEaves},   {leftEaves, backEaves}, {top, backTop},
                                   {backEaves, backTop}};
    for (const Line2& l : lines) strokes.push_back(test::line(l[0], l[1]));
    const Interpretation r = test::readStrokes(strokes);
    ASSERT_TRUE(r.accepted) << r.problem->message;
    const PolyhedronSpec& spec = r.candidates[static_cast<std::size_t>(*r.accepted)].spec;
    EXPECT_EQ(spec.vertices.size(), 10U);
    EXPECT_EQ(spec.faces.size(), 7U);
}

/// A box with a window drawn as a closed line on a face, and one with a pocket whose floor is seen.
TEST(WholeDrawing, AWindowIsInkAndAPocketIsCut) {
    OrthographicCamera camera;
    camera.direction = Vec3(-1.0, 0.7, -1.0).normalized();
    camera.worldPerPixel = 0.2;
    camera.center = Vec3(50, 40, 20);
    const Solid box = *Solid::fromSpec(boxSpec({0, 0, 0}, {100, 80, 40}));
    const Solid pocket = *Solid::fromSpec(boxSpec({25, 20, 30}, {75, 60, 41}));
    const WholeCase cut = wholeCase(combine(box, pocket, BooleanKind::Cut)->solid, camera);
    const Interpretation read1 = read(cut, drawnBy(cut, kExactHand, 1));
    const auto solid = taken(read1);
    ASSERT_TRUE(solid) << (read1.problem ? read1.problem->message : "");
    EXPECT_NEAR(solid->volume(), 100.0 * 80 * 40 - 50.0 * 40 * 10, 1.0);

    WholeCase plain = wholeCase(box, camera);
    std::vector<Stroke> strokes = drawnBy(plain, kExactHand, 1);
    const std::size_t edges = strokes.size();
    const auto at = [&](double x, double y) { return camera.project(Vec3(x, y, 40)); };
    strokes.push_back(line(at(25, 20), at(75, 20)));
    strokes.push_back(line(at(75, 20), at(75, 60)));
    strokes.push_back(line(at(75, 60), at(25, 60)));
    strokes.push_back(line(at(25, 60), at(25, 20)));
    const Interpretation read2 = read(plain, strokes);
    ASSERT_TRUE(read2.accepted) << (read2.problem ? read2.problem->message : "");
    EXPECT_EQ(read2.candidates.front().templateId, "cube");
    EXPECT_EQ(read2.candidates.front().unusedStrokes.size(), strokes.size() - edges);
}

TEST(WholeDrawing, ATemplateThatContradictsThePictureIsAQuestion) {
    // A taller box has edges where nothing was drawn.
    OrthographicCamera camera;
    const Solid box = *Solid::fromSpec(boxSpec({0, 0, 0}, {60, 50, 40}));
    const WholeCase c = wholeCase(box, camera);
    const InkReading ink = readInk(drawnBy(c, kExactHand, 1), Thresholds{}.distancePx);
    EXPECT_LT(pictureEvidence(ink, box, {}, camera, 3.0).contradiction(), 0.01);
    const Solid other = *Solid::fromSpec(boxSpec({0, 0, 0}, {60, 50, 55}));
    EXPECT_GT(pictureEvidence(ink, other, {}, camera, 3.0).contradiction(), 0.2);
}

TEST(WholeDrawing, APictureHasAllOfItsOwnInk) {
    Random random(11);
    const WholeCase c = randomWholeCase("concave", random);
    const InkReading ink = readInk(drawnBy(c, kExactHand, 1), Thresholds{}.distancePx);
    const PictureEvidence all = pictureEvidence(ink, c.solid, {}, c.camera, 3.0);
    EXPECT_LT(all.residue(), 0.01);
    EXPECT_TRUE(all.beside.empty());
    // Less one line: that edge is bare, and nothing is stray.
    WholeCase less = c;
    const double length = (less.lines[0][1] - less.lines[0][0]).norm();
    less.lines.erase(less.lines.begin());
    const InkReading rest = readInk(drawnBy(less, kExactHand, 1), Thresholds{}.distancePx);
    const PictureEvidence some = pictureEvidence(rest, c.solid, {}, c.camera, 3.0);
    EXPECT_NEAR(some.barePx, length, 10.0);
    EXPECT_LT(some.strayPx, 1.0);
}

TEST(WholeDrawing, ALineBesideTheSolidStaysInk) {
    Random random(12);
    const WholeCase c = randomWholeCase("concave", random);
    std::vector<Stroke> strokes = drawnBy(c, kExactHand, 1);
    strokes.push_back(line({20, 20}, {70, 25}));
    const Interpretation reading = read(c, strokes);
    ASSERT_TRUE(reading.accepted);
    EXPECT_EQ(reading.candidates.front().unusedStrokes,
              std::vector<int>{static_cast<int>(strokes.size()) - 1});
}

TEST(WholeDrawing, WhatShowsNothingProposesNothing) {
    EdgeGraph triangle;
    triangle.junctions = {{{0, 0}}, {{100, 0}}, {{0, 100}}};
    for (const auto& e : {std::array<int, 2>{0, 1}, {1, 2}, {2, 0}}) {
        GraphEdge edge;
        edge.ends = e;
        triangle.edges.push_back(edge);
    }
    const LineDrawing drawing = lineDrawing(triangle, 8.0);
    EXPECT_TRUE(prismProposals(drawing, 2.0).empty());
    EXPECT_TRUE(pyramidProposals(drawing, 2.0).empty());
}

TEST(WholeDrawing, RandomLinesAreNoSolidAndNoFault) {
    for (std::uint64_t n = 0; n < 10; ++n) {
        Random random(Random::mix(13, n));
        std::vector<Stroke> strokes;
        for (int k = 0; k < 24; ++k) {
            strokes.push_back(line({random.uniform(100, 900), random.uniform(100, 700)},
                                   {random.uniform(100, 900), random.uniform(100, 700)}));
        }
        const InkReading ink = readInk(strokes, Thresholds{}.distancePx);
        EXPECT_FALSE(readWholeDrawing(ink, shippedLibrary(), {}).clear) << n;
    }
}

}  // namespace
}  // namespace ew::test
