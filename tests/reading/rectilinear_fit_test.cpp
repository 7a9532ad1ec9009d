// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/rectilinear_fit.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "tests/support/random.h"

namespace ew {
namespace {

Mat3 randomRotation(test::Random& random) {
    Eigen::Quaterniond q(random.normal(), random.normal(), random.normal(), random.normal());
    return q.normalized().toRotationMatrix();
}

RC_GTEST_PROP(CornerDepths, EveryPerpendicularCornerIsRecoveredUpToItsMirrorImage, ()) {
    test::Random random(*rc::gen::inRange<std::uint64_t>(0, 1u << 20));
    const Mat3 r = randomRotation(random);
    std::array<Vec2, 3> picture;
    std::array<double, 3> depth{};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 axis = random.uniform(20, 200) * r.col(static_cast<Eigen::Index>(i));
        picture[i] = axis.head<2>();
        depth[i] = axis.z();
    }
    // Corners nearly seen along a face are left out: there the depth is nearly undetermined.
    for (std::size_t i = 0; i < 3; ++i) RC_PRE(std::abs(r(2, static_cast<Eigen::Index>(i))) > 0.05);
    const auto t = cornerDepths(picture);
    RC_ASSERT(t.has_value());
    const double sign = (*t)[0] * depth[0] > 0 ? 1.0 : -1.0;
    for (std::size_t i = 0; i < 3; ++i) {
        RC_ASSERT(std::abs(sign * (*t)[i] - depth[i]) < 1e-6 * (1 + std::abs(depth[i])));
    }
}

TEST(CornerDepths, PerkinsLaw) {
    auto spokes = [](double a, double b, double c) {
        auto at = [](double deg) {
            return Vec2(
                Vec2(std::cos(deg * 0.017453292519943295), std::sin(deg * 0.017453292519943295)) *
                100);
        };
        return std::array<Vec2, 3>{at(a), at(b), at(c)};
    };
    EXPECT_TRUE(cornerDepths(spokes(0, 120, 240)));
    EXPECT_TRUE(cornerDepths(spokes(0, 95, 200)));   // Y, all over 90
    EXPECT_FALSE(cornerDepths(spokes(0, 80, 210)));  // Y with 80 degrees
    EXPECT_TRUE(cornerDepths(spokes(0, 50, 100)));   // arrow, sum over 90
    EXPECT_FALSE(cornerDepths(spokes(0, 40, 80)));   // arrow, sum under 90
    EXPECT_FALSE(cornerDepths(spokes(0, 90, 225)));  // exactly square front
}

TEST(CornerDepths, TheIsometricCubeHasEqualEdges) {
    std::array<Vec2, 3> q;
    for (std::size_t i = 0; i < 3; ++i) {
        const double a = 2.0943951023931953 * static_cast<double>(i) + 0.4;
        q[i] = 100 * Vec2(std::cos(a), std::sin(a));
    }
    const auto t = cornerDepths(q);
    ASSERT_TRUE(t);
    for (const double d : *t) EXPECT_NEAR(std::abs(d), 100 / std::sqrt(2.0), 1e-9);
}

TEST(SnapToSolvable, TurnsTheShorterAxisMoreAndGivesASolution) {
    AffinePicture p;
    p.axes = {Vec2(100, 0), Vec2(10, 40), Vec2(-70, -60)};
    ASSERT_FALSE(cornerDepths(p.axes));
    double moved = 0;
    const AffinePicture s = snapToSolvable(p, 4.0, moved);
    EXPECT_TRUE(cornerDepths(s.axes));
    EXPECT_GT(moved, 0);
    EXPECT_LT(moved, 20);
    EXPECT_LT((s.axes[0] - p.axes[0]).norm() / 100,
              (s.axes[1] - p.axes[1]).norm() / p.axes[1].norm());
}

}  // namespace
}  // namespace ew
