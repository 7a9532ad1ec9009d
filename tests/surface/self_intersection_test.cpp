// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/self_intersection.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/surface/shapes.h"

namespace ew::test {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

Pairs sorted(Pairs pairs) {
    for (auto& [a, b] : pairs) {
        if (a > b) std::swap(a, b);
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

Pairs byExactArithmetic(const std::vector<Vec3>& points,
                        const std::vector<std::array<int, 3>>& triangles) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
    Mesh mesh;
    for (const Vec3& p : points) mesh.add_vertex({p.x(), p.y(), p.z()});
    for (const auto& t : triangles) {
        const auto id = [&](std::size_t k) {
            return Mesh::Vertex_index(static_cast<Mesh::size_type>(t[k]));
        };
        EXPECT_NE(mesh.add_face(id(0), id(1), id(2)), Mesh::null_face());
    }
    std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
    CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
    Pairs out;
    for (const auto& [a, b] : pairs) {
        out.emplace_back(static_cast<int>(a), static_cast<int>(b));
    }
    return sorted(out);
}

TEST(SelfIntersection, FindsWhatExactArithmeticFindsInCrumpledSurfaces) {
    std::size_t found = 0;
    for (std::uint64_t number = 0; number < 60; ++number) {
        const Solid solid = randomSolid(number);
        const double size = (solid.bounds()[1] - solid.bounds()[0]).norm();
        const auto cage = fillet(solid, allEdges(solid, 0.02 * size, 1 + number % 4));
        ASSERT_TRUE(cage);
        const auto triangles = triangulate(cage->mesh);
        ASSERT_TRUE(triangles);
        std::vector<Vec3> points = cage->mesh.points;
        Random random(number);
        const double crumple = size * 0.05 * random.uniform(0.0, 1.0);
        for (Vec3& p : points) {
            for (int k = 0; k < 3; ++k) p[k] += random.uniform(-crumple, crumple);
        }
        const std::vector<int> apart(triangles->triangles.size(), -1);
        const Pairs exact = byExactArithmetic(points, triangles->triangles);
        Pairs ofTwoFaces;
        for (const auto& [a, b] : exact) {
            const auto face = [&](int t) { return triangles->face[static_cast<std::size_t>(t)]; };
            if (face(a) != face(b)) ofTwoFaces.emplace_back(a, b);
        }
        found += ofTwoFaces.size();
        for (const bool byFace : {false, true}) {
            const Pairs own =
                sorted(selfIntersections(points, triangles->triangles,
                                         byFace ? triangles->face : apart, std::size_t{1} << 30U));
            const Pairs& all = byFace ? ofTwoFaces : exact;
            EXPECT_TRUE(std::includes(own.begin(), own.end(), all.begin(), all.end())) << number;
            // What it errs on is what touches within rounding, which crumpling makes rare.
            EXPECT_LE(own.size(), all.size() + all.size() / 100) << number;
        }
    }
    EXPECT_GT(found, 1000U);
}

TEST(SelfIntersection, AFoldedFanIsFound) {
    // A closed double pyramid over a square, one corner of which is drawn back over the others.
    std::vector<Vec3> points{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    const std::vector<std::array<int, 3>> triangles{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4},
                                                    {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}};
    const std::vector<int> apart(triangles.size(), -1);
    EXPECT_TRUE(selfIntersections(points, triangles, apart, 100).empty());
    points[0] = {-1.5, 2, 0};
    const Pairs exact = byExactArithmetic(points, triangles);
    EXPECT_FALSE(exact.empty());
    EXPECT_EQ(sorted(selfIntersections(points, triangles, apart, 100)), exact);
    EXPECT_EQ(selfIntersections(points, triangles, apart, 1).size(), 1U);
    EXPECT_TRUE(
        selfIntersections(points, triangles, std::vector<int>(triangles.size(), 0), 100).empty());
}

}  // namespace
}  // namespace ew::test
