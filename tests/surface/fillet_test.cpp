// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/fillet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "tests/surface/shapes.h"

namespace ew::test {
namespace {

using Kind = CageOrigin::Kind;

int count(const FilletedCage& cage, Kind kind) {
    return static_cast<int>(std::count_if(cage.origins.begin(), cage.origins.end(),
                                          [&](const CageOrigin& o) { return o.kind == kind; }));
}

FilletedCage made(const Solid& solid, const FilletOptions& options) {
    auto cage = fillet(solid, options);
    EXPECT_TRUE(cage) << cage.error().message;
    EXPECT_EQ(faultsByExactArithmetic(*cage), "");
    EXPECT_EQ(cage->origins.size(), static_cast<std::size_t>(cage->mesh.faceCount()));
    return *cage;
}

/// The edges through all of these points' neighbourhoods, by their end points.
int edgeBetween(const Solid& solid, const Vec3& a, const Vec3& b) {
    for (std::size_t e = 0; e < solid.edges().size(); ++e) {
        const auto& ends = solid.edges()[e].ends;
        const Vec3& p = solid.vertices()[static_cast<std::size_t>(ends[0])];
        const Vec3& q = solid.vertices()[static_cast<std::size_t>(ends[1])];
        if ((p - a).norm() + (q - b).norm() < 1e-9 || (p - b).norm() + (q - a).norm() < 1e-9) {
            return static_cast<int>(e);
        }
    }
    ADD_FAILURE() << "no such edge";
    return -1;
}

TEST(Fillet, ChamferedCubeIsThatOfGeometry) {
    const Solid cube = solidOf(boxSpec({0, 0, 0}, {2, 2, 2}));
    const double s = 0.5;
    const FilletedCage cage = made(cube, allEdges(cube, s, 1));
    EXPECT_TRUE(cage.clamped.empty());
    EXPECT_EQ(count(cage, Kind::Face), 6);
    EXPECT_EQ(count(cage, Kind::Strip), 12);
    EXPECT_EQ(count(cage, Kind::Corner), 8);
    EXPECT_EQ(cage.mesh.points.size(), 24U);
    // Slices: the inner box, six slabs, twelve triangular prisms, eight corner tetrahedra.
    const double inner = 2.0 - 2.0 * s;
    const double expected =
        std::pow(inner, 3) + 6 * s * inner * inner + 12 * 0.5 * s * s * inner + 8 * s * s * s / 6.0;
    EXPECT_NEAR(volumeOf(cage), expected, 1e-12);
}

TEST(Fillet, RoundedBoxTendsToTheRollingBall) {
    const Solid box = solidOf(boxSpec({0, 0, 0}, {3, 2, 2.5}));
    const double r = 0.6;
    const double a = 3 - 2 * r;
    const double b = 2 - 2 * r;
    const double c = 2.5 - 2 * r;
    const double exact = a * b * c + 2 * r * (a * b + b * c + c * a) +
                         std::numbers::pi * r * r * (a + b + c) +
                         4.0 / 3.0 * std::numbers::pi * r * r * r;
    double before = 1.0;
    for (const int segments : {1, 2, 3, 4, 7, 8, 15, 16}) {
        const FilletedCage cage = made(box, allEdges(box, r, segments));
        const double miss = std::abs(volumeOf(cage) / exact - 1.0);
        EXPECT_LT(miss, before) << segments;
        before = miss;
    }
    EXPECT_LT(before, 1e-3);
    // All points of strips and corners lie on the ball's hull.
    const FilletedCage cage = made(box, allEdges(box, r, 16));
    for (const Vec3& p : cage.mesh.points) {
        const Vec3 low(r, r, r);
        const Vec3 high(3 - r, 2 - r, 2.5 - r);
        const Vec3 nearest = p.cwiseMax(low).cwiseMin(high);
        EXPECT_NEAR((p - nearest).norm(), r, 1e-9);
    }
}

TEST(Fillet, StripsBeginAtTheSetbackInBothFaces) {
    const Solid solid = solidOf(lPrismSpec());
    const double s = 0.2;
    const FilletedCage cage = made(solid, allEdges(solid, s, 5));
    for (std::size_t f = 0; f < cage.origins.size(); ++f) {
        const auto [kind, index] = cage.origins[f];
        for (const int i : cage.mesh.outline(static_cast<int>(f))) {
            const Vec3& p = cage.mesh.point(i);
            if (kind == Kind::Face) {
                const SolidFace& face = solid.faces()[static_cast<std::size_t>(index)];
                EXPECT_NEAR(face.normal.dot(p), face.offset, 1e-12);
            }
            if (kind != Kind::Strip) continue;
            const SolidEdge& edge = solid.edges()[static_cast<std::size_t>(index)];
            const Vec3& a = solid.vertices()[static_cast<std::size_t>(edge.ends[0])];
            const Vec3& b = solid.vertices()[static_cast<std::size_t>(edge.ends[1])];
            const Vec3 d = (b - a).normalized();
            const double distance = ((p - a) - d * d.dot(p - a)).norm();
            EXPECT_LT(distance, s + 1e-12);
            EXPECT_GT(distance, s * (std::numbers::sqrt2 - 1.0) - 1e-12);
        }
    }
    EXPECT_EQ(count(cage, Kind::Strip), 5 * 18);
}

TEST(Fillet, OneEdgeOfABoxEndsInTheFacesThere) {
    const Solid box = solidOf(boxSpec({0, 0, 0}, {2, 2, 2}));
    const int edge = edgeBetween(box, {0, 0, 2}, {2, 0, 2});
    const FilletedCage chamfer = made(box, {{{edge, 0.5}}, 1});
    EXPECT_EQ(chamfer.mesh.faceCount(), 7);
    EXPECT_EQ(chamfer.mesh.points.size(), 10U);
    EXPECT_NEAR(volumeOf(chamfer), 8.0 - 0.25, 1e-12);
    const FilletedCage round = made(box, {{{edge, 0.5}}, 16});
    EXPECT_EQ(count(round, Kind::Corner), 0);
    EXPECT_EQ(count(round, Kind::Strip), 16);
    EXPECT_NEAR(volumeOf(round), 8.0 - 2.0 * 0.25 * (1.0 - std::numbers::pi / 4), 2e-3);
}

TEST(Fillet, TwoStripsMeetInAMiterOverTheSharpEdge) {
    const Solid box = solidOf(boxSpec({0, 0, 0}, {2, 2, 2}));
    FilletOptions options{{}, 8};
    for (int e = 0; e < 12; ++e) {
        const auto& ends = box.edges()[static_cast<std::size_t>(e)].ends;
        const auto z = [&](int i) { return box.vertices()[static_cast<std::size_t>(i)].z(); };
        if (z(ends[0]) == 2.0 && z(ends[1]) == 2.0) options.edges.push_back({e, 0.5});
    }
    const FilletedCage cage = made(box, options);
    EXPECT_EQ(count(cage, Kind::Corner), 0);  // the strips share their ends
    EXPECT_EQ(count(cage, Kind::Strip), 32);
    options.edges[1].setback = 0.3;  // now they end at different heights
    const FilletedCage uneven = made(box, options);
    EXPECT_GT(count(uneven, Kind::Corner), 0);
    EXPECT_TRUE(uneven.clamped.empty());
}

TEST(Fillet, NotchCornerWithConvexAndConcaveEdges) {
    const Solid solid = solidOf(lPrismSpec());
    for (const int segments : {1, 2, 3, 8}) {
        const FilletedCage concave = made(solid, edgesOfKind(solid, false, 0.3, segments));
        EXPECT_GT(volumeOf(concave), 3.0);
        if (segments == 1) {
            EXPECT_NEAR(volumeOf(concave), 3.0 + 0.045, 1e-12);
        }
        const FilletedCage convex = made(solid, edgesOfKind(solid, true, 0.3, segments));
        EXPECT_LT(volumeOf(convex), 3.0);
        const FilletedCage both = made(solid, allEdges(solid, 0.3, segments));
        EXPECT_TRUE(both.clamped.empty());
    }
}

TEST(Fillet, EverySubsetOfEdgesOfANotchedCorner) {
    // The corner where a notch runs out: three edges, in all eight mixes, and its neighbours.
    const Solid solid = solidOf(cellsSpec({std::vector<double>{0, 1, 2}, {0, 1, 2}, {0, 1, 2}},
                                          {true, true, true, true, true, true, true, false}));
    const auto edgeCount = static_cast<int>(solid.edges().size());
    ASSERT_EQ(edgeCount, 21);
    Random random(5);
    for (int round = 0; round < 150; ++round) {
        FilletOptions options{{}, 1 + random.index(4)};
        for (int e = 0; e < edgeCount; ++e) {
            if (random.chance(0.4)) options.edges.push_back({e, random.uniform(0.05, 0.3)});
        }
        if (options.edges.empty()) continue;
        const FilletedCage cage = made(solid, options);
        EXPECT_TRUE(cage.clamped.empty()) << "round " << round;
    }
}

TEST(Fillet, PyramidApexOfManyEdges) {
    for (const int sides : {3, 4, 5, 8}) {
        const Solid pyramid = solidOf(pyramidSpec(sides, 1.5));
        for (const int segments : {1, 2, 5}) {
            const FilletedCage cage = made(pyramid, allEdges(pyramid, 0.1, segments));
            EXPECT_TRUE(cage.clamped.empty());
            EXPECT_LT(volumeOf(cage), pyramid.volume());
        }
    }
}

TEST(Fillet, AnEdgeThatDoesNotFitIsClampedAlone) {
    const Solid plate = solidOf(boxSpec({0, 0, 0}, {10, 10, 1}));
    const int top = edgeBetween(plate, {0, 0, 1}, {10, 0, 1});
    const int bottom = edgeBetween(plate, {0, 0, 0}, {10, 0, 0});
    const int far = edgeBetween(plate, {0, 10, 1}, {10, 10, 1});
    const FilletedCage cage = made(plate, {{{top, 3.0}, {bottom, 0.2}, {far, 0.9}}, 4});
    ASSERT_EQ(cage.clamped.size(), 1U);
    EXPECT_EQ(cage.clamped[0].edge, top);
    EXPECT_EQ(cage.clamped[0].requested, 3.0);
    EXPECT_NEAR(cage.clamped[0].used, 0.8, 0.02);
    const int limiting = cage.clamped[0].limitingEdge;
    const bool isUpright = limiting == edgeBetween(plate, {0, 0, 0}, {0, 0, 1}) ||
                           limiting == edgeBetween(plate, {10, 0, 0}, {10, 0, 1});
    EXPECT_TRUE(isUpright) << limiting;
}

TEST(Fillet, AThousandTimesTooBigIsClamped) {
    for (const Solid& solid : {solidOf(boxSpec({0, 0, 0}, {1, 2, 3})), solidOf(lPrismSpec()),
                               solidOf(bossesSpec(3)), solidOf(pyramidSpec(5, 1.0))}) {
        const FilletedCage cage = made(solid, allEdges(solid, 3000.0, 3));
        EXPECT_EQ(cage.clamped.size(), solid.edges().size());
        for (const FilletClamp& clamp : cage.clamped) {
            EXPECT_GT(clamp.used, 0.05);
            EXPECT_TRUE(clamp.limitingEdge >= 0 || clamp.limitingVertex >= 0);
        }
    }
}

TEST(Fillet, FacesWithHolesAndBosses) {
    const Solid solid = solidOf(bossesSpec(3));
    for (const int segments : {1, 2, 4}) {
        const FilletedCage cage = made(solid, allEdges(solid, 0.1, segments));
        EXPECT_TRUE(cage.clamped.empty());
        EXPECT_EQ(count(cage, Kind::Face), static_cast<int>(solid.faces().size()));
    }
    const FilletedCage convex = made(solid, edgesOfKind(solid, true, 0.1, 2));
    EXPECT_LT(volumeOf(convex), solid.volume());
    const FilletedCage concave = made(solid, edgesOfKind(solid, false, 0.1, 2));
    EXPECT_GT(volumeOf(concave), solid.volume());
}

TEST(Fillet, SomethingInTheWayClampsOnlyWhatMeetsIt) {
    // A slot under the top: its ceiling is 0.3 below the edges of the top.
    std::array<std::vector<double>, 3> lines{
        std::vector<double>{0, 0.3, 2.7, 3}, {0, 3}, {0, 1, 2.7, 3}};
    std::vector<bool> filled(9, true);
    filled[4] = false;  // a tunnel along y
    const Solid solid = solidOf(cellsSpec(lines, filled));
    const int above = edgeBetween(solid, {0, 0, 3}, {0, 3, 3});
    const int below = edgeBetween(solid, {0, 0, 0}, {0, 3, 0});
    const FilletedCage cage = made(solid, {{{above, 0.9}, {below, 0.9}}, 1});
    ASSERT_EQ(cage.clamped.size(), 1U);
    EXPECT_EQ(cage.clamped[0].edge, above);
    EXPECT_LT(cage.clamped[0].used, 0.6);
    EXPECT_GT(cage.clamped[0].used, 0.3);
}

TEST(Fillet, BadInputIsRefusedWithACode) {
    const Solid box = solidOf(boxSpec({0, 0, 0}, {1, 1, 1}));
    const auto code = [&](const FilletOptions& options) {
        const auto cage = fillet(box, options);
        return cage ? Errc::Internal : cage.error().code;
    };
    EXPECT_EQ(code({}), Errc::NoEdge);
    EXPECT_EQ(errcName(Errc::NoEdge), "no-edge");
    for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(code({{{0, bad}}, 1}), Errc::BadValue);
    }
    EXPECT_EQ(code({{{12, 0.1}}, 1}), Errc::BadValue);
    EXPECT_EQ(code({{{-1, 0.1}}, 1}), Errc::BadValue);
    EXPECT_EQ(code({{{3, 0.1}, {3, 0.2}}, 1}), Errc::BadValue);
    EXPECT_EQ(code({{{3, 0.1}}, 0}), Errc::BadValue);
    EXPECT_EQ(code({{{3, 0.1}}, 17}), Errc::BadValue);
}

TEST(Fillet, RadiusAndSetback) {
    const Solid box = solidOf(boxSpec({0, 0, 0}, {1, 1, 1}));
    EXPECT_NEAR(radiusForSetback(box, 0, 0.25), 0.25, 1e-12);
    // A triangular prism: 60 degrees between the sides, r = s tan(30 degrees).
    const Solid prism = solidOf(prismSpec(3, 1.0, 1.0, 1.0));
    for (std::size_t e = 0; e < prism.edges().size(); ++e) {
        const auto& ends = prism.edges()[e].ends;
        const Vec3 d = prism.vertices()[static_cast<std::size_t>(ends[0])] -
                       prism.vertices()[static_cast<std::size_t>(ends[1])];
        const double expected = std::abs(d.z()) > 0.5 ? std::tan(std::numbers::pi / 6) : 1.0;
        EXPECT_NEAR(radiusForSetback(prism, static_cast<int>(e), 1.0), expected, 1e-9);
        EXPECT_NEAR(setbackForRadius(prism, static_cast<int>(e), expected), 1.0, 1e-9);
    }
}

TEST(Fillet, TheSameInputGivesTheSameMesh) {
    const Solid solid = solidOf(bossesSpec(2));
    const auto a = fillet(solid, allEdges(solid, 0.2, 3));
    const auto b = fillet(solid, allEdges(solid, 0.2, 3));
    ASSERT_TRUE(a);
    ASSERT_TRUE(b);
    EXPECT_EQ(a->mesh.points, b->mesh.points);
    EXPECT_EQ(a->mesh.corners, b->mesh.corners);
}

TEST(Fillet, SharpCageIsTheSolid) {
    const Solid solid = solidOf(bossesSpec(1));
    const FilletedCage cage = sharpCage(solid);
    EXPECT_NEAR(volumeOf(cage), solid.volume(), 1e-12);
    EXPECT_EQ(faultsByExactArithmetic(cage), "");
}

}  // namespace
}  // namespace ew::test
