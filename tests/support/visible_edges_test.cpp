// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/visible_edges.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/random_shapes.h"
#include "tests/support/sketch_generator.h"

namespace ew::test {
namespace {

OrthographicCamera lookAlong(const Vec3& direction) {
    OrthographicCamera camera;
    camera.direction = direction.normalized();
    camera.worldPerPixel = 0.01;
    return camera;
}

TEST(SpecVolume, OfKnownBodies) {
    EXPECT_DOUBLE_EQ(specVolume(boxSpec(3, 2, 1)), 6.0);
    EXPECT_DOUBLE_EQ(specVolume(prismSpec({Vec2(0, 0), Vec2(2, 0), Vec2(0, 2)}, 5)), 10.0);
}

TEST(SpecEdges, HaveBothFaces) {
    for (const SpecEdge& e : specEdges(boxSpec(3, 2, 1))) EXPECT_GE(e.faces[1], 0);
    EXPECT_EQ(specEdges(boxSpec(3, 2, 1)).size(), 12U);
}

TEST(VisibleEdges, ABoxShowsNineOfTwelve) {
    const PolyhedronSpec box = boxSpec(3, 2, 1);
    const OrthographicCamera camera = lookAlong(Vec3(-1, -2, -1.5));
    const VisibleDrawing drawing = visibleEdges(box, camera);
    EXPECT_EQ(drawing.edges.size(), 9U);
    EXPECT_EQ(drawing.vertices, (std::vector<int>{1, 2, 3, 4, 5, 6, 7}));
    EXPECT_EQ(drawing.faces.size(), 3U);
    EXPECT_TRUE(drawing.tJunctions.empty());
    for (const VisibleEdge& e : drawing.edges) {
        for (std::size_t end = 0; end < 2; ++end) {
            const Vec3& v = box.vertices[static_cast<std::size_t>(e.vertices[end])];
            EXPECT_EQ(e.line[end], camera.project(v));
        }
    }
}

// An L on its side, seen from the front right and above so that its tall leg hides the far end of
// the step: the hidden edges end in T junctions on the leg's silhouette.
TEST(VisibleEdges, AnOccludedStepEndsInTJunctions) {
    const PolyhedronSpec l =
        prismSpec({Vec2(0, 0), Vec2(4, 0), Vec2(4, 1), Vec2(1, 1), Vec2(1, 4), Vec2(0, 4)}, 2);
    // The eye is at negative x: the tall leg (x 0..1) stands in front of the step (x 1..4).
    const VisibleDrawing drawing = visibleEdges(l, lookAlong(Vec3(2, -1, -1)));
    ASSERT_FALSE(drawing.tJunctions.empty());
    for (const Vec2& t : drawing.tJunctions) {
        const bool onABar =
            std::any_of(drawing.edges.begin(), drawing.edges.end(), [&](const VisibleEdge& e) {
                const Vec2 d = e.line[1] - e.line[0];
                const double along = (t - e.line[0]).dot(d) / d.squaredNorm();
                return std::abs(cross2(d, t - e.line[0])) / d.norm() < 1e-6 && along > 1e-6 &&
                       along < 1 - 1e-6;
            });
        EXPECT_TRUE(onABar);
    }
}

TEST(VisibleEdges, AConvexBodyShowsExactlyTheEdgesOfItsFrontFaces) {
    for (const char* id : {"cube", "triangular-prism", "triangular-pyramid", "wedge-frustum"}) {
        for (std::uint64_t seed = 0; seed < 50; ++seed) {
            Random random(seed);
            const SketchCase sketch = randomSketch(id, random);
            std::vector<int> wanted;
            const std::vector<SpecEdge> edges = specEdges(sketch.spec);
            for (std::size_t e = 0; e < edges.size(); ++e) {
                const auto front = [&](int f) {
                    return specFaceNormal(sketch.spec, static_cast<std::size_t>(f))
                               .dot(sketch.camera.direction) < 0;
                };
                if (front(edges[e].faces[0]) || front(edges[e].faces[1])) {
                    wanted.push_back(static_cast<int>(e));
                }
            }
            std::vector<int> seen;
            for (const VisibleEdge& e : sketch.drawing.edges) seen.push_back(e.edge);
            EXPECT_EQ(seen, wanted) << id << " seed " << seed;
            EXPECT_TRUE(sketch.drawing.tJunctions.empty());
        }
    }
}

// In a drawing of a solid every visible edge borders a region, so nothing but a T junction's stem
// may end alone.
TEST(VisibleEdges, OnlyTJunctionsEndAlone) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        Random random(seed);
        const SketchCase sketch = randomSketch("l-prism", random);
        for (const int v : sketch.drawing.vertices) {
            const auto ends = std::count_if(
                sketch.drawing.edges.begin(), sketch.drawing.edges.end(),
                [&](const VisibleEdge& e) { return e.vertices[0] == v || e.vertices[1] == v; });
            EXPECT_GE(ends, 2) << "seed " << seed << " vertex " << v;
        }
    }
}

}  // namespace
}  // namespace ew::test
