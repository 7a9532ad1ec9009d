// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/control_cage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/surface/surface_fixture.h"

namespace ew::test {
namespace {

TEST(ControlCage, FlatFacesStayFlatInsideTheirSupportLoop) {
    const Solid box = solidOf(boxSpec({0, 0, 0}, {4, 3, 2}));
    const double setback = 0.4;
    const auto nearCorner = [&](const Vec3& p) {
        const double reach = 3.0 * setback;
        return std::min(p.x(), 4 - p.x()) < reach && std::min(p.y(), 3 - p.y()) < reach;
    };
    for (const auto scheme : {SubdivisionScheme::CatmullClark, SubdivisionScheme::Loop}) {
        const ControlCage cage = filletedCage(box, setback, scheme);
        SubdivisionOptions options;
        options.scheme = scheme;
        options.levels = 4;
        const SurfaceMesh surface = surfaceOf(cage, options);
        int onTop = 0;
        for (std::size_t i = 0; i < surface.positions.size(); ++i) {
            const Vec3& p = surface.positions[i];
            // Within the loop, a quarter of a setback inside the strip's side; its corners move in
            // by less than half of that again.
            const double edge = 1.25 * setback + (nearCorner(p) ? 0.12 * setback : 0.0) + 1e-9;
            const bool inside =
                p.x() > edge && p.x() < 4 - edge && p.y() > edge && p.y() < 3 - edge;
            if (!inside || p.z() < 1.0) continue;
            ++onTop;
            EXPECT_NEAR(p.z(), 2.0, 1e-12);
            EXPECT_NEAR(surface.normals[i].z(), 1.0, 1e-9);
        }
        EXPECT_GT(onTop, 50);
    }
}

TEST(ControlCage, SharpEdgesStayAndHaveANormalOnEachSide) {
    const Solid box = solidOf(boxSpec({0, 0, 0}, {2, 2, 2}));
    const ControlCage cage = controlOf(sharpCage(box));
    EXPECT_EQ(cage.creases.size(), 12U);
    SubdivisionOptions options;
    options.levels = 2;
    const SurfaceMesh surface = surfaceOf(cage, options);
    EXPECT_NEAR(enclosedVolume(surface.positions, surface.triangles), 8.0, 1e-12);
    ASSERT_EQ(surface.normalTriangles.size(), surface.triangles.size());
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(surface.normal(t, k).cwiseAbs().maxCoeff(), 1.0, 1e-9);
        }
    }
    options.tolerance = 0.1;
    const SurfaceMesh adaptive = surfaceOf(cage, options);
    EXPECT_EQ(adaptive.triangles.size(), 12U);
    EXPECT_NEAR(enclosedVolume(adaptive.positions, adaptive.triangles), 8.0, 1e-12);
}

TEST(ControlCage, FlatFacesBetweenSharpEdgesAreCoveredOnce) {
    // Around a pocket and beside a boss.
    std::vector<bool> filled(48, true);
    filled[16 + 5] = false;
    std::fill(filled.begin() + 32, filled.end() - 1, false);
    const Solid box =
        solidOf(cellsSpec({{{0, 2, 7, 8, 12}, {0, 2, 4, 5, 9}, {0, 3, 4, 6}}}, filled));
    for (const auto scheme : {SubdivisionScheme::CatmullClark, SubdivisionScheme::Loop}) {
        SubdivisionOptions options;
        options.scheme = scheme;
        options.levels = 3;
        ControlOptions control;
        control.scheme = scheme;
        const SurfaceMesh surface = surfaceOf(controlOf(sharpCage(box), control), options);
        double area = 0.0;
        for (const auto& t : surface.triangles) {
            const Vec3& a = surface.positions[static_cast<std::size_t>(t[0])];
            const Vec3& b = surface.positions[static_cast<std::size_t>(t[1])];
            const Vec3& c = surface.positions[static_cast<std::size_t>(t[2])];
            area += 0.5 * (b - a).cross(c - a).norm();
        }
        // What is folded over is there three times.
        EXPECT_NEAR(area, box.area(), 1e-9);
    }
}

