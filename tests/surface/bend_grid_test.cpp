// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/bend_grid.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/surface/surface_fixture.h"

namespace ew::test {
namespace {

template <class Surface>
std::vector<Vec3> sampled(const Surface& surface, int cells = kBendCells) {
    std::vector<Vec3> out;
    for (int k = 0; k <= cells; ++k) {
        for (int i = 0; i <= cells; ++i) {
            out.push_back(surface(static_cast<double>(i) / cells, static_cast<double>(k) / cells));
        }
    }
    return out;
}

TEST(BendGrid, BendsOfCubicsAreExactToTheBorder) {
    const auto points = sampled([](double u, double v) {
        return Vec3(4.0 * u, 3.0 * v, 1e-4 * (u * u * u - 2.0 * u * v * v + 5.0 * v * v));
    });
    const BendGrid grid(points);
    for (int k = 0; k <= kBendCells; ++k) {
        for (int i = 0; i <= kBendCells; ++i) {
            const double u = static_cast<double>(i) / kBendCells;
            const double v = static_cast<double>(k) / kBendCells;
            const Bend& bend = grid.bend(i, k);
            EXPECT_NEAR(bend.uu, 6e-4 * u, 1e-9);
            EXPECT_NEAR(bend.uv, -4e-4 * v, 1e-9);
            EXPECT_NEAR(bend.vv, 1e-3 - 4e-4 * u, 1e-9);
        }
    }
}

TEST(BendGrid, HowPointsAreSpacedIsNoBend) {
    const auto points = sampled(
        [](double u, double v) { return Vec3(u * u * u + 0.1 * u, v + 0.2 * v * v, 0.3 * v); });
    const BendGrid grid(points);
    for (int side = 0; side < 4; side += 2) EXPECT_NEAR(grid.curve(side), 0.0, 1e-12);
    EXPECT_TRUE(grid.uneven());
    const auto bent = sampled([](double u, double v) { return Vec3(u, v, 0.5 * u * u); });
    EXPECT_NEAR(BendGrid(bent).curve(0), 1.0, 1e-12);
    EXPECT_NEAR(BendGrid(bent).curve(1), 0.0, 1e-12);
    EXPECT_FALSE(BendGrid(bent).uneven());
}

TEST(BendGrid, DeviationIsThatOfTheBetterDiagonal) {
    // A ridge along a diagonal of the domain.
    const auto ridge = [](double u, double v) { return Vec3(u, v, -0.01 * (u - v) * (u - v)); };
    const auto points = sampled(ridge);
    const BendGrid grid(points);
    // Along the ridge there is no bend; the middles of the sides are the farthest points.
    EXPECT_NEAR(grid.deviation(points, kBendCells, 1, 1), 0.0025, 1e-5);
    EXPECT_NEAR(grid.deviation(points, kBendCells, 2, 2), 0.0025 / 4.0, 1e-5);
    const auto dense = sampled(ridge, 2 * kBendCells);
    EXPECT_NEAR(grid.deviation(dense, 2 * kBendCells, 1, 1), 0.0025, 1e-5);
}

TEST(BendGrid, FlatFacesBetweenCreasesTakeFewTriangles) {
    // Rows that hold the corners make its creases uneven, but not bent.
    const ControlCage cage = controlOf(sharpCage(solidOf(lPrismSpec())));
    SubdivisionOptions options;
    options.tolerance = 1e-4;
    const SurfaceMesh surface = surfaceOf(cage, options);
    EXPECT_TRUE(checkClosed(asMesh(surface)));
    EXPECT_LE(surface.triangles.size(), 3U * static_cast<std::size_t>(cage.mesh.faceCount()));
}

}  // namespace
}  // namespace ew::test
