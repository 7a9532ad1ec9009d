// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/subdivision.h"

#include <gtest/gtest.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "tests/support/random_modifications.h"
#include "tests/surface/deviation.h"
#include "tests/surface/set_distance.h"
#include "tests/surface/surface_fixture.h"

namespace ew::test {
namespace {

namespace Far = OpenSubdiv::Far;

struct Point {
    Vec3 p = Vec3::Zero();
    void Clear() { p.setZero(); }
    void AddWithWeight(const Point& o, double w) { p += w * o.p; }
};

/// The refined vertices moved to the limit surface by OpenSubdiv's own refinement and limit masks:
/// another way than the patches that the code under test evaluates.
std::vector<Vec3> refinedLimit(const ControlCage& cage, SubdivisionScheme scheme, int levels) {
    std::vector<int> sizes;
    for (int f = 0; f < cage.mesh.faceCount(); ++f) {
        sizes.push_back(static_cast<int>(cage.mesh.outline(f).size()));
    }
    std::vector<int> ends;
    std::vector<float> weights;
    for (const CreaseEdge& c : cage.creases) {
        ends.insert(ends.end(), {c.from, c.to});
        weights.push_back(static_cast<float>(c.sharpness));
    }
    Far::TopologyDescriptor descriptor;
    descriptor.numVertices = static_cast<int>(cage.mesh.points.size());
    descriptor.numFaces = cage.mesh.faceCount();
    descriptor.numVertsPerFace = sizes.data();
    descriptor.vertIndicesPerFace = cage.mesh.corners.data();
    descriptor.numCreases = static_cast<int>(weights.size());
    descriptor.creaseVertexIndexPairs = ends.data();
    descriptor.creaseWeights = weights.data();
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    const auto type = scheme == SubdivisionScheme::Loop ? OpenSubdiv::Sdc::SCHEME_LOOP
                                                        : OpenSubdiv::Sdc::SCHEME_CATMARK;
    const std::unique_ptr<Far::TopologyRefiner> refiner(
        Factory::Create(descriptor, Factory::Options(type, OpenSubdiv::Sdc::Options())));
    Far::TopologyRefiner::UniformOptions uniform(levels);
    uniform.fullTopologyInLastLevel = true;
    refiner->RefineUniform(uniform);
    const Far::PrimvarRefinerReal<double> primvars(*refiner);
    std::vector<Point> points(cage.mesh.points.size());
    for (std::size_t i = 0; i < points.size(); ++i) points[i].p = cage.mesh.points[i];
    for (int level = 1; level <= levels; ++level) {
        std::vector<Point> next(
            static_cast<std::size_t>(refiner->GetLevel(level).GetNumVertices()));
        primvars.Interpolate(level, points, next);
        points = std::move(next);
    }
    std::vector<Point> limit(points.size());
    primvars.Limit(points, limit);
    std::vector<Vec3> out;
    for (const Point& p : limit) out.push_back(p.p);
    return out;
}

TEST(Subdivision, CubeLimitPositionsAreTheKnownOnes) {
    const Solid cube = solidOf(boxSpec({-1, -1, -1}, {1, 1, 1}));
    const ControlCage cage = smoothCage(cube, SubdivisionScheme::CatmullClark);
    SubdivisionOptions options;
    options.levels = 1;
    const SurfaceMesh surface = surfaceOf(cage, options);
    ASSERT_EQ(surface.positions.size(), 26U);
    ASSERT_EQ(surface.triangles.size(), 48U);
    const auto has = [&](const Vec3& p) {
        return std::any_of(surface.positions.begin(), surface.positions.end(),
                           [&](const Vec3& q) { return (p - q).norm() < 1e-12; });
    };
    // Halstead, Kass and DeRose 1993: (n^2 v + 4 sum of e + sum of f) / (n (n + 5)), n = 3.
    const Vec3 v(1, 1, 1);
    const Vec3 limit = (9.0 * v + 4.0 * (Vec3(-1, 1, 1) + Vec3(1, -1, 1) + Vec3(1, 1, -1)) +
                        (Vec3(-1, -1, 1) + Vec3(1, -1, -1) + Vec3(-1, 1, -1))) /
                       24.0;
    EXPECT_NEAR(limit.x(), 0.5, 1e-15);
    EXPECT_TRUE(has(limit));
    EXPECT_TRUE(has(-limit));
    // The refined middle of a face: four edge points and four face points around it, n = 4.
    const double edge = 3.0 / 4.0;  // (1 + 1 + 2 face middles) / 4, by symmetry
    EXPECT_TRUE(has(Vec3(0, 0, (16.0 + 16.0 * edge + 4.0 * 5.0 / 9.0) / 36.0)));
}

TEST(Subdivision, UniformEqualsRefinementAndLimitMasks) {
    const Solid bosses = solidOf(bossesSpec(1));
    const Solid pyramid = solidOf(pyramidSpec(5, 1.3));
    struct Case {
        ControlCage cage;
        SubdivisionScheme scheme;
    };
    const auto cc = SubdivisionScheme::CatmullClark;
    const auto loop = SubdivisionScheme::Loop;
    for (const Case& c :
         {Case{smoothCage(pyramid, cc), cc}, Case{smoothCage(pyramid, loop), loop},
          Case{filletedCage(bosses, 0.2, cc), cc}, Case{filletedCage(bosses, 0.2, loop), loop},
          Case{smoothCage(bosses, cc), cc}}) {
        for (const int levels : {1, 3}) {
            SubdivisionOptions options;
            options.scheme = c.scheme;
            options.levels = levels;
            const SurfaceMesh surface = surfaceOf(c.cage, options);
            const std::vector<Vec3> expected = refinedLimit(c.cage, c.scheme, levels);
            ASSERT_EQ(surface.positions.size(), expected.size());
            EXPECT_LT(setDistance(surface.positions, expected, 0.05), 1e-6) << levels;
            EXPECT_TRUE(checkClosed(asMesh(surface)));
        }
    }
}

TEST(Subdivision, AdaptivePointsLieOnTheUniformOnesSurface) {
    const Solid bosses = solidOf(bossesSpec(1));
    for (const auto scheme : {SubdivisionScheme::CatmullClark, SubdivisionScheme::Loop}) {
        const ControlCage cage = filletedCage(bosses, 0.2, scheme);
        SubdivisionOptions options;
        options.scheme = scheme;
        options.tolerance = 0.01;
        const SurfaceMesh adaptive = surfaceOf(cage, options);
        // Every corner of the cage is a point of both; refinement puts them first.
        const std::vector<Vec3> refined = refinedLimit(cage, scheme, 1);
        double worst = 0.0;
        for (std::size_t i = 0; i < cage.mesh.points.size(); ++i) {
            double best = 1.0;
            for (const Vec3& p : adaptive.positions) best = std::min(best, (p - refined[i]).norm());
            worst = std::max(worst, best);
        }
        EXPECT_LT(worst, 1e-6);
    }
}

TEST(Subdivision, AdaptiveKeepsItsToleranceWithHalfTheTriangles) {
    const Solid bosses = solidOf(bossesSpec(1));
    const auto cc = SubdivisionScheme::CatmullClark;
    const ControlCage cage = filletedCage(bosses, 0.2, cc);
    const std::vector<Vec3> dense = refinedLimit(cage, cc, 4);
    SubdivisionOptions options;
    for (const double tolerance : {0.005, 0.001, 0.0003}) {
        options.tolerance = tolerance;
        const SurfaceMesh adaptive = surfaceOf(cage, options);
        EXPECT_TRUE(checkClosed(asMesh(adaptive)));
        const double reached = deviation(dense, adaptive, 2.0 * tolerance);
        EXPECT_LE(reached, tolerance);
        // The coarsest uniform surface that is as good.
        SubdivisionOptions uniform;
        for (uniform.levels = 1; uniform.levels < 4; ++uniform.levels) {
            const SurfaceMesh even = surfaceOf(cage, uniform);
            if (deviation(dense, even, 2.0 * tolerance) > reached) continue;
            EXPECT_LE(2 * adaptive.triangles.size(), even.triangles.size()) << tolerance;
            break;
        }
    }
}

TEST(Subdivision, AdaptiveLoopAndPolygonsKeepTheirTolerance) {
    for (const auto scheme : {SubdivisionScheme::CatmullClark, SubdivisionScheme::Loop}) {
        for (const Solid& solid : {solidOf(pyramidSpec(5, 1.3)), solidOf(prismSpec(6, 1, 1, 1)),
                                   solidOf(lPrismSpec())}) {
            const ControlCage cage = smoothCage(solid, scheme);
            const std::vector<Vec3> dense = refinedLimit(cage, scheme, 4);
            SubdivisionOptions options;
            options.scheme = scheme;
            for (const double tolerance : {0.02, 0.004}) {
                options.tolerance = tolerance;
                const SurfaceMesh surface = surfaceOf(cage, options);
                EXPECT_TRUE(checkClosed(asMesh(surface)));
                EXPECT_LE(deviation(dense, surface, 2.0 * tolerance), tolerance);
            }
        }
    }
}

TEST(Subdivision, NormalsPointOutAndFollowTheTriangles) {
    const Solid bosses = solidOf(bossesSpec(1));
    for (const auto scheme : {SubdivisionScheme::CatmullClark, SubdivisionScheme::Loop}) {
        const ControlCage cage = filletedCage(bosses, 0.2, scheme);
        SubdivisionOptions options;
        options.scheme = scheme;
        const SurfaceMesh surface = surfaceOf(cage, options);
        EXPECT_TRUE(surface.normalTriangles.empty());
        for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
            const auto at = [&](std::size_t k) -> const Vec3& {
                return surface.positions[static_cast<std::size_t>(surface.triangles[t][k])];
            };
            const Vec3 n = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
            for (std::size_t k = 0; k < 3; ++k) {
                EXPECT_NEAR(surface.normal(t, k).norm(), 1.0, 1e-9);
                EXPECT_GT(surface.normal(t, k).dot(n), 0.7);
            }
        }
    }
}

TEST(Subdivision, PlanesKeepTheirNormalWhereTheirPiecesAreSlivers) {
    // All points whose whole neighbourhood is one plane have its normal.
    int points = 0;
    for (std::uint64_t number = 0; number < 60; ++number) {
        Random random(Random::mix(number, 5));
        const Solid solid = randomModifiedSolid(8, random);
        const double size = (solid.bounds()[1] - solid.bounds()[0]).norm();
        const auto cage = fillet(solid, allEdges(solid, 0.02 * size, 2));
        ASSERT_TRUE(cage);
        const ControlCage control = controlOf(*cage);
        SubdivisionOptions options;
        options.levels = 2;
        const SurfaceMesh surface = surfaceOf(control, options);
        for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
            const auto face = static_cast<std::size_t>(surface.origin[t]);
            const CageOrigin& origin =
                cage->origins[static_cast<std::size_t>(control.origin[face])];
            if (origin.kind != CageOrigin::Kind::Face) continue;
            const Vec3& normal = solid.faces()[static_cast<std::size_t>(origin.index)].normal;
            for (std::size_t k = 0; k < 3; ++k) {
                if (std::abs(surface.normal(t, k).dot(normal)) < 1.0 - 1e-9) continue;
                ++points;
                EXPECT_GT(surface.normal(t, k).dot(normal), 0.0) << number;
            }
        }
    }
    EXPECT_GT(points, 10000);
}

