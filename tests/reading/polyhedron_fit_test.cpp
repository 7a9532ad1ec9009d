// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/polyhedron_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/reading/solve/base_tilt.h"
#include "tests/support/random.h"
#include "tests/support/random_shapes.h"

namespace ew::test {
namespace {

Mat3 attitude() {
    return (Eigen::AngleAxisd(0.7, Vec3::UnitX()) * Eigen::AngleAxisd(0.5, Vec3::UnitZ()))
        .toRotationMatrix();
}

std::vector<Vec2> regularPolygon(int n, double radius) {
    std::vector<Vec2> out;
    for (int k = 0; k < n; ++k) {
        const double a = 2.0 * std::numbers::pi * k / n;
        out.emplace_back(radius * std::cos(a), radius * std::sin(a));
    }
    return out;
}

/// A spec of some px, turned into camera space.
PolyhedronSpec seen(PolyhedronSpec spec) {
    for (Vec3& v : spec.vertices) v = attitude() * v + Vec3(300, 200, 0);
    return spec;
}

std::vector<DrawnVertex> drawn(const PolyhedronSpec& spec, double noise, Random& random) {
    std::vector<DrawnVertex> out;
    for (std::size_t v = 0; v < spec.vertices.size(); ++v) {
        out.push_back({static_cast<int>(v),
                       spec.vertices[v].head<2>() + noise * Vec2(random.normal(), random.normal()),
                       2.0});
    }
    return out;
}

const std::vector<Vec2> kHouse{{0, 0}, {200, 0}, {200, 120}, {100, 190}, {0, 120}};

TEST(PolyhedronFit, AnExactDrawingComesBack) {
    Random random(1);
    const PolyhedronSpec house = seen(prismSpec(kHouse, 150));
    const auto fit = fitPlanes(regularModel(house, attitude(), 1.0), drawn(house, 0, random), {});
    ASSERT_TRUE(fit);
    EXPECT_LT(fit->misfit, 1e-12);
    EXPECT_LT(fit->gapPx, 1e-9);
    for (std::size_t v = 0; v < house.vertices.size(); ++v) {
        EXPECT_LT((fit->camera[v] - house.vertices[v]).head<2>().norm(), 1e-6) << v;
    }
}

TEST(PolyhedronFit, WhatIsNearlyRegularIsExactlySo) {
    Random random(2);
    const PolyhedronSpec house = seen(prismSpec(kHouse, 150));
    PolyhedronSpec rough = house;
    for (Vec3& v : rough.vertices)
        v += 3.0 * Vec3(random.normal(), random.normal(), random.normal());
    const auto fit = fitPlanes(regularModel(rough, attitude(), 8.0), drawn(house, 2.0, random), {});
    ASSERT_TRUE(fit);
    // Walls and floor are across axes, to the bit; both slopes lean alike.
    EXPECT_EQ(fit->body[0].y(), fit->body[1].y());
    EXPECT_EQ(fit->body[0].x(), fit->body[4].x());
    EXPECT_EQ(fit->body[0].z(), fit->body[2].z());
    const Vec3 a = fit->body[3] - fit->body[4];
    const Vec3 b = fit->body[3] - fit->body[2];
    EXPECT_NEAR(a.y() / a.x(), -b.y() / b.x(), 1e-9);
    EXPECT_LT(fit->misfit, 2.5);
}

TEST(PolyhedronFit, ARegularRingHasEqualSidesAndTurns) {
    Random random(3);
    for (const double top : {1.0, 0.5}) {
        PolyhedronSpec spec = prismSpec(regularPolygon(6, 120), 160);
        for (std::size_t v = 6; v < 12; ++v) spec.vertices[v].head<2>() *= top;
        const PolyhedronSpec inCamera = seen(spec);
        PlaneModel model = regularModel(inCamera, attitude(), 8.0);
        makeRegularRing(model, {2, 3, 4, 5, 6, 7});
        const auto fit = fitPlanes(model, drawn(inCamera, 2.0, random), {});
        ASSERT_TRUE(fit);
        const double side = (fit->body[1] - fit->body[0]).norm();
        for (std::size_t k = 0; k < 6; ++k) {
            EXPECT_NEAR((fit->body[(k + 1) % 6] - fit->body[k]).norm(), side, 1e-9) << k;
            EXPECT_NEAR(fit->body[k].z(), fit->body[0].z(), 1e-9);
        }
        EXPECT_NEAR(side, 120.0, 6.0);
    }
}

TEST(PolyhedronFit, CountsItsFreedoms) {
    const PolyhedronSpec box = seen(ew::test::boxSpec(100, 80, 60));
    // Three sizes, three of attitude, two of place.
    EXPECT_EQ(regularModel(box, attitude(), 1.0).freedoms(), 8);
}

TEST(BaseTilt, RightAnglesAndRegularPolygonsTellIt) {
    for (const double deg : {25.0, 40.0, 60.0}) {
        const double sine = std::sin(deg * std::numbers::pi / 180.0);
        for (const auto& base : {kHouse, regularPolygon(6, 100), regularPolygon(8, 100)}) {
            std::vector<Vec2> picture;
            for (const Vec2& p : base) {
                const Vec2 turned(0.8 * p.x() - 0.6 * p.y(), 0.6 * p.x() + 0.8 * p.y());
                picture.emplace_back(turned.x(), sine * turned.y());
            }
            const auto factor = foreshortening(picture, Vec2(0, 1), 2.0);
            ASSERT_TRUE(factor) << deg << ", " << base.size();
            EXPECT_NEAR(*factor, 1.0 / sine, 1e-6) << deg << ", " << base.size();
        }
    }
}

TEST(BaseTilt, ATriangleOfOneLineTellsNothingAbsurd) {
    const auto factor = foreshortening({{0, 0}, {50, 0}, {100, 0}}, Vec2(0, 1), 2.0);
    if (factor) {
        EXPECT_GT(*factor, 1.0);
        EXPECT_LT(*factor, 7.2);
    }
}

}  // namespace
}  // namespace ew::test
