// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/solid/shapes.h"

namespace ew::test {
namespace {

Solid made(const PolyhedronSpec& spec) {
    auto solid = Solid::fromSpec(spec);
    if (!solid) {
        ADD_FAILURE() << solid.error().message;
        return *Solid::fromSpec(box(Vec3::Zero(), Vec3::Ones()));
    }
    return *solid;
}

struct Counts {
    std::size_t vertices, edges, faces;
    int shells, genus;
    bool operator==(const Counts&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Counts& c) {
    return out << c.vertices << " vertices, " << c.edges << " edges, " << c.faces << " faces, "
               << c.shells << " shells, genus " << c.genus;
}
Counts countsOf(const Solid& s) {
    return {s.vertices().size(), s.edges().size(), s.faces().size(), s.shellCount(), s.genus()};
}

TEST(Solid, BoxIsExact) {
    const PolyhedronSpec spec = box(Vec3::Zero(), Vec3(3, 2, 1));
    const Solid s = made(spec);
    EXPECT_EQ(countsOf(s), (Counts{8, 12, 6, 1, 0}));
    EXPECT_NEAR(s.volume(), 6.0, 1e-12);
    EXPECT_NEAR(s.area(), 22.0, 1e-12);
    EXPECT_EQ(s.bounds()[0], Vec3(0, 0, 0));
    EXPECT_EQ(s.bounds()[1], Vec3(3, 2, 1));
    EXPECT_EQ(s.triangles().size(), 12U);
}

TEST(Solid, BoxKeepsItsCoordinatesToTheBit) {
    const PolyhedronSpec spec = box(Vec3(0.1, -1.0 / 3.0, 1e-3), Vec3(0.7, 2.0 / 3.0, 17.3));
    EXPECT_EQ(made(spec).vertices(), spec.vertices);
}

struct Known {
    const char* name;
    PolyhedronSpec spec;
    Counts counts;
    double volume;
};

std::vector<Known> knownBodies() {
    const double hexagon = 1.5 * std::sqrt(3.0);
    return {
        {"triangular prism", prism(3), {6, 9, 5, 1, 0}, 0.75 * std::sqrt(3.0)},
        {"hexagonal prism", prism(6), {12, 18, 8, 1, 0}, hexagon},
        {"truncated square pyramid", frustum(4, 0.5), {8, 12, 6, 1, 0}, 2.0 * 1.75 / 3.0},
        {"square pyramid", pyramid(4), {5, 8, 5, 1, 0}, 2.0 / 3.0},
        {"tetrahedron", pyramid(3), {4, 6, 4, 1, 0}, std::sqrt(3.0) / 4.0},
        {"octahedron", bipyramid(4), {6, 12, 8, 1, 0}, 4.0 / 3.0},
        {"pentagonal antiprism", antiprism(5), {10, 20, 12, 1, 0}, plainVolume(antiprism(5))},
        {"L-prism", lPrism(), {12, 18, 8, 1, 0}, 3.0},
        {"square ring", squareRing(), {16, 24, 10, 1, 1}, 12.0},
        {"torus", torus(8, 5), {40, 80, 40, 1, 1}, plainVolume(torus(8, 5))},
        {"two boxes",
         together(box(Vec3(0, 0, 0), Vec3(1, 1, 1)), box(Vec3(2, 0, 0), Vec3(3, 1, 2))),
         {16, 24, 12, 2, 0},
         3.0},
        {"box with a cavity",
         together(box(Vec3(0, 0, 0), Vec3(3, 3, 3)), insideOut(box(Vec3(1, 1, 1), Vec3(2, 2, 2)))),
         {16, 24, 12, 2, 0},
         26.0},
    };
}

TEST(Solid, KnownBodies) {
    for (const Known& known : knownBodies()) {
        SCOPED_TRACE(known.name);
        const Solid s = made(known.spec);
        EXPECT_EQ(countsOf(s), known.counts);
        EXPECT_NEAR(s.volume(), known.volume, 1e-11 * known.volume);
    }
}

TEST(Solid, KnownBodiesTurnedAndShifted) {
    for (const Known& known : knownBodies()) {
        SCOPED_TRACE(known.name);
        const PolyhedronSpec spec = moved(known.spec, 0.7, 30.1, Vec3(3, -5, 700));
        const Solid s = made(spec);
        EXPECT_EQ(countsOf(s), known.counts);
        const double volume = known.volume * std::pow(30.1, 3);
        EXPECT_NEAR(s.volume(), volume, 1e-9 * volume);
        ASSERT_EQ(s.vertices().size(), spec.vertices.size());
        for (std::size_t i = 0; i < spec.vertices.size(); ++i) {
            EXPECT_LT((s.vertices()[i] - spec.vertices[i]).norm(), 1e-6 * 30.1);
        }
    }
}

TEST(Solid, FacesLookOutwardAndHoldTheirPoints) {
    for (const Known& known : knownBodies()) {
        SCOPED_TRACE(known.name);
        const Solid s = made(moved(known.spec, 1.1, 5.0, Vec3(1, 2, 3)));
        double six = 0.0;  // divergence theorem on the faces: volume = sum of offset * area / 3
        std::vector<double> area(s.faces().size(), 0.0);
        for (const SolidTriangle& t : s.triangles()) {
            const auto p = [&](std::size_t k) -> const Vec3& {
                return s.vertices()[static_cast<std::size_t>(t.vertices[k])];
            };
            const Vec3 n = (p(1) - p(0)).cross(p(2) - p(0));
            EXPECT_GT(n.dot(s.faces()[static_cast<std::size_t>(t.face)].normal), 0.0);
            area[static_cast<std::size_t>(t.face)] += n.norm();
        }
        for (std::size_t f = 0; f < s.faces().size(); ++f) {
            const SolidFace& face = s.faces()[f];
            EXPECT_NEAR(face.normal.norm(), 1.0, 1e-12);
            six += face.offset * area[f];
            for (const auto& loop : face.loops) {
                for (const int i : loop) {
                    const Vec3& p = s.vertices()[static_cast<std::size_t>(i)];
                    EXPECT_NEAR(face.normal.dot(p), face.offset, 1e-8);
                }
            }
        }
        EXPECT_NEAR(six / 6.0, s.volume(), 1e-7 * s.volume());
    }
}

TEST(Solid, EveryEdgeLiesBetweenItsTwoFaces) {
    for (const Known& known : knownBodies()) {
        SCOPED_TRACE(known.name);
        const Solid s = made(known.spec);
        for (const SolidEdge& e : s.edges()) {
            for (std::size_t side = 0; side < 2; ++side) {
                ASSERT_GE(e.faces[side], 0);
                const int from = e.ends[side];
                const int to = e.ends[1 - side];
                bool found = false;
                for (const auto& loop : s.faces()[static_cast<std::size_t>(e.faces[side])].loops) {
                    for (std::size_t k = 0; k < loop.size(); ++k) {
                        found |= loop[k] == from && loop[(k + 1) % loop.size()] == to;
                    }
                }
                EXPECT_TRUE(found) << from << "-" << to;
            }
        }
    }
}

TEST(Solid, ConvexityOfEdges) {
    const auto concave = [](const Solid& s) {
        return std::count_if(s.edges().begin(), s.edges().end(),
                             [](const SolidEdge& e) { return !e.convex; });
    };
    EXPECT_EQ(concave(made(box(Vec3::Zero(), Vec3(1, 2, 3)))), 0);
    EXPECT_EQ(concave(made(bipyramid(7))), 0);
    EXPECT_EQ(concave(made(squareRing())), 4);  // the upright edges of the hole
    const Solid l = made(lPrism());
    EXPECT_EQ(concave(l), 1);
    const auto it = std::find_if(l.edges().begin(), l.edges().end(),
                                 [](const SolidEdge& e) { return !e.convex; });
    for (const int end : it->ends) {
        EXPECT_EQ(l.vertices()[static_cast<std::size_t>(end)].x(), 1.0);
        EXPECT_EQ(l.vertices()[static_cast<std::size_t>(end)].z(), 1.0);
    }
}

TEST(Solid, CoplanarFacesBecomeOneFaceWithAHole) {
    const Solid s = made(squareRing());
    int withHole = 0;
    for (const SolidFace& face : s.faces()) {
        if (face.loops.size() == 1) continue;
        ++withHole;
        ASSERT_EQ(face.loops.size(), 2U);
        EXPECT_EQ(std::abs(face.normal.z()), 1.0);
        for (const int i : face.loops[0]) {
            EXPECT_EQ(std::abs(s.vertices()[static_cast<std::size_t>(i)].x()), 2.0);
        }
        for (const int i : face.loops[1]) {
            EXPECT_EQ(std::abs(s.vertices()[static_cast<std::size_t>(i)].x()), 1.0);
        }
    }
    EXPECT_EQ(withHole, 2);
}

TEST(Solid, PointsOnStraightEdgesAreNoCorners) {
    // The front of a box is cut in two by an edge whose ends lie on the box's edges.
    PolyhedronSpec spec = box(Vec3::Zero(), Vec3(2, 2, 2));
    spec.vertices.emplace_back(1, 0, 0);
    spec.vertices.emplace_back(1, 0, 2);
    spec.faces = {{0, 3, 2, 1, 8}, {4, 9, 5, 6, 7}, {0, 8, 9, 4}, {8, 1, 5, 9},
                  {1, 2, 6, 5},    {2, 3, 7, 6},    {3, 0, 4, 7}};
    const Solid s = made(spec);
    EXPECT_EQ(countsOf(s), (Counts{8, 12, 6, 1, 0}));
    EXPECT_EQ(s.triangles().size(), 12U);
    EXPECT_TRUE(s.identicalTo(made(box(Vec3::Zero(), Vec3(2, 2, 2)))));
}

TEST(Solid, ANearlyFlatFaceIsMadePlanar) {
    PolyhedronSpec spec = frustum(4, 0.5);
    spec.vertices[5] += Vec3(0, 0, 1e-7);
    const Solid s = made(spec);
    EXPECT_EQ(countsOf(s), (Counts{8, 12, 6, 1, 0}));
    EXPECT_EQ(s.triangles().size(), 12U);
}

TEST(Solid, CopiesAreIdenticalAndOthersAreNot) {
    const Solid a = made(box(Vec3::Zero(), Vec3(1, 2, 3)));
    const Solid copy = a;
    EXPECT_TRUE(a.identicalTo(copy));
    EXPECT_TRUE(a.identicalTo(made(box(Vec3::Zero(), Vec3(1, 2, 3)))));
    EXPECT_FALSE(a.identicalTo(made(box(Vec3::Zero(), Vec3(1, 2, std::nextafter(3.0, 4.0))))));
    EXPECT_FALSE(a.identicalTo(made(pyramid(4))));
}

// Refusals ---------------------------------------------------------------------------------------

struct Bad {
    const char* name;
    PolyhedronSpec spec;
    Errc code;
};

PolyhedronSpec withPoint(std::size_t i, const Vec3& p) {
    PolyhedronSpec spec = box(Vec3::Zero(), Vec3::Ones());
    spec.vertices[i] = p;
    return spec;
}
PolyhedronSpec withFaces(const std::vector<std::vector<int>>& faces) {
    PolyhedronSpec spec = box(Vec3::Zero(), Vec3::Ones());
    spec.faces = faces;
    return spec;
}

/// Two solids whose points `pairs` (of the first, of the second) are one.
PolyhedronSpec welded(const PolyhedronSpec& a, const PolyhedronSpec& b,
                      const std::vector<std::pair<int, int>>& pairs) {
    PolyhedronSpec spec = together(a, b);
    const int base = static_cast<int>(a.vertices.size());
    for (auto& face : spec.faces) {
        for (int& i : face) {
            for (const auto& [keep, drop] : pairs) {
                if (i == base + drop) i = keep;
            }
        }
    }
    // Points that nothing uses any more go, from the back.
    for (auto it = pairs.rbegin(); it != pairs.rend(); ++it) {
        const int gone = base + it->second;
        spec.vertices.erase(spec.vertices.begin() + gone);
        for (auto& face : spec.faces) {
            for (int& i : face) i -= i > gone ? 1 : 0;
        }
    }
    return spec;
}

std::vector<Bad> badBodies() {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    const PolyhedronSpec unit = box(Vec3::Zero(), Vec3::Ones());
    const auto& f = unit.faces;
    PolyhedronSpec unused = unit;
    unused.vertices.emplace_back(9, 9, 9);
    PolyhedronSpec star = prism(5);
    star.faces[0] = {4, 2, 0, 3, 1};
    star.faces[1] = {5, 7, 9, 6, 8};
    star.faces.resize(2);
    for (int k = 0; k < 5; ++k) {
        const int a = 2 * k % 5;
        const int b = (a + 2) % 5;
        star.faces.push_back({a, b, 5 + b, 5 + a});
    }
    return {
        {"nothing", {}, Errc::NotClosed},
        {"no faces", withFaces({}), Errc::BadValue},
        {"NaN", withPoint(3, Vec3(nan, 0, 0)), Errc::BadValue},
        {"infinity", withPoint(3, Vec3(0, inf, 0)), Errc::BadValue},
        {"1e308", withPoint(3, Vec3(0, 0, 1e308)), Errc::BadValue},
        {"index too large", withFaces({f[0], f[1], f[2], f[3], f[4], {3, 0, 4, 8}}),
         Errc::BadValue},
        {"index negative", withFaces({f[0], f[1], f[2], f[3], f[4], {3, 0, 4, -1}}),
         Errc::BadValue},
        {"two points", withFaces({f[0], f[1], f[2], f[3], f[4], {3, 0}}), Errc::BadValue},
        {"a point twice", withFaces({f[0], f[1], f[2], f[3], f[4], {3, 0, 0, 4, 7}}),
         Errc::BadValue},
        {"there and back", withFaces({f[0], f[1], f[2], f[3], f[4], {3, 0, 4, 0}}), Errc::BadValue},
        {"unused point", unused, Errc::BadValue},
        {"open", withFaces({f[0], f[1], f[2], f[3], f[4]}), Errc::NotClosed},
        {"one face turned", withFaces({f[0], f[1], f[2], f[3], f[4], {7, 4, 0, 3}}),
         Errc::NotOriented},
        {"inside out", insideOut(unit), Errc::NotOriented},
        {"a face twice", withFaces({f[0], f[1], f[2], f[3], f[4], f[5], f[5]}), Errc::NotManifold},
        {"cavity inside out",
         together(box(Vec3(0, 0, 0), Vec3(3, 3, 3)), box(Vec3(1, 1, 1), Vec3(2, 2, 2))),
         Errc::NotOriented},
        {"one of two inside out", together(unit, insideOut(box(Vec3(2, 0, 0), Vec3(3, 1, 1)))),
         Errc::NotOriented},
        {"bigger one of two inside out",
         together(unit, insideOut(box(Vec3(2, 0, 0), Vec3(9, 1, 1)))), Errc::NotOriented},
        {"joined in a point", welded(unit, box(Vec3(1, 1, 1), Vec3(2, 2, 2)), {{6, 0}}),
         Errc::NotManifold},
        {"joined in an edge", welded(unit, box(Vec3(1, 1, 0), Vec3(2, 2, 1)), {{2, 0}, {6, 4}}),
         Errc::NotManifold},
        {"touching in a point", together(unit, box(Vec3(1, 1, 1), Vec3(2, 2, 2))),
         Errc::SelfIntersecting},
        {"touching in a face", together(unit, box(Vec3(1, 0, 0), Vec3(2, 1, 1))),
         Errc::SelfIntersecting},
        {"overlapping", together(unit, box(Vec3(0.5, 0.5, 0.5), Vec3(2, 2, 2))),
         Errc::SelfIntersecting},
        {"crossing outline", star, Errc::SelfIntersecting},
        {"point through the far side", withPoint(6, Vec3(-3, -3, -3)), Errc::NotPlanar},
        {"not planar", withPoint(6, Vec3(1.3, 1, 1)), Errc::NotPlanar},
        {"flat", box(Vec3::Zero(), Vec3(1, 1, 0)), Errc::NoVolume},
        {"a point only", box(Vec3::Ones(), Vec3::Ones()), Errc::NoVolume},
        {"too small", box(Vec3::Zero(), Vec3::Constant(1e-200)), Errc::NoVolume},
    };
}

TEST(Solid, BadBodiesAreRefusedWithTheirCode) {
    for (const Bad& bad : badBodies()) {
        SCOPED_TRACE(bad.name);
        const auto solid = Solid::fromSpec(bad.spec);
        ASSERT_FALSE(solid);
        EXPECT_EQ(errcName(solid.error().code), errcName(bad.code)) << solid.error().message;
        EXPECT_FALSE(solid.error().message.empty());
    }
}

TEST(Solid, MessagesNameTheFace) {
    const auto open = Solid::fromSpec(
        withFaces({{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}}));
    ASSERT_FALSE(open);
    EXPECT_EQ(open.error().message, "Face 0 has no neighbour along edge 0-3.");
    const auto bent = Solid::fromSpec(withPoint(6, Vec3(1.3, 1, 1)));
    ASSERT_FALSE(bent);
    EXPECT_NE(bent.error().message.find("Face 3"), std::string::npos) << bent.error().message;
}

}  // namespace
}  // namespace ew::test
