// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/visibility.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/solid/boolean.h"
#include "tests/solid/shapes.h"
#include "tests/support/random.h"

namespace ew::test {
namespace {

OrthographicCamera lookAlong(const Vec3& direction, const Vec3& center = Vec3::Zero()) {
    OrthographicCamera camera;
    camera.direction = direction.normalized();
    camera.up = std::abs(camera.direction.z()) > 0.9 ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
    camera.center = center;
    camera.worldPerPixel = 0.02;
    return camera;
}

SolidView viewOf(const Solid& solid, const OrthographicCamera& camera, const Pose& pose = {}) {
    const auto view = SolidView::make(solid, pose, camera);
    EXPECT_TRUE(view);
    return *view;
}

std::size_t countIf(const std::vector<VisiblePiece>& pieces, bool (*what)(const VisiblePiece&)) {
    return static_cast<std::size_t>(std::count_if(pieces.begin(), pieces.end(), what));
}

// The oracle: samples along every edge, against every triangle -----------------------------------

/// Is a point hidden by anything nearer to the eye? Brute force in world coordinates.
bool hidden(const Solid& solid, const SolidEdge& edge, const Vec3& p, const Vec3& toEye) {
    for (const SolidTriangle& t : solid.triangles()) {
        if (t.face == edge.faces[0] || t.face == edge.faces[1]) continue;
        const Vec3& a = solid.vertices()[static_cast<std::size_t>(t.vertices[0])];
        const Vec3 u = solid.vertices()[static_cast<std::size_t>(t.vertices[1])] - a;
        const Vec3 v = solid.vertices()[static_cast<std::size_t>(t.vertices[2])] - a;
        const Vec3 h = toEye.cross(v);
        const double det = u.dot(h);
        if (std::abs(det) < 1e-12) continue;
        const Vec3 s = p - a;
        const double alpha = s.dot(h) / det;
        const Vec3 q = s.cross(u);
        const double beta = toEye.dot(q) / det;
        if (alpha < 0 || beta < 0 || alpha + beta > 1) continue;
        if (v.dot(q) / det > 1e-6) return true;
    }
    return false;
}

/// Compares the pieces with samples; samples next to where a piece ends say nothing.
void checkAgainstSamples(const Solid& solid, const OrthographicCamera& camera) {
    const SolidView view = viewOf(solid, camera);
    const auto pieces = view.visiblePieces();
    const Vec3 toEye = -camera.direction;
    constexpr int kSamples = 101;
    for (std::size_t e = 0; e < solid.edges().size(); ++e) {
        const SolidEdge& edge = solid.edges()[e];
        const Vec3 a = solid.vertices()[static_cast<std::size_t>(edge.ends[0])];
        const Vec3 b = solid.vertices()[static_cast<std::size_t>(edge.ends[1])];
        const auto looksAway = [&](int f) {
            return solid.faces()[static_cast<std::size_t>(f)].normal.dot(toEye) <= 0.0;
        };
        const bool behind = looksAway(edge.faces[0]) && looksAway(edge.faces[1]);
        for (int k = 0; k < kSamples; ++k) {
            const double t = (k + 0.5) / kSamples;
            bool claimed = false;
            bool unsure = false;
            for (const VisiblePiece& piece : pieces) {
                if (piece.edge != static_cast<int>(e)) continue;
                claimed |= t > piece.t0 && t < piece.t1;
                unsure |= std::abs(t - piece.t0) < 1e-6 || std::abs(t - piece.t1) < 1e-6;
            }
            if (unsure) continue;
            const bool seen = !behind && !hidden(solid, edge, a + t * (b - a), toEye);
            ASSERT_EQ(claimed, seen)
                << "edge " << e << " at " << t << " of " << solid.edges().size();
        }
    }
}

Solid randomSolid(Random& random, int steps) {
    Solid solid = *Solid::fromSpec(box(Vec3(2, 2, 2), Vec3(9, 9, 9)));
    for (int i = 0; i < steps; ++i) {
        Vec3 low;
        Vec3 high;
        for (int k = 0; k < 3; ++k) {
            low[k] = random.index(10);
            high[k] = low[k] + 1 + random.index(4);
        }
        const auto tool = Solid::fromSpec(box(low, high));
        const auto out =
            combine(solid, *tool, random.chance(0.5) ? BooleanKind::Add : BooleanKind::Cut);
        if (out) solid = out->solid;
    }
    return solid;
}

RC_GTEST_PROP(Visibility, AgreesWithSamplesFromAnySide, ()) {
    Random random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1 << 30)));
    const Solid solid = randomSolid(random, 8);
    const Vec3 direction(random.normal(), random.normal(), random.normal());
    checkAgainstSamples(solid, lookAlong(direction, Vec3(5, 5, 5)));
    RC_ASSERT(!::testing::Test::HasFatalFailure());
}

TEST(Visibility, AgreesWithSamplesOnAHoledTurnedBody) {
    for (const double angle : {0.1, 0.8, 2.0, 4.4}) {
        const auto ring = Solid::fromSpec(moved(torus(8, 5), angle, 1.0, Vec3(1, 2, 3)));
        ASSERT_TRUE(ring);
        checkAgainstSamples(*ring, lookAlong(Vec3(-1, 1, -1), Vec3(1, 2, 3)));
    }
}