/// Triangles that run backwards although the surface is flat there.
int foldedTriangles(const SurfaceMesh& surface) {
    int folded = 0;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const auto at = [&](std::size_t k) -> const Vec3& {
            return surface.positions[static_cast<std::size_t>(surface.triangles[t][k])];
        };
        const Vec3 area = (at(1) - at(0)).cross(at(2) - at(0));
        const bool flat = surface.normal(t, 0).dot(surface.normal(t, 1)) > 1.0 - 1e-9 &&
                          surface.normal(t, 1).dot(surface.normal(t, 2)) > 1.0 - 1e-9;
        if (flat && area.dot(surface.normal(t, 0)) < 0.0) ++folded;
    }
    return folded;
}

TEST(Subdivision, FlatPartsHaveNoFoldsBesideSlivers) {
    for (std::uint64_t number = 0; number < 60; ++number) {
        Random random(Random::mix(number, 5));
        const Solid solid = randomModifiedSolid(8, random);
        const double size = (solid.bounds()[1] - solid.bounds()[0]).norm();
        const auto cage = fillet(solid, allEdges(solid, 0.005 * size, 2));
        ASSERT_TRUE(cage);
        const ControlCage control = controlOf(*cage);
        for (const int levels : {1, 2}) {
            SubdivisionOptions options;
            options.levels = levels;
            const SurfaceMesh surface = surfaceOf(control, options);
            EXPECT_TRUE(checkClosed(asMesh(surface)));
            EXPECT_EQ(foldedTriangles(surface), 0) << number << ", " << levels;
        }
    }
}

