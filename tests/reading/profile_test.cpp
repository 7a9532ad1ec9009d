// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/reading/interpret.h"
#include "core/solid/pull.h"
#include "tests/support/random.h"
#include "tests/support/random_shapes.h"

namespace ew::test {
namespace {

/// A box of 60 x 40 x 30 mm with a corner at the origin. The start camera sees the faces x = 60,
/// y = 0 and z = 30.
class Profiles : public testing::Test {
  protected:
    Profiles() { options_.bodies = {{*Solid::fromSpec(boxSpec(60, 40, 30)), Pose{}}}; }

    Stroke stroke(const std::vector<Vec3>& through, double shakePx = 0.0, int steps = 30) {
        Stroke s;
        for (std::size_t i = 0; i + 1 < through.size(); ++i) {
            const Vec2 from = options_.camera.project(through[i]);
            const Vec2 to = options_.camera.project(through[i + 1]);
            for (int k = i == 0 ? 0 : 1; k <= steps; ++k) {
                const Vec2 shake(random_.normal() * shakePx, random_.normal() * shakePx);
                s.samples.push_back({from + (to - from) * k / steps + shake, 1.0, 0.0});
            }
        }
        return s;
    }
    Stroke circle(const Vec3& center, const Vec3& u, const Vec3& v, double radius,
                  double shakePx = 0.0) {
        std::vector<Vec3> through;
        for (int k = 0; k <= 72; ++k) {
            const double a = 2 * std::numbers::pi * k / 72;
            through.push_back(center + radius * (std::cos(a) * u + std::sin(a) * v));
        }
        return stroke(through, shakePx, 1);
    }
    Result<Profile> at(const std::vector<Stroke>& strokes, const Vec3& inside) {
        return readProfile(strokes, options_, options_.camera.project(inside));
    }
    double pulled(const Profile& profile, double by) {
        const Solid& solid = options_.bodies.front().solid;
        const auto made = pullProfile(solid, profile.face, profile.corners, by);
        EXPECT_TRUE(made) << made.error().message;
        return made ? made->solid.volume() - solid.volume() : 0.0;
    }
    InterpretOptions options_;
    Random random_{9};
};

TEST_F(Profiles, ARectangleTakesTheDirectionsOfTheFace) {
    for (const double shake : {0.0, 0.5, 1.0}) {
        const auto profile = at(
            {stroke({{10, 10, 30}, {40, 10, 30}, {40, 30, 30}, {10, 30, 30}, {10, 10, 30}}, shake)},
            {20, 20, 30});
        ASSERT_TRUE(profile) << profile.error().message;
        ASSERT_EQ(profile->corners.size(), 4U);
        EXPECT_FALSE(profile->round);
        const double near = shake == 0.0 ? 1e-6 : 25.0;
        EXPECT_NEAR(pulled(*profile, 5), 5 * 30 * 20, 5 * near);
        EXPECT_NEAR(pulled(*profile, -40), -30 * 30 * 20, 30 * near);
        for (std::size_t k = 0; k < 4; ++k) {
            const Vec3 d = profile->corners[(k + 1) % 4] - profile->corners[k];
            EXPECT_LT(std::min(std::abs(d.x()), std::abs(d.y())), 1e-9);
        }
    }
}

TEST_F(Profiles, OutlinesOfSeveralStrokesAndOfManyCorners) {
    // An L on the side y = 0.
    const std::vector<Vec3> l{{10, 0, 5},  {40, 0, 5},  {40, 0, 12},
                              {20, 0, 12}, {20, 0, 25}, {10, 0, 25}};
    std::vector<Stroke> strokes;
    for (std::size_t k = 0; k < l.size(); ++k) {
        strokes.push_back(stroke({l[k], l[(k + 1) % l.size()]}, 0.3));
    }
    const auto profile = at(strokes, {15, 0, 10});
    ASSERT_TRUE(profile) << profile.error().message;
    EXPECT_EQ(profile->corners.size(), 6U);
    EXPECT_EQ(profile->strokes.size(), 6U);
    const double area = 30 * 7 + 10 * 13;
    EXPECT_NEAR(pulled(*profile, 10), 10 * area, 0.05 * 10 * area);
    EXPECT_EQ(at(strokes, {50, 0, 20}).error().code, Errc::NoRegion);
}

TEST_F(Profiles, WhatRunsAlongAnEdgeOfTheFaceLiesOnIt) {
    const auto profile =
        at({stroke({{1, 1, 30}, {30, 1, 30}, {30, 39, 30}, {1, 39, 30}, {1, 1, 30}}, 0.3)},
           {10, 20, 30});
    ASSERT_TRUE(profile);
    const Solid& solid = options_.bodies.front().solid;
    const auto step = pullProfile(solid, profile->face, profile->corners, -10);
    ASSERT_TRUE(step);
    // An L-prism: no thin walls are left standing.
    EXPECT_EQ(step->solid.faces().size(), 8U);
    EXPECT_EQ(step->solid.vertices().size(), 12U);
}

TEST_F(Profiles, ACircleIsRoundOnItsFace) {
    struct Case {
        Vec3 center, u, v;
    };
    for (const Case& c :
         {Case{{30, 20, 30}, {1, 0, 0}, {0, 1, 0}}, Case{{60, 20, 15}, {0, 1, 0}, {0, 0, 1}},
          Case{{30, 0, 15}, {1, 0, 0}, {0, 0, 1}}}) {
        for (const double shake : {0.0, 0.6}) {
            const auto profile = at({circle(c.center, c.u, c.v, 9, shake)}, c.center);
            ASSERT_TRUE(profile) << profile.error().message;
            EXPECT_TRUE(profile->round);
            ASSERT_EQ(profile->corners.size(), static_cast<std::size_t>(kRoundSides));
            for (const Vec3& p : profile->corners) EXPECT_NEAR((p - c.center).norm(), 9, 0.2);
            const double area = 81 * std::numbers::pi;
            EXPECT_NEAR(pulled(*profile, 4), 4 * area, 0.06 * 4 * area);
        }
    }
    // Through to the other side.
    const auto profile = at({circle({30, 20, 30}, {1, 0, 0}, {0, 1, 0}, 9)}, {30, 20, 30});
    const auto hole =
        pullProfile(options_.bodies.front().solid, profile->face, profile->corners, -30);
    ASSERT_TRUE(hole) << hole.error().message;
    EXPECT_EQ(hole->solid.genus(), 1);
}

TEST_F(Profiles, WhatIsNoneSaysWhy) {
    const auto open = at({stroke({{10, 10, 30}, {40, 10, 30}, {40, 30, 30}})}, {30, 15, 30});
    EXPECT_EQ(open.error().code, Errc::NoRegion);
    EXPECT_EQ(
        readProfile({stroke({{10, 10, 30}, {40, 10, 30}})}, options_, Vec2(5, 5)).error().code,
        Errc::NoSurface);
    const auto over =
        at({stroke({{30, -40, 30}, {90, -40, 30}, {90, 30, 30}, {30, 30, 30}, {30, -40, 30}})},
           {40, 20, 30});
    EXPECT_EQ(over.error().code, Errc::OperationImpossible);
    EXPECT_EQ(over.error().where.size(), 1U);
    std::vector<Vec3> egg;
    for (int k = 0; k <= 72; ++k) {
        const double a = 2 * std::numbers::pi * k / 72;
        egg.emplace_back(30 + 25 * std::cos(a), 20 + 7 * std::sin(a), 30);
    }
    EXPECT_EQ(at({stroke(egg, 0.0, 1)}, {30, 20, 30}).error().code, Errc::CurvedStroke);
}

TEST_F(Profiles, ByItselfAnOutlineSaysThatItLacksADepth) {
    const auto library = loadLibrary(EDGEWRIGHT_SOURCE_DIR "/resources/templates");
    const auto reading = interpret(
        {stroke({{10, 10, 30}, {40, 10, 30}, {40, 30, 30}, {10, 30, 30}, {10, 10, 30}}, 0.3)},
        library->library, options_);
    EXPECT_FALSE(reading.accepted);
    ASSERT_TRUE(reading.problem);
    EXPECT_EQ(reading.problem->code, Errc::FlatDrawing) << reading.problem->message;
    EXPECT_NE(reading.problem->message.find("not how deep"), std::string::npos);
}

}  // namespace
}  // namespace ew::test