// Known pictures ---------------------------------------------------------------------------------

TEST(Visibility, ABoxShowsNineEdges) {
    const Solid solid = *Solid::fromSpec(box(Vec3::Zero(), Vec3(4, 3, 2)));
    const auto pieces = viewOf(solid, lookAlong(Vec3(-1, 1, -1))).visiblePieces();
    EXPECT_EQ(pieces.size(), 9U);
    EXPECT_EQ(countIf(pieces, [](const VisiblePiece& p) { return p.silhouette; }), 6U);
    for (const VisiblePiece& p : pieces) {
        EXPECT_EQ(p.t0, 0.0);
        EXPECT_EQ(p.t1, 1.0);
        const auto& ends = solid.edges()[static_cast<std::size_t>(p.edge)].ends;
        for (std::size_t k = 0; k < 2; ++k) {
            EXPECT_EQ(p.ends[k].kind, PieceEnd::Kind::Vertex);
            EXPECT_EQ(p.ends[k].index, ends[k]);
        }
    }
}

TEST(Visibility, PiecesProjectLikeTheCamera) {
    const Solid solid = *Solid::fromSpec(box(Vec3::Zero(), Vec3(4, 3, 2)));
    Pose pose;
    pose.rotation = Eigen::AngleAxisd(0.3, Vec3(1, 1, 2).normalized()).toRotationMatrix();
    pose.translation = Vec3(0.5, -1, 2);
    const OrthographicCamera camera = lookAlong(Vec3(-1, 2, -1), Vec3(1, 1, 1));
    const SolidView view = viewOf(solid, camera, pose);
    for (std::size_t v = 0; v < 8; ++v) {
        const Vec3 world = pose.toWorld(solid.vertices()[v]);
        EXPECT_LT((view.points()[v] - camera.project(world)).norm(), 1e-9);
        EXPECT_NEAR(view.depths()[v], camera.depthPx(world), 1e-9);
    }
    for (const VisiblePiece& p : view.visiblePieces()) {
        const auto& ends = solid.edges()[static_cast<std::size_t>(p.edge)].ends;
        for (std::size_t k = 0; k < 2; ++k) {
            EXPECT_EQ(p.px[k], view.points()[static_cast<std::size_t>(ends[k])]);
        }
    }
}

/// Seen straight along an axis: four edges, and four that are seen end-on.
TEST(Visibility, ABoxFromTheFront) {
    const Solid solid = *Solid::fromSpec(box(Vec3::Zero(), Vec3(4, 3, 2)));
    for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0),
                                  Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
        const auto pieces = viewOf(solid, lookAlong(direction)).visiblePieces();
        EXPECT_EQ(countIf(pieces, [](const VisiblePiece& p) { return !p.point; }), 4U);
        EXPECT_EQ(countIf(pieces, [](const VisiblePiece& p) { return p.point; }), 4U);
        for (const VisiblePiece& p : pieces) {
            if (!p.point) continue;
            EXPECT_EQ(p.px[0], p.px[1]);
            // The near end is the visible one.
            const auto& edge = solid.edges()[static_cast<std::size_t>(p.edge)];
            const auto at = [&](int v) {
                return solid.vertices()[static_cast<std::size_t>(v)].dot(direction);
            };
            EXPECT_EQ(at(p.ends[0].index), std::min(at(edge.ends[0]), at(edge.ends[1])));
        }
    }
}

/// Steps seen from the front: inner edges coincide with nearer ones and are not drawn twice.
TEST(Visibility, StepsFromTheFront) {
    Solid solid = *Solid::fromSpec(box(Vec3::Zero(), Vec3(6, 6, 1)));
    solid = combine(solid, *Solid::fromSpec(box(Vec3(0, 2, 1), Vec3(6, 6, 2))), BooleanKind::Add)
                ->solid;
    solid = combine(solid, *Solid::fromSpec(box(Vec3(0, 4, 2), Vec3(6, 6, 3))), BooleanKind::Add)
                ->solid;
    const auto pieces = viewOf(solid, lookAlong(Vec3(0, 1, 0))).visiblePieces();
    std::vector<double> levels;
    for (const VisiblePiece& p : pieces) {
        if (p.point || std::abs(p.px[0].y() - p.px[1].y()) > 1e-9) continue;
        levels.push_back(p.px[0].y());
    }
    std::sort(levels.begin(), levels.end());
    ASSERT_EQ(levels.size(), 4U);  // ground, two treads, top: each once
    for (std::size_t k = 1; k < 4; ++k) EXPECT_NEAR(levels[k] - levels[k - 1], 50.0, 1e-9);
}