TEST(Subdivision, ACornerOfTwoFacesIsNotCutOffByBothAlongOneLine) {
    // A cube, one edge of which has a point in its middle, off the straight line.
    ControlCage cage;
    for (int i = 0; i < 8; ++i) cage.mesh.addPoint(Vec3(i & 1, i >> 1 & 1, i >> 2 & 1));
    const int middle = cage.mesh.addPoint(Vec3(0.5, -0.4, -0.4));  // of the edge 0-1
    cage.mesh.addFace({0, 2, 3, 1, middle});
    cage.mesh.addFace({0, middle, 1, 5, 4});
    cage.mesh.addFace({4, 5, 7, 6});
    cage.mesh.addFace({2, 6, 7, 3});
    cage.mesh.addFace({0, 4, 6, 2});
    cage.mesh.addFace({1, 3, 7, 5});
    for (int f = 0; f < 6; ++f) cage.origin.push_back(f);
    ASSERT_TRUE(checkClosed(cage.mesh));
    for (const int levels : {1, 2}) {
        SubdivisionOptions options;
        options.levels = levels;
        EXPECT_TRUE(checkClosed(asMesh(surfaceOf(cage, options)))) << levels;
    }
}

TEST(Subdivision, SeveralShellsAreOneSurface) {
    PolyhedronSpec spec = boxSpec({0, 0, 0}, {1, 1, 1});
    const PolyhedronSpec other = boxSpec({3, 0, 0}, {4, 1, 1});
    const int base = static_cast<int>(spec.vertices.size());
    spec.vertices.insert(spec.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (auto face : other.faces) {
        for (int& i : face) i += base;
        spec.faces.push_back(face);
    }
    const Solid two = solidOf(spec);
    const ControlCage cage = filletedCage(two, 0.1, SubdivisionScheme::CatmullClark);
    const SurfaceMesh surface = surfaceOf(cage, {});
    EXPECT_TRUE(checkClosed(asMesh(surface)));
    const double volume = enclosedVolume(surface.positions, surface.triangles);
    EXPECT_GT(volume, 1.9);
    EXPECT_LT(volume, 2.0);
}

TEST(Subdivision, AVoidInsideIsAShellOfItsOwn) {
    PolyhedronSpec spec = boxSpec({0, 0, 0}, {4, 4, 4});
    const PolyhedronSpec inner = boxSpec({1, 1, 1}, {3, 3, 3});
    const int base = static_cast<int>(spec.vertices.size());
    spec.vertices.insert(spec.vertices.end(), inner.vertices.begin(), inner.vertices.end());
    for (auto face : inner.faces) {
        std::reverse(face.begin(), face.end());
        for (int& i : face) i += base;
        spec.faces.push_back(face);
    }
    const Solid hollow = solidOf(spec);
    ASSERT_EQ(hollow.shellCount(), 2);
    const ControlCage cage = filletedCage(hollow, 0.2, SubdivisionScheme::CatmullClark);
    SubdivisionOptions options;
    for (const double tolerance : {0.0, 0.01}) {
        options.tolerance = tolerance;
        const SurfaceMesh surface = surfaceOf(cage, options);
        EXPECT_TRUE(checkClosed(asMesh(surface)));
        // Rounding takes away from the outer shell and from the void.
        const double volume = enclosedVolume(surface.positions, surface.triangles);
        EXPECT_NEAR(volume, 64.0 - 8.0, 0.5);
    }
}

TEST(Subdivision, TooMuchMemoryIsRefusedBeforeItIsTaken) {
    const Solid bosses = solidOf(bossesSpec(3));
    const ControlCage cage = filletedCage(bosses, 0.1, SubdivisionScheme::CatmullClark);
    SubdivisionOptions options;
    options.levels = 6;
    options.memoryLimit = 10'000'000;
    auto surface = subdivide(cage, options);
    ASSERT_FALSE(surface);
    EXPECT_EQ(surface.error().code, Errc::TooMuchMemory);
    EXPECT_EQ(errcName(Errc::TooMuchMemory), "too-much-memory");
    options.tolerance = 1e-12;
    options.memoryLimit = std::size_t{1} << 30U;
    surface = subdivide(cage, options);
    ASSERT_FALSE(surface);
    EXPECT_EQ(surface.error().code, Errc::TooMuchMemory);
    // What is promised holds: the result is not larger than the limit that it was allowed.
    options.tolerance = 0.0;
    options.levels = 3;
    const SurfaceMesh fits = surfaceOf(cage, options);
    EXPECT_LE(surfaceBytes(fits.positions.size(), fits.triangles.size(), false),
              options.memoryLimit);
}

TEST(Subdivision, BadInputIsRefusedWithACode) {
    const Solid box = solidOf(boxSpec({0, 0, 0}, {1, 1, 1}));
    const ControlCage cage = controlOf(sharpCage(box));
    const auto code = [](const ControlCage& c, const SubdivisionOptions& o) {
        const auto surface = subdivide(c, o);
        return surface ? Errc::Cancelled : surface.error().code;
    };
    SubdivisionOptions options;
    options.levels = 7;
    EXPECT_EQ(code(cage, options), Errc::BadValue);
    options.levels = -1;
    EXPECT_EQ(code(cage, options), Errc::BadValue);
    options.levels = 1;
    options.tolerance = -1.0;
    EXPECT_EQ(code(cage, options), Errc::BadValue);
    options.tolerance = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(code(cage, options), Errc::BadValue);
    options.tolerance = 0.0;
    options.scheme = SubdivisionScheme::Loop;
    EXPECT_EQ(code(cage, options), Errc::BadValue);
    ControlCage bad = cage;
    bad.mesh.points[0].x() = std::numeric_limits<double>::infinity();
    EXPECT_EQ(code(bad, {}), Errc::BadValue);
    ControlCage open = cage;
    open.mesh.faceStart.pop_back();
    open.mesh.loopStart.pop_back();
    open.mesh.corners.resize(static_cast<std::size_t>(open.mesh.loopStart.back()));
    EXPECT_EQ(code(open, {}), Errc::NotClosed);
    EXPECT_EQ(code({}, {}), Errc::NoSolid);
    ControlOptions control;
    control.edgeSharpness.assign(3, 1.0);
    EXPECT_FALSE(controlCage(sharpCage(box), control));
    control.edgeSharpness.assign(12, std::numeric_limits<double>::quiet_NaN());
    EXPECT_FALSE(controlCage(sharpCage(box), control));
    control.edgeSharpness.clear();
    control.supportRatio = 1.5;
    EXPECT_FALSE(controlCage(sharpCage(box), control));
}

TEST(Subdivision, RandomCagesStayClosed) {
    for (std::uint64_t number = 0; number < 60; ++number) {
        const Solid solid = randomSolid(number);
        const double size = (solid.bounds()[1] - solid.bounds()[0]).norm();
        Random random(Random::mix(number, 9));
        FilletOptions options = allEdges(solid, 0.04 * size, 1 + random.index(3));
        std::erase_if(options.edges, [&](const FilletChoice&) { return random.chance(0.3); });
        if (options.edges.empty()) continue;
        const auto cage = fillet(solid, options);
        ASSERT_TRUE(cage);
        for (const auto scheme : {SubdivisionScheme::CatmullClark, SubdivisionScheme::Loop}) {
            ControlOptions control;
            control.scheme = scheme;
            const ControlCage polygons = controlOf(*cage, control);
            SubdivisionOptions subdivision;
            subdivision.scheme = scheme;
            subdivision.levels = random.index(3);
            const SurfaceMesh uniform = surfaceOf(polygons, subdivision);
            EXPECT_TRUE(checkClosed(asMesh(uniform))) << number;
            subdivision.tolerance = 0.003 * size;
            const SurfaceMesh adaptive = surfaceOf(polygons, subdivision);
            EXPECT_TRUE(checkClosed(asMesh(adaptive))) << number;
            for (const Eigen::Vector3f& n : adaptive.normals)
                EXPECT_NEAR(n.norm(), 1.0, 1e-6) << number;
        }
    }
}

}  // namespace
}  // namespace ew::test
