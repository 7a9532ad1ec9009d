// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/chord_flips.h"

#include <gtest/gtest.h>

namespace ew::test {
namespace {

/// The tip of the first triangle is on the wrong side of the chord that it shares with the second.
SurfaceMesh crossingChord() {
    SurfaceMesh mesh;
    mesh.positions = {{0, 0, 0}, {4, 0, 0}, {2, -0.1, 0}, {2, -2, 0}};
    mesh.normals.assign(4, Eigen::Vector3f::UnitZ());
    mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
    mesh.origin = {0, 1};
    return mesh;
}

double area(const SurfaceMesh& mesh, std::size_t t) {
    const auto at = [&](std::size_t k) -> const Vec3& {
        return mesh.positions[static_cast<std::size_t>(mesh.triangles[t][k])];
    };
    return 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).z();
}

TEST(ChordFlips, ATriangleThatRunsBackwardsIsTurnedRound) {
    SurfaceMesh mesh = crossingChord();
    ASSERT_LT(area(mesh, 0), 0.0);
    const double sum = area(mesh, 0) + area(mesh, 1);
    flipBadTriangles(mesh);
    ASSERT_EQ(mesh.triangles.size(), 2U);
    EXPECT_GT(area(mesh, 0), 0.0);
    EXPECT_GT(area(mesh, 1), 0.0);
    EXPECT_NEAR(area(mesh, 0) + area(mesh, 1), sum, 1e-12);
}

TEST(ChordFlips, CreasesAndGoodTrianglesStay) {
    SurfaceMesh crease = crossingChord();
    using Normal = Eigen::Vector3f;
    crease.normals = {Normal::UnitZ(), Normal::UnitZ(), Normal::UnitZ(), Normal::UnitX()};
    crease.normalTriangles = {{0, 1, 2}, {3, 3, 3}};
    const auto before = crease.triangles;
    flipBadTriangles(crease);
    EXPECT_EQ(crease.triangles, before);
    SurfaceMesh good = crossingChord();
    good.positions[2].y() = 0.1;
    flipBadTriangles(good);
    EXPECT_EQ(good.triangles, before);
}

}  // namespace
}  // namespace ew::test
