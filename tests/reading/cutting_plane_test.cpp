// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/cutting_plane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/reading/interpret.h"
#include "tests/support/random.h"
#include "tests/support/random_shapes.h"

namespace ew::test {
namespace {

/// A box of 60 x 40 x 30 mm with a corner at the origin, seen through the start camera.
class CuttingPlane : public testing::Test {
  protected:
    CuttingPlane() {
        options_.bodies = {{*Solid::fromSpec(boxSpec(60, 40, 30)), Pose{}}};
        options_.operation = Operation::Split;
    }
    /// A stroke through points of the world, with a hand that shakes by so much [px].
    Stroke stroke(const std::vector<Vec3>& through, double shakePx = 0.0) {
        Stroke s;
        for (std::size_t i = 0; i + 1 < through.size(); ++i) {
            const Vec2 from = options_.camera.project(through[i]);
            const Vec2 to = options_.camera.project(through[i + 1]);
            constexpr int kSteps = 30;
            for (int k = 0; k <= kSteps; ++k) {
                const Vec2 shake(random_.normal() * shakePx, random_.normal() * shakePx);
                s.samples.push_back({from + (to - from) * k / kSteps + shake, 1.0, 0.0});
            }
        }
        return s;
    }
    /// Shares of the two parts of the first reading.
    std::array<double, 2> parts(const Interpretation& reading) {
        if (reading.candidates.empty()) {
            ADD_FAILURE() << reading.problem->message;
            return {};
        }
        const Candidate& c = reading.candidates.front();
        const double whole = options_.bodies.front().solid.volume();
        EXPECT_NEAR(c.result->volume() + c.rest->volume(), whole, 1e-6 * whole);
        return {c.result->volume() / whole, c.rest->volume() / whole};
    }
    InterpretOptions options_;
    Random random_{4};
};

// The start camera looks along (-1, 1, -1): the faces x = 60, y = 0 and z = 30 are seen.

TEST_F(CuttingPlane, ALineOverTwoFacesTellsThePlane) {
    // Across the top and down the side, in the plane x = 20.
    for (const double shake : {0.0, 0.6, 1.2}) {
        const auto reading =
            readCuttingPlane({stroke({{20, 40, 30}, {20, 0, 30}, {20, 0, 0}}, shake)}, options_);
        EXPECT_NEAR(parts(reading)[1], 1.0 / 3, shake == 0.0 ? 1e-9 : 0.01);
        EXPECT_EQ(reading.candidates.front().result->faces().size(), 6U);
        EXPECT_EQ(reading.candidates.front().operation, Operation::Split);
    }
}

TEST_F(CuttingPlane, SeveralStrokesAreOneLine) {
    const auto reading = readCuttingPlane(
        {stroke({{20, 0, 30}, {20, 0, 0}}), stroke({{20, 0, 30}, {20, 40, 30}})}, options_);
    EXPECT_NEAR(parts(reading)[1], 1.0 / 3, 1e-9);
}

TEST_F(CuttingPlane, ALineOverOneFaceCutsSquareToIt) {
    const auto reading = readCuttingPlane({stroke({{60, 0, 30}, {0, 40, 30}})}, options_);
    EXPECT_NEAR(parts(reading)[1], 0.5, 0.01);
    const auto across = readCuttingPlane({stroke({{15, 0, 30}, {15, 40, 30}}, 0.5)}, options_);
    EXPECT_NEAR(parts(across)[1], 0.25, 0.01);
}

TEST_F(CuttingPlane, AnObliquePlaneIsWhatWasDrawn) {
    // Through (50, 0, 30), (60, 10, 30) and (60, 0, 15): a corner comes off.
    const auto reading =
        readCuttingPlane({stroke({{50, 0, 30}, {60, 10, 30}, {60, 0, 15}, {50, 0, 30}})}, options_);
    const double corner = 10.0 * 10.0 * 15.0 / 6.0 / (60.0 * 40.0 * 30.0);
    EXPECT_NEAR(parts(reading)[1], corner, 0.02 * corner);
}

TEST_F(CuttingPlane, EndsAreGivenSomeRoom) {
    // Past the outline, and short of it.
    const auto reading =
        readCuttingPlane({stroke({{20, 43, 30}, {20, 0, 30}, {20, 0, 2}}, 0.5)}, options_);
    EXPECT_NEAR(parts(reading)[1], 1.0 / 3, 0.01);
}

TEST_F(CuttingPlane, WhatCutsNothingSaysWhy) {
    struct Case {
        std::vector<Vec3> line;
        Errc code;
    };
    for (const Case& c : {Case{{{20, 40, 30}, {20, 20, 30}}, Errc::OpenEnd},
                          Case{{{200, 40, 30}, {200, 0, 30}}, Errc::NoSurface},
                          Case{{{10, 0, 0}, {10, 0, 30}, {40, 40, 30}, {60, 40, 30}, {60, 40, 0}},
                               Errc::CurvedStroke}}) {
        const auto reading = readCuttingPlane({stroke(c.line)}, options_);
        ASSERT_TRUE(reading.problem);
        EXPECT_EQ(reading.problem->code, c.code) << reading.problem->message;
        EXPECT_FALSE(reading.problem->where.empty());
        EXPECT_TRUE(reading.candidates.empty());
    }
    // Along an edge nothing comes off.
    const auto along = readCuttingPlane({stroke({{60, 0, 0}, {60, 0, 30}})}, options_);
    EXPECT_TRUE(along.problem);
}

TEST_F(CuttingPlane, ByItselfItIsOnlyOffered) {
    options_.operation = Operation::Auto;
    const auto library = loadLibrary(EDGEWRIGHT_SOURCE_DIR "/resources/templates");
    const auto reading = interpret({stroke({{20, 40, 30}, {20, 0, 30}, {20, 0, 0}}, 0.4)},
                                   library->library, options_);
    EXPECT_FALSE(reading.accepted);
    EXPECT_TRUE(std::any_of(reading.candidates.begin(), reading.candidates.end(),
                            [](const Candidate& c) { return c.operation == Operation::Split; }));
}

}  // namespace
}  // namespace ew::test
