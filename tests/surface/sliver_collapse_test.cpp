// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/sliver_collapse.h"

#include <gtest/gtest.h>

#include "core/surface/mesh_reading.h"

namespace ew::test {
namespace {

/// A tetrahedron with a point in the middle of an edge, and both triangles there cut so that one of
/// them lies in the edge.
SurfaceMesh withSliver() {
    SurfaceMesh mesh;
    mesh.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}, {2, 0, 0}};
    mesh.normals.assign(5, Eigen::Vector3f::UnitZ());
    mesh.triangles = {{0, 2, 1}, {0, 4, 3}, {4, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 1, 4}};
    mesh.origin = {0, 1, 2, 3, 4, 5};
    return mesh;
}

ReadingFaults faults(const SurfaceMesh& mesh) {
    std::vector<Eigen::Vector3f> points;
    for (const Vec3& p : mesh.positions) points.push_back(p.cast<float>());
    return faultsWhenRead(points, mesh.triangles);
}

TEST(SliverCollapse, ATriangleInALineIsTakenOutAndTheSurfaceStaysClosed) {
    SurfaceMesh mesh = withSliver();
    ASSERT_EQ(faults(mesh), (ReadingFaults{1, 0}));
    collapseSlivers(mesh);
    EXPECT_TRUE(faults(mesh).none());
    EXPECT_EQ(mesh.triangles.size(), 4U);
    EXPECT_EQ(mesh.positions.size(), 4U);
    EXPECT_EQ(mesh.normals.size(), 4U);
    EXPECT_EQ(mesh.origin.size(), 4U);
}

TEST(SliverCollapse, NormalsOfCornersStayWhereTheyAreKeptApart) {
    SurfaceMesh mesh = withSliver();
    mesh.normalTriangles = mesh.triangles;
    mesh.normals[4] = Eigen::Vector3f::UnitX();
    collapseSlivers(mesh);
    EXPECT_TRUE(faults(mesh).none());
    EXPECT_EQ(mesh.normalTriangles.size(), 4U);
    EXPECT_EQ(mesh.normals.size(), 5U);
}

TEST(SliverCollapse, GoodSurfacesStay) {
    SurfaceMesh mesh = withSliver();
    mesh.positions[4] = {2, -1, 0};
    const auto before = mesh.triangles;
    collapseSlivers(mesh);
    EXPECT_EQ(mesh.triangles, before);
    EXPECT_EQ(mesh.positions.size(), 5U);
}

TEST(SliverCollapse, WhatCannotBeMendedStays) {
    // Two triangles back to back: nothing would be left.
    SurfaceMesh mesh;
    mesh.positions = {{0, 0, 0}, {4, 0, 0}, {2, 0, 0}};
    mesh.normals.assign(3, Eigen::Vector3f::UnitZ());
    mesh.triangles = {{0, 1, 2}, {1, 0, 2}};
    mesh.origin = {0, 0};
    collapseSlivers(mesh);
    EXPECT_EQ(mesh.triangles.size(), 2U);
}

}  // namespace
}  // namespace ew::test
