// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces as another program reads them: unit normals, triangles with an area, closed.
#include <gtest/gtest.h>

#include <cmath>

#include "core/surface/mesh_reading.h"
#include "tests/surface/surface_fixture.h"

namespace ew::test {
namespace {

std::vector<Eigen::Vector3f> inSinglePrecision(const std::vector<Vec3>& points) {
    std::vector<Eigen::Vector3f> out;
    for (const Vec3& p : points) out.push_back(p.cast<float>());
    return out;
}

TEST(SurfaceReading, FilletsOfConcaveEdgesAloneHaveUnitNormalsAndAreas) {
    const Solid solid = solidOf(lPrismSpec());
    for (const int segments : {1, 3}) {
        const auto cage = fillet(solid, edgesOfKind(solid, false, 0.1, segments));
        ASSERT_TRUE(cage);
        for (const int levels : {1, 2}) {
            SubdivisionOptions options;
            options.levels = levels;
            const SurfaceMesh surface = surfaceOf(controlOf(*cage), options);
            for (const Eigen::Vector3f& n : surface.normals) {
                ASSERT_NEAR(n.norm(), 1.0F, 1e-5F) << levels << " levels, " << segments;
            }
            const ReadingFaults faults =
                faultsWhenRead(inSinglePrecision(surface.positions), surface.triangles);
            EXPECT_EQ(faults.withoutArea, 0U) << levels << " levels, " << segments;
            EXPECT_EQ(faults.openEdges, 0U) << levels << " levels, " << segments;
        }
    }
}

TEST(SurfaceReading, TellsWhatASlicerWouldTell) {
    const std::vector<Eigen::Vector3f> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                                              {0, 0, 1}, {0, 0, 1}, {0.5F, 0, 0}};
    using Ids = std::vector<std::array<int, 3>>;
    // Points with the same coordinates are one.
    EXPECT_TRUE(faultsWhenRead(points, Ids{{0, 2, 1}, {0, 1, 3}, {1, 2, 4}, {2, 0, 3}}).none());
    EXPECT_EQ(faultsWhenRead(points, Ids{{0, 2, 1}, {0, 1, 3}, {1, 2, 4}}).openEdges, 3U);
    // A pair of opposite triangles on an edge that two others have.
    const Ids doubled{{0, 2, 1}, {0, 1, 3}, {1, 2, 4}, {2, 0, 3}, {0, 1, 5}, {1, 0, 5}};
    EXPECT_EQ(faultsWhenRead(points, doubled), (ReadingFaults{2, 1}));
}

}  // namespace
}  // namespace ew::test