TEST(ControlCage, AStripEndsSharplyInASharpFace) {
    const Solid box = solidOf(boxSpec({0, 0, 0}, {2, 2, 2}));
    FilletOptions one{{{0, 0.5}}, 4};
    const SolidEdge& edge = box.edges()[0];
    const Vec3 along = (box.vertices()[static_cast<std::size_t>(edge.ends[1])] -
                        box.vertices()[static_cast<std::size_t>(edge.ends[0])])
                           .normalized();
    const auto cage = fillet(box, one);
    ASSERT_TRUE(cage);
    const SurfaceMesh surface = surfaceOf(controlOf(*cage), {});
    // Area of the two ends, which stay in their planes.
    double area = 0.0;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const auto at = [&](std::size_t k) -> const Vec3& {
            return surface.positions[static_cast<std::size_t>(surface.triangles[t][k])];
        };
        const bool atEnd =
            std::abs(along.dot(at(0) - at(1))) + std::abs(along.dot(at(0) - at(2))) < 1e-12;
        const double where = std::abs(along.dot(at(0)));
        if (atEnd && (where < 1e-12 || std::abs(where - 2.0) < 1e-12)) {
            area += 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
        }
    }
    EXPECT_NEAR(area, 2.0 * 4.0, 0.05 * 8.0);
    EXPECT_NEAR(enclosedVolume(surface.positions, surface.triangles), 8.0, 0.05 * 8.0);
}

TEST(ControlCage, EverySharpEndIsAnEdgeOfTheMesh) {
    const Solid bosses = solidOf(bossesSpec(2));
    const Solid box = solidOf(boxSpec({0, 0, 0}, {4, 3, 2}));
    for (const Solid& solid : {box, bosses}) {
        const int count = static_cast<int>(solid.edges().size());
        for (int step = 1; step <= 5; ++step) {
            for (const int segments : {1, 3}) {
                FilletOptions options;
                options.segments = segments;
                for (int e = step % 3; e < count; e += step) options.edges.push_back({e, 0.1});
                const auto cage = fillet(solid, options);
                ASSERT_TRUE(cage);
                std::set<std::pair<int, int>> edges;
                for (int f = 0; f < cage->mesh.faceCount(); ++f) {
                    for (int l = 0; l < cage->mesh.loopCount(f); ++l) {
                        const auto loop = cage->mesh.loop(f, l);
                        for (std::size_t k = 0; k < loop.size(); ++k) {
                            edges.emplace(loop[k], loop[(k + 1) % loop.size()]);
                        }
                    }
                }
                for (const CageSharpEdge& e : cage->sharpEnds) {
                    EXPECT_TRUE(edges.contains({e.from, e.to})) << step << ' ' << segments;
                    EXPECT_EQ(cage->setbacks[static_cast<std::size_t>(e.edge)], 0.0);
                }
                SubdivisionOptions fine;
                fine.levels = 2;
                const SurfaceMesh surface = surfaceOf(controlOf(*cage), fine);
                EXPECT_TRUE(checkClosed(asMesh(surface)));
            }
        }
    }
}

TEST(ControlCage, SharpnessIsBetweenSmoothAndSharp) {
    const Solid box = solidOf(boxSpec({0, 0, 0}, {2, 2, 2}));
    double before = 0.0;
    for (const double sharpness : {0.0, 0.5, 1.0, 2.0, 4.0, kInfiniteSharpness}) {
        ControlOptions control;
        control.edgeSharpness.assign(12, sharpness);
        const SurfaceMesh surface = surfaceOf(controlOf(sharpCage(box), control), {});
        const double volume = enclosedVolume(surface.positions, surface.triangles);
        EXPECT_GT(volume, before);
        before = volume;
    }
    ControlOptions control;
    control.edgeSharpness.assign(12, 0.0);
    control.sharpCorners = true;
    const SurfaceMesh surface = surfaceOf(controlOf(sharpCage(box), control), {});
    for (const Vec3& corner : box.vertices()) {
        EXPECT_TRUE(std::any_of(surface.positions.begin(), surface.positions.end(),
                                [&](const Vec3& p) { return (p - corner).norm() < 1e-9; }));
    }
}

TEST(ControlCage, FacesWithHolesBecomeQuadrangles) {
    const Solid bosses = solidOf(bossesSpec(2));
    const ControlCage cage = filletedCage(bosses, 0.1, SubdivisionScheme::CatmullClark);
    int quads = 0;
    for (int f = 0; f < cage.mesh.faceCount(); ++f) {
        EXPECT_EQ(cage.mesh.loopCount(f), 1);
        if (cage.mesh.outline(f).size() == 4) ++quads;
    }
    EXPECT_GT(quads, 0.9 * cage.mesh.faceCount());
}

}  // namespace
}  // namespace ew::test
