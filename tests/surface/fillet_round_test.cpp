// SPDX-License-Identifier: GPL-3.0-or-later
// Corners where two strips go round the end of a third one.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "core/surface/fillet.h"
#include "tests/surface/shapes.h"

namespace ew::test {
namespace {

/// Points of the corner faces of a vertex of the solid.
std::vector<Vec3> cornerPoints(const FilletedCage& cage, int vertex) {
    std::vector<Vec3> out;
    for (int f = 0; f < cage.mesh.faceCount(); ++f) {
        if (cage.origins[static_cast<std::size_t>(f)] !=
            CageOrigin{CageOrigin::Kind::Corner, vertex}) {
            continue;
        }
        for (const int i : cage.mesh.outline(f)) out.push_back(cage.mesh.point(i));
    }
    return out;
}

int vertexAt(const Solid& solid, const Vec3& p) {
    for (std::size_t v = 0; v < solid.vertices().size(); ++v) {
        if ((solid.vertices()[v] - p).norm() < 1e-9) return static_cast<int>(v);
    }
    ADD_FAILURE() << "no such vertex";
    return -1;
}

/// A setback for each edge by the axis that it is parallel to.
FilletOptions byAxis(const Solid& solid, const Vec3& setbacks, int segments) {
    FilletOptions options{{}, segments};
    for (std::size_t e = 0; e < solid.edges().size(); ++e) {
        const auto& ends = solid.edges()[e].ends;
        const Vec3 d = solid.vertices()[static_cast<std::size_t>(ends[1])] -
                       solid.vertices()[static_cast<std::size_t>(ends[0])];
        options.edges.push_back({static_cast<int>(e), setbacks.dot(d.normalized().cwiseAbs())});
    }
    return options;
}

/// A fillet that fits.
FilletedCage fitting(const Solid& solid, const FilletOptions& options) {
    auto cage = fillet(solid, options);
    EXPECT_TRUE(cage);
    EXPECT_TRUE(cage->clamped.empty());
    EXPECT_EQ(faultsByExactArithmetic(*cage), "");
    return *std::move(cage);
}

/// Distance of a point from the middle circle of a torus around a vertical axis.
double fromCircle(const Vec3& p, const Vec3& center, double radius) {
    const Vec3 d = p - center;
    return std::hypot(std::hypot(d.x(), d.y()) - radius, d.z());
}

TEST(FilletRound, TheEndOfANotchIsPartOfATorus) {
    // Two convex strips at the front face y = 0 go round the rounded notch along y.
    const Solid solid = solidOf(lPrismSpec());
    const double s = 0.2;
    const double notch = 0.3;
    const FilletedCage cage = fitting(solid, byAxis(solid, {s, notch, s}, 8));
    const auto points = cornerPoints(cage, vertexAt(solid, {1, 0, 1}));
    ASSERT_EQ(points.size(), 4U * 8U * 8U);
    const Vec3 center(1 + notch, 1 + notch, s);  // x, z, and y as the height
    for (const Vec3& p : points) {
        EXPECT_NEAR(fromCircle({p.x(), p.z(), p.y()}, center, notch + s), s, 1e-9);
    }
}

TEST(FilletRound, TheFootOfABossIsPartOfATorus) {
    const Solid solid = solidOf(bossesSpec(1));
    const auto box = solid.bounds();
    const double s = 0.05 * (box[1] - box[0]).minCoeff();
    const double upright = 1.5 * s;
    const FilletedCage cage = fitting(solid, byAxis(solid, {s, s, upright}, 6));
    int feet = 0;
    for (std::size_t v = 0; v < solid.vertices().size(); ++v) {
        const auto concave =
            std::count_if(solid.edges().begin(), solid.edges().end(), [&](const SolidEdge& e) {
                return !e.convex &&
                       (e.ends[0] == static_cast<int>(v) || e.ends[1] == static_cast<int>(v));
            });
        if (concave == 0) continue;
        ++feet;
        const Vec3& foot = solid.vertices()[v];
        Vec3 middle = 0.5 * (box[0] + box[1]);
        Vec3 axis = foot;
        axis.x() += upright * (middle.x() > foot.x() ? 1.0 : -1.0);
        axis.y() += upright * (middle.y() > foot.y() ? 1.0 : -1.0);
        axis.z() += s;
        for (const Vec3& p : cornerPoints(cage, static_cast<int>(v))) {
            EXPECT_NEAR(fromCircle(p, axis, upright + s), s, 1e-9);
        }
    }
    EXPECT_EQ(feet, 4);
}

TEST(FilletRound, ABoxWithRounderUprightsIsTheRollingBalls) {
    const Vec3 size(4, 3, 2);
    const Solid box = solidOf(boxSpec({0, 0, 0}, size));
    const double s = 0.2;
    const double upright = 0.7;
    const FilletedCage cage = fitting(box, byAxis(box, {s, s, upright}, 16));
    for (const double x : {0.0, size.x()}) {
        for (const double z : {0.0, size.z()}) {
            const Vec3 center(x > 0 ? x - upright : upright, upright, z > 0 ? z - s : s);
            for (const Vec3& p : cornerPoints(cage, vertexAt(box, {x, 0, z}))) {
                EXPECT_NEAR(fromCircle(p, center, upright - s), s, 1e-9);
            }
        }
    }
    // The area of an outline at a distance inwards, integrated over the height.
    const double pi = std::numbers::pi;
    const double outline = 2 * (size.x() + size.y()) - (8 - 2 * pi) * upright;
    const double area = size.x() * size.y() - (4 - pi) * upright * upright;
    // At height h within a rounded rim the outline lies s - sqrt(s^2 - (s - h)^2) further in.
    const double inwards = s * s * (1 - pi / 4);
    const double squares = s * s * s * (2 - pi / 2 - 1.0 / 3.0);
    const double exact = area * size.z() - 2 * outline * inwards + 2 * pi * squares;
    EXPECT_NEAR(volumeOf(cage) / exact, 1.0, 1e-3);
}

RC_GTEST_PROP(FilletRound, AnyThreeSetbacksOfABoxFit, ()) {
    const auto setback = [] { return *rc::gen::inRange(1, 100) * 0.0049; };
    const Vec3 setbacks(setback(), setback(), setback());
    const int segments = *rc::gen::inRange(2, 9);
    const Solid box = solidOf(boxSpec({0, 0, 0}, {1, 1, 1}));
    const auto cage = fillet(box, byAxis(box, setbacks, segments));
    RC_ASSERT(static_cast<bool>(cage));
    RC_ASSERT(cage->clamped.empty());
    RC_ASSERT(faultsByExactArithmetic(*cage).empty());
    // Seen in any mirror it is the same: no corner falls back where another one does not.
    RC_ASSERT(std::abs(volumeOf(*cage) -
                       volumeOf(*fillet(box, byAxis(box, {setbacks.y(), setbacks.x(), setbacks.z()},
                                                    segments)))) < 1e-12);
}

TEST(FilletRound, ThirdSetbacksThatAreClampedBelowTheOthersMakeNoFault) {
    // The uprights ask for more than the others and get less, because the box is thin.
    const Solid plate = solidOf(boxSpec({0, 0, 0}, {0.3, 3, 2}));
    for (const double upright : {0.1, 0.14, 0.16, 0.5, 5.0}) {
        const auto cage = fillet(plate, byAxis(plate, {0.12, 0.12, upright}, 5));
        ASSERT_TRUE(cage);
        EXPECT_EQ(faultsByExactArithmetic(*cage), "") << upright;
        for (const FilletClamp& clamp : cage->clamped) EXPECT_GT(clamp.used, 0.0);
    }
}

}  // namespace
}  // namespace ew::test