/// An edge that runs behind a boss ends in two T junctions, which name the boss's edges.
TEST(Visibility, EdgesEndBehindABoss) {
    Solid solid = *Solid::fromSpec(box(Vec3::Zero(), Vec3(10, 6, 2)));
    solid = combine(solid, *Solid::fromSpec(box(Vec3(4, 2, 2), Vec3(6, 4, 8))), BooleanKind::Add)
                ->solid;
    const SolidView view = viewOf(solid, lookAlong(Vec3(0, 1, -0.6)));
    int broken = 0;
    for (const VisiblePiece& p : view.visiblePieces()) {
        for (std::size_t k = 0; k < 2; ++k) {
            if (p.ends[k].kind != PieceEnd::Kind::Occluded) continue;
            ++broken;
            const auto& contour = solid.edges()[static_cast<std::size_t>(p.ends[k].index)];
            for (const int v : contour.ends) {
                EXPECT_GE(solid.vertices()[static_cast<std::size_t>(v)].z(), 2.0);
            }
            // The junction lies on the contour's line in the picture.
            const Vec2 a = view.points()[static_cast<std::size_t>(contour.ends[0])];
            const Vec2 b = view.points()[static_cast<std::size_t>(contour.ends[1])];
            EXPECT_LT(std::abs(cross2(b - a, p.px[k] - a)) / (b - a).norm(), 1e-6);
        }
    }
    EXPECT_EQ(broken, 2);  // the slab's far top edge
}

TEST(Visibility, TouchingPartsHideNothingOfTheirOwn) {
    // Two shells a hair apart and a boss flush with two sides.
    Solid solid = *Solid::fromSpec(box(Vec3::Zero(), Vec3(4, 4, 2)));
    solid = combine(solid, *Solid::fromSpec(box(Vec3(0, 0, 2), Vec3(2, 2, 4))), BooleanKind::Add)
                ->solid;
    for (const Vec3& direction :
         {Vec3(1, 1, -1), Vec3(-1, 1, -1), Vec3(1, -1, -1), Vec3(-1, -1, 1)}) {
        checkAgainstSamples(solid, lookAlong(direction));
    }
}

// Picking ----------------------------------------------------------------------------------------

RC_GTEST_PROP(Visibility, PickFindsTheNearestFace, ()) {
    Random random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1 << 30)));
    const Solid solid = randomSolid(random, 6);
    const OrthographicCamera camera =
        lookAlong(Vec3(random.normal(), random.normal(), random.normal()), Vec3(5, 5, 5));
    const SolidView view = viewOf(solid, camera);
    for (int i = 0; i < 100; ++i) {
        const Vec2 px(640 + random.uniform(-400, 400), 400 + random.uniform(-400, 400));
        // The oracle: the nearest triangle along the ray from far before the solid.
        const Vec3 eye = camera.unproject(px, -1e5);
        int face = -1;
        double nearest = 1e300;
        for (const SolidTriangle& t : solid.triangles()) {
            const Vec3& a = solid.vertices()[static_cast<std::size_t>(t.vertices[0])];
            const Vec3 u = solid.vertices()[static_cast<std::size_t>(t.vertices[1])] - a;
            const Vec3 v = solid.vertices()[static_cast<std::size_t>(t.vertices[2])] - a;
            const Vec3 h = camera.direction.cross(v);
            const double det = u.dot(h);
            if (std::abs(det) < 1e-12) continue;
            const Vec3 s = eye - a;
            const double alpha = s.dot(h) / det;
            const Vec3 q = s.cross(u);
            const double beta = camera.direction.dot(q) / det;
            if (alpha < 0 || beta < 0 || alpha + beta > 1) continue;
            const double along = v.dot(q) / det;
            if (along < nearest) {
                nearest = along;
                face = t.face;
            }
        }
        const auto pick = view.pick(px);
        RC_ASSERT(pick.has_value() == (face >= 0));
        if (!pick) continue;
        RC_ASSERT((pick->world - (eye + nearest * camera.direction)).norm() < 1e-6);
        const SolidFace& seen = solid.faces()[static_cast<std::size_t>(pick->face)];
        RC_ASSERT(std::abs(seen.normal.dot(pick->body) - seen.offset) < 1e-6);
    }
}

TEST(Visibility, PickBesideTheSolidAndBadPlaces) {
    const Solid solid = *Solid::fromSpec(box(Vec3::Zero(), Vec3(4, 3, 2)));
    const SolidView view = viewOf(solid, lookAlong(Vec3(0, 0, -1), Vec3(2, 1.5, 0)));
    EXPECT_TRUE(view.pick(Vec2(640, 400)));
    EXPECT_FALSE(view.pick(Vec2(10, 10)));
    EXPECT_FALSE(view.pick(Vec2(std::nan(""), 400)));
    EXPECT_NEAR(view.pick(Vec2(640, 400))->world.z(), 2.0, 1e-9);
}

TEST(Visibility, ABadCameraIsRefused) {
    const Solid solid = *Solid::fromSpec(box(Vec3::Zero(), Vec3(4, 3, 2)));
    OrthographicCamera camera;
    camera.worldPerPixel = 0.0;
    const auto view = SolidView::make(solid, Pose{}, camera);
    ASSERT_FALSE(view);
    EXPECT_EQ(errcName(view.error().code), "bad-value");
}

}  // namespace
}  // namespace ew::test
