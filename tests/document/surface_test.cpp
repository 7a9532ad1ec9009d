// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QUndoStack>
#include <cmath>
#include <limits>

#include "core/document/document.h"
#include "tests/document/fixtures.h"

namespace ew {
namespace {

using test::fakeDocument;
using test::line;

constexpr auto kAll = EdgeChoice::Which::All;
constexpr auto kPicked = EdgeChoice::Which::Picked;

/// Adds a box of 40 x 30 x 2 mm at (10, 20, 30).
void addBox(Document& d) {
    ASSERT_TRUE(d.addStroke(line({100, 100}, {139, 129})));
    ASSERT_TRUE(d.apply());
}

std::unique_ptr<Document> withBox() {
    auto d = fakeDocument();
    addBox(*d);
    return d;
}

FilletRequest request(double radius, EdgeChoice edges = {}) {
    FilletRequest r;
    r.edges = std::move(edges);
    r.radius = radius;
    return r;
}

SubdivisionSettings uniform(int levels) {
    SubdivisionSettings s;
    s.on = true;
    s.levels = levels;
    return s;
}

double volumeOf(const Document& d, std::size_t body = 0) {
    const ShapeMesh mesh = shapeMesh(d.state().bodies[body], d.shape()->bodies[body]);
    return enclosedVolume(mesh.positions, mesh.triangles);
}

TEST(DocumentSurface, AFilletIsOneNamedStepAndASetting) {
    const auto d = withBox();
    EXPECT_FALSE(d->shape()->hasCage());
    const auto outcome = d->fillet(request(0.5));
    ASSERT_TRUE(outcome) << outcome.error().message;
    EXPECT_EQ(outcome->edges, 12);
    EXPECT_TRUE(outcome->clamped.empty());
    EXPECT_EQ(d->undoStack().undoText(), QStringLiteral("Fillet 12 edges"));
    EXPECT_NEAR(d->state().bodies[0].solid.volume(), 2400, 1e-6) << "the solid stays as it is";
    ASSERT_TRUE(d->shape()->bodies[0].cage);
    const double chamfered = volumeOf(*d);
    EXPECT_LT(chamfered, 2400);

    FilletRequest rounder = request(0.5);
    rounder.segments = 8;
    ASSERT_TRUE(d->fillet(rounder));
    EXPECT_GT(volumeOf(*d), chamfered) << "an arc cuts less away than a chamfer";

    ASSERT_TRUE(d->undo(2));
    EXPECT_FALSE(d->shape()->hasCage());
    EXPECT_NEAR(volumeOf(*d), 2400, 1e-6);
    ASSERT_TRUE(d->redo());
    EXPECT_NEAR(volumeOf(*d), chamfered, 1e-12);
    // Setting what is set already is no step.
    const int steps = d->undoStack().index();
    ASSERT_TRUE(d->fillet(request(0.5)));
    EXPECT_EQ(d->undoStack().index(), steps);
}

TEST(DocumentSurface, ASeriesOfDragsIsOneStep) {
    const auto d = withBox();
    ASSERT_TRUE(d->fillet(request(0.2)));
    for (const double r : {0.3, 0.4, 0.5}) {
        FilletRequest drag = request(r);
        drag.replace = true;
        ASSERT_TRUE(d->fillet(drag));
    }
    EXPECT_EQ(d->undoStack().index(), 2);
    EXPECT_EQ(d->state().surface.radius({0, 3}), 0.5);
    // Other edges are another step.
    FilletRequest one = request(0.6, {kPicked, {{0, 3}}});
    one.replace = true;
    ASSERT_TRUE(d->fillet(one));
    EXPECT_EQ(d->undoStack().index(), 3);
    EXPECT_EQ(d->undoStack().undoText(), QStringLiteral("Fillet 1 edge"));
    EXPECT_EQ(d->state().surface.radius({0, 3}), 0.6);
    EXPECT_EQ(d->state().surface.radius({0, 4}), 0.5);
    // Back where it was: the step is gone.
    one.radius = 0.5;
    ASSERT_TRUE(d->fillet(one));
    EXPECT_EQ(d->undoStack().index(), 2);
    ASSERT_TRUE(d->undo());
    EXPECT_FALSE(d->shape()->hasCage()) << "undo leads to before the first drag";
}

TEST(DocumentSurface, BadInputIsRefusedAndChangesNothing) {
    const auto empty = fakeDocument();
    EXPECT_EQ(empty->fillet(request(1)).error().code, Errc::NoSolid);
    EXPECT_EQ(empty->subdivide(uniform(2)).error().code, Errc::NoSolid);
    EXPECT_EQ(empty->mapStrokes().error().code, Errc::EmptySketch);
    ASSERT_TRUE(empty->addStroke(line({0, 0}, {9, 9})));
    EXPECT_EQ(empty->mapStrokes().error().code, Errc::NoSurface);

    const auto d = withBox();
    const auto* state = &d->state();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    for (const double radius : {0.0, -1.0, nan, inf, 1e12}) {
        EXPECT_EQ(d->fillet(request(radius)).error().code, Errc::BadValue) << radius;
    }
    for (const int segments : {0, -3, 17}) {
        FilletRequest r = request(1);
        r.segments = segments;
        EXPECT_EQ(d->fillet(r).error().code, Errc::BadValue) << segments;
    }
    EXPECT_EQ(d->fillet(request(1, {kPicked, {}})).error().code, Errc::NoEdge);
    EXPECT_EQ(d->fillet(request(1, {EdgeChoice::Which::Concave, {}})).error().code, Errc::NoEdge);
    for (const EdgeRef bad : {EdgeRef{0, 12}, EdgeRef{1, 0}, EdgeRef{-1, 0}, EdgeRef{0, -1}}) {
        EXPECT_EQ(d->fillet(request(1, {kPicked, {bad}})).error().code, Errc::BadValue);
    }
    EXPECT_EQ(d->sharpen({}).error().code, Errc::NoEdge);
    for (const double sharpness : {-0.5, 10.5, nan}) {
        EXPECT_EQ(d->crease({}, sharpness).error().code, Errc::BadValue);
        SubdivisionSettings s = uniform(2);
        s.sharpness = sharpness;
        EXPECT_EQ(d->subdivide(s).error().code, Errc::BadValue);
    }
    for (const int levels : {0, -1, 7}) {
        EXPECT_EQ(d->subdivide(uniform(levels)).error().code, Errc::BadValue);
    }
    SubdivisionSettings fine = uniform(2);
    for (const double tolerance : {-1.0, nan, inf}) {
        fine.tolerance = tolerance;
        EXPECT_EQ(d->subdivide(fine).error().code, Errc::BadValue);
    }
    EXPECT_EQ(&d->state(), state);
    EXPECT_EQ(d->undoStack().index(), 1);
}

TEST(DocumentSurface, ARadiusFarTooLargeIsClampedAndTold) {
    const auto d = withBox();
    const auto outcome = d->fillet(request(1000));
    ASSERT_TRUE(outcome);
    ASSERT_FALSE(outcome->clamped.empty());
    for (const ClampedEdge& c : outcome->clamped) {
        EXPECT_EQ(c.requested, 1000);
        EXPECT_LT(c.used, 20.0);
        EXPECT_TRUE(c.limitingEdge >= 0 || c.limitingVertex >= 0);
        const std::string text = clampText(d->state().bodies, c);
        EXPECT_NE(text.find("instead of 1000 mm"), std::string::npos) << text;
    }
    EXPECT_EQ(d->state().surface.radius({0, 0}), 1000) << "the setting is what was asked for";
    EXPECT_GT(volumeOf(*d), 0);
    // The edge alone that has no room is clamped: a long one beside it keeps its radius.
    const auto one = withBox();
    const auto picked = one->fillet(request(0.9, {kPicked, {{0, 0}}}));
    ASSERT_TRUE(picked);
    EXPECT_TRUE(picked->clamped.empty());
}

TEST(DocumentSurface, SharpenTakesFilletsAwayFromSomeEdges) {
    const auto d = withBox();
    ASSERT_TRUE(d->fillet(request(0.5)));
    ASSERT_TRUE(d->sharpen({kPicked, {{0, 2}, {0, 5}, {0, 2}}}));
    EXPECT_EQ(d->undoStack().undoText(), QStringLiteral("Sharpen 2 edges"));
    EXPECT_EQ(d->state().surface.radius({0, 2}), 0);
    EXPECT_EQ(d->state().surface.radius({0, 3}), 0.5);
    EXPECT_EQ(d->sharpen({kPicked, {{0, 2}}}).error().code, Errc::NoEdge);
    ASSERT_TRUE(d->sharpen({}));
    EXPECT_EQ(d->state().surface, SurfaceSettings{}) << "nothing is left of the settings";
}

TEST(DocumentSurface, EdgesThatAreNotFilletedAreSmoothOnlyWhereNothingIsFilleted) {
    const auto d = withBox();
    ASSERT_TRUE(d->subdivide(uniform(3)));
    EXPECT_EQ(d->undoStack().undoText(), QStringLiteral("Smooth surface"));
    ASSERT_TRUE(d->shape()->bodies[0].surface);
    EXPECT_LT(volumeOf(*d), 0.8 * 2400) << "a subdivided box is a round thing";
    ASSERT_TRUE(d->fillet(request(0.5, {kPicked, {{0, 0}}})));
    EXPECT_GT(volumeOf(*d), 0.95 * 2400) << "beside a fillet the other edges stay sharp";
    ASSERT_TRUE(d->crease({}, 0.0));
    EXPECT_LT(volumeOf(*d), 0.9 * 2400);
    ASSERT_TRUE(d->crease({}, kAutomaticSharpness));
    EXPECT_GT(volumeOf(*d), 0.95 * 2400);
    SubdivisionSettings off;
    ASSERT_TRUE(d->subdivide(off));
    EXPECT_EQ(d->undoStack().undoText(), QStringLiteral("Surface off"));
    EXPECT_FALSE(d->shape()->hasSurface());
}

TEST(DocumentSurface, TheTwoSchemesAndTheAdaptiveSurfaceAgreeOnTheShape) {
    const auto d = withBox();
    FilletRequest r = request(0.6);
    r.segments = 2;
    ASSERT_TRUE(d->fillet(r));
    ASSERT_TRUE(d->subdivide(uniform(4)));
    const double fine = volumeOf(*d);
    SubdivisionSettings adaptive = uniform(3);
    adaptive.tolerance = 0.01;
    ASSERT_TRUE(d->subdivide(adaptive));
    EXPECT_NEAR(volumeOf(*d), fine, 0.005 * fine);
    EXPECT_LE(d->shape()->bodies[0].surface->triangles.size(), 20000U);
    SubdivisionSettings loop = uniform(4);
    loop.scheme = SubdivisionScheme::Loop;
    ASSERT_TRUE(d->subdivide(loop));
    EXPECT_NEAR(volumeOf(*d), fine, 0.02 * fine);
}

TEST(DocumentSurface, ASurfaceAboveTheMemoryLimitIsRefused) {
    const auto d = withBox();
    addBox(*d);
    ASSERT_TRUE(d->fillet(request(0.5)));
    d->setSurfaceMemoryLimit(1U << 20U);
    const auto refused = d->subdivide(uniform(6));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, Errc::TooMuchMemory);
    EXPECT_FALSE(d->state().surface.subdivision.on);
    ASSERT_TRUE(d->subdivide(uniform(1)));
    EXPECT_TRUE(d->shape()->bodies[0].surface && d->shape()->bodies[1].surface);
    // A surface that stands when the limit falls is no longer made; the settings stay.
    d->setSurfaceMemoryLimit(1000);
    ASSERT_TRUE(d->shape()->problem);
    EXPECT_EQ(d->shape()->problem->code, Errc::TooMuchMemory);
    EXPECT_FALSE(d->shape()->hasSurface());
    EXPECT_TRUE(d->shape()->hasCage());
    EXPECT_TRUE(d->fillet(request(0.4))) << "other things can still be changed";
    d->setSurfaceMemoryLimit(1U << 20U);
    EXPECT_FALSE(d->shape()->problem);
    EXPECT_TRUE(d->shape()->hasSurface());
}

TEST(DocumentSurface, NearestEdgesNameWhatWasMeantAlsoWhereBodiesCoincide) {
    const auto d = withBox();
    addBox(*d);  // exactly where the first one is
    const auto& bodies = d->state().bodies;
    for (int e = 0; e < 12; ++e) {
        const auto point = pointNaming(bodies, {0, e});
        ASSERT_TRUE(point);
        EXPECT_EQ(*nearestEdge(bodies, *point), (EdgeRef{0, e}));
        EXPECT_FALSE(pointNaming(bodies, {1, e})) << "the first body covers it";
        EXPECT_EQ(*nearestEdge(bodies, *point, 1), (EdgeRef{1, e}));
    }
    EXPECT_EQ(nearestEdge(bodies, Vec3::Zero(), 2).error().code, Errc::NoEdge);
    EXPECT_EQ(nearestEdge(bodies, Vec3(0, NAN, 0)).error().code, Errc::BadValue);
}

TEST(DocumentSurface, ColoursAreReadStrictly) {
    const auto color = parseColor("#1f4E9c");
    ASSERT_TRUE(color);
    EXPECT_EQ(colorText(*color), "#1f4e9c");
    EXPECT_EQ(*parseColor("red"), (StrokeColor{255, 0, 0}));
    for (const char* bad : {"", "1f4e9c", "#1f4e9", "#1f4e9g", "#1f4e9c0", "blau", "transparent"}) {
        EXPECT_FALSE(parseColor(bad)) << bad;
    }
}

}  // namespace
}  // namespace ew
