// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/pull.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/solid/boolean.h"
#include "core/solid/transform.h"
#include "tests/solid/shapes.h"
#include "tests/support/random_modifications.h"

namespace ew::test {
namespace {

Solid solidOf(const PolyhedronSpec& spec) {
    auto made = Solid::fromSpec(spec);
    EXPECT_TRUE(made) << made.error().message;
    return *std::move(made);
}

/// The face that looks in a direction, the outermost of them.
int faceTowards(const Solid& solid, const Vec3& direction) {
    int best = -1;
    for (std::size_t f = 0; f < solid.faces().size(); ++f) {
        const SolidFace& face = solid.faces()[f];
        if (face.normal.dot(direction) < 0.999) continue;
        if (best < 0 || face.offset > solid.faces()[static_cast<std::size_t>(best)].offset) {
            best = static_cast<int>(f);
        }
    }
    EXPECT_GE(best, 0);
    return best;
}

/// The face at this height that looks up.
int floorAt(const Solid& solid, double z) {
    for (std::size_t f = 0; f < solid.faces().size(); ++f) {
        const SolidFace& face = solid.faces()[f];
        if (face.normal.z() > 0.999 && std::abs(face.offset - z) < 1e-9) return static_cast<int>(f);
    }
    ADD_FAILURE() << "no floor at " << z;
    return 0;
}

Solid pulled(const Solid& solid, int face, double by, PullWalls walls = PullWalls::Follow) {
    auto made = pullFace(solid, face, by, walls);
    EXPECT_TRUE(made) << made.error().message;
    return made ? made->solid : solid;
}

/// A block of 40 x 40 x 20 with a pocket of 20 x 20 x 8, or a boss as high.
Solid blockWith(BooleanKind kind) {
    const Solid block = solidOf(box({0, 0, 0}, {40, 40, 20}));
    const double low = kind == BooleanKind::Cut ? 12 : 20;
    const auto made = combine(block, solidOf(box({10, 10, low}, {30, 30, low + 8})), kind);
    EXPECT_TRUE(made);
    return made->solid;
}

TEST(PullFace, EveryFaceOfABoxMovesByTheDistance) {
    const Solid solid = solidOf(box({1, 2, 3}, {11, 22, 33}));
    for (int face = 0; face < 6; ++face) {
        for (const double by : {-9.5, -1.25, 0.003, 7.0, 1e4}) {
            const Solid after = pulled(solid, face, by);
            const auto& normal = solid.faces()[static_cast<std::size_t>(face)].normal;
            const double area = std::abs(normal.dot(Vec3(20 * 30, 10 * 30, 10 * 20)));
            EXPECT_NEAR(after.volume(), 6000 + area * by, 1e-9 * after.volume());
            EXPECT_EQ(after.faces().size(), 6U);
            EXPECT_EQ(after.vertices().size(), 8U);
        }
    }
}

TEST(PullFace, OutAndBackIsTheVerySolid) {
    Random random(3);
    int slid = 0;
    for (int i = 0; i < 60; ++i) {
        const Solid solid = randomModifiedSolid(4, random);
        const int face =
            static_cast<int>(random.uniform(0, 0.999) * static_cast<double>(solid.faces().size()));
        const double by = random.uniform(-6, 6);
        const auto out = pullFace(solid, face, by, PullWalls::Follow);
        if (!out || !out->slid) continue;
        ++slid;
        const auto back = pullFace(out->solid, face, -by, PullWalls::Follow);
        ASSERT_TRUE(back) << back.error().message;
        EXPECT_TRUE(back->solid.identicalTo(solid)) << i;
    }
    EXPECT_GT(slid, 20);
}

TEST(PullFace, WhatComesOfItIsASolid) {
    Random random(5);
    int done = 0;
    for (int i = 0; i < 60; ++i) {
        const Solid solid = randomModifiedSolid(5, random);
        const int face =
            static_cast<int>(random.uniform(0, 0.999) * static_cast<double>(solid.faces().size()));
        const double by = random.uniform(-25, 25);
        const auto walls = i % 2 == 0 ? PullWalls::Follow : PullWalls::Straight;
        const auto after = pullFace(solid, face, by, walls);
        if (!after) continue;
        ++done;
        const auto again = Solid::deserialize(after->solid.serialize());
        ASSERT_TRUE(again) << again.error().message;
        EXPECT_EQ(after->solid.volume() > solid.volume(), by > 0.0);
    }
    EXPECT_GT(done, 40);
}

TEST(PullFace, APocketGoesThroughTheBottom) {
    const Solid solid = blockWith(BooleanKind::Cut);
    EXPECT_EQ(solid.genus(), 0);
    for (const double by : {-12.0, -12.5, -50.0}) {
        const Solid through = pulled(solid, floorAt(solid, 12), by);
        EXPECT_EQ(through.genus(), 1) << by;
        EXPECT_NEAR(through.volume(), 40 * 40 * 20 - 20 * 20 * 20, 1e-9 * solid.volume());
    }
    EXPECT_NEAR(pulled(solid, floorAt(solid, 12), -5).volume(), solid.volume() - 5 * 400, 1e-9);
    // Up again: level with the top it is gone, and higher it is a boss.
    EXPECT_EQ(pulled(solid, floorAt(solid, 12), 8).faces().size(), 6U);
    EXPECT_NEAR(pulled(solid, floorAt(solid, 12), 11).volume(), 40 * 40 * 20 + 3 * 400, 1e-6);
}

TEST(PullFace, ABossIsPushedInAndBecomesAPocket) {
    const Solid solid = blockWith(BooleanKind::Add);
    const int top = floorAt(solid, 28);
    EXPECT_EQ(pulled(solid, top, -8).faces().size(), 6U);
    const Solid pocket = pulled(solid, top, -10);
    EXPECT_NEAR(pocket.volume(), 40 * 40 * 20 - 2 * 400, 1e-6);
    EXPECT_EQ(pocket.faces().size(), 11U);
    EXPECT_EQ(pulled(solid, top, -28).genus(), 1);
}

TEST(PullFace, WallsThatSlantGoOnOrStayStraight) {
    // 4 sides on a circle of radius 1, half as wide at height 1.
    const Solid solid = solidOf(frustum(4, 0.5));
    const int top = faceTowards(solid, Vec3::UnitZ());
    const double height = solid.faces()[static_cast<std::size_t>(top)].offset;
    const auto frustumVolume = [](double h, double below, double above) {
        return h / 3 * (below + above + std::sqrt(below * above));
    };
    EXPECT_NEAR(solid.volume(), frustumVolume(height, 2, 0.5), 1e-9);
    // The side of the top shrinks by as much as it did on the way up.
    const double up = 0.4 * height;
    const double side = std::sqrt(2.0) * (1 - 0.5 * 1.4);
    EXPECT_NEAR(pulled(solid, top, up).volume(), frustumVolume(1.4 * height, 2, side * side), 1e-9);
    const Solid tower = pulled(solid, top, up, PullWalls::Straight);
    EXPECT_NEAR(tower.volume(), solid.volume() + up * 0.5, 1e-9);
    EXPECT_EQ(tower.faces().size(), 10U);
    // Inwards it grows.
    const double wider = std::sqrt(2.0) * (1 - 0.5 * 0.8);
    EXPECT_NEAR(pulled(solid, top, -0.2 * height).volume(),
                frustumVolume(0.8 * height, 2, wider * wider), 1e-9);
}

TEST(PullFace, AFaceThatWouldShrinkToNothingSaysWhen) {
    const Solid solid = solidOf(frustum(4, 0.5));
    const int top = faceTowards(solid, Vec3::UnitZ());
    const double height = solid.faces()[static_cast<std::size_t>(top)].offset;
    for (const double by : {height, 3 * height}) {
        const auto after = pullFace(solid, top, by, PullWalls::Follow);
        ASSERT_FALSE(after);
        EXPECT_EQ(after.error().code, Errc::OperationImpossible);
        char text[32];
        std::snprintf(text, sizeof(text), "%.3g mm", height);
        EXPECT_NE(after.error().message.find(text), std::string::npos) << after.error().message;
    }
    EXPECT_TRUE(pullFace(solid, top, 0.99 * height, PullWalls::Follow));
}

TEST(PullFace, AFaceWithAHoleKeepsIt) {
    const Solid ring =
        pulled(blockWith(BooleanKind::Cut), floorAt(blockWith(BooleanKind::Cut), 12), -30);
    const int top = faceTowards(ring, Vec3::UnitZ());
    EXPECT_EQ(ring.faces()[static_cast<std::size_t>(top)].loops.size(), 2U);
    const Solid higher = pulled(ring, top, 4);
    EXPECT_EQ(higher.genus(), 1);
    EXPECT_NEAR(higher.volume(), 24 * (1600 - 400), 1e-6);
}

TEST(PullFace, CornersOfFourFacesAreNoObstacle) {
    // The sides of a pyramid meet in one point.
    const Solid solid = solidOf(pyramid(4));
    for (std::size_t f = 0; f < solid.faces().size(); ++f) {
        if (std::abs(solid.faces()[f].normal.z()) > 0.9) continue;
        const auto out = pullFace(solid, static_cast<int>(f), 0.1, PullWalls::Follow);
        ASSERT_TRUE(out) << out.error().message;
        EXPECT_GT(out->solid.volume(), solid.volume());
        const auto in = pullFace(solid, static_cast<int>(f), -0.1, PullWalls::Follow);
        ASSERT_TRUE(in) << in.error().message;
        EXPECT_LT(in->solid.volume(), solid.volume());
    }
}

TEST(PullFace, BadValuesAreRefused) {
    const Solid solid = solidOf(box({0, 0, 0}, {10, 10, 10}));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    struct Case {
        int face;
        double by;
        Errc code;
    };
    for (const Case& c :
         {Case{0, nan, Errc::BadValue}, Case{0, 1e9, Errc::BadValue}, Case{0, 0.0, Errc::NoChange},
          Case{6, 1.0, Errc::BadValue}, Case{-1, 1.0, Errc::BadValue},
          Case{0, -10.0, Errc::NothingLeft}, Case{0, -11.0, Errc::NothingLeft}}) {
        const auto after = pullFace(solid, c.face, c.by, PullWalls::Follow);
        ASSERT_FALSE(after) << c.face << " " << c.by;
        EXPECT_EQ(after.error().code, c.code) << after.error().message;
    }
}

TEST(Transformed, AMirrorImageOfAMirrorImageIsTheSolid) {
    Random random(7);
    const Mat3 flip = Vec3(-1, 1, 1).asDiagonal();
    for (int i = 0; i < 10; ++i) {
        const Solid solid = randomModifiedSolid(4, random);
        const auto once = transformed(solid, flip, Vec3::Zero());
        ASSERT_TRUE(once) << once.error().message;
        EXPECT_NEAR(once->volume(), solid.volume(), 1e-9 * solid.volume());
        EXPECT_FALSE(once->identicalTo(solid));
        const auto twice = transformed(*once, flip, Vec3::Zero());
        ASSERT_TRUE(twice);
        EXPECT_TRUE(twice->identicalTo(solid));
    }
}

TEST(Transformed, ScalesAndShearsExactly) {
    const Solid solid = solidOf(lPrism());
    Mat3 shear = Mat3::Identity();
    shear(0, 2) = 0.7;
    shear(1, 1) = 3.0;
    const auto after = transformed(solid, shear, Vec3(5, 6, 7));
    ASSERT_TRUE(after) << after.error().message;
    EXPECT_NEAR(after->volume(), 3 * solid.volume(), 1e-12);
    EXPECT_EQ(after->faces().size(), solid.faces().size());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(transformed(solid, Mat3::Zero(), Vec3::Zero()).error().code, Errc::BadValue);
    EXPECT_EQ(transformed(solid, nan * shear, Vec3::Zero()).error().code, Errc::BadValue);
    EXPECT_FALSE(transformed(solid, 1e9 * Mat3::Identity(), Vec3::Zero()));
}

}  // namespace
}  // namespace ew::test
