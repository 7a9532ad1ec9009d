// SPDX-License-Identifier: GPL-3.0-or-later
// The stages by which a drawing without a template becomes a solid: axes, planes of faces, planes
// behind, cells, surface.
#include "core/reading/propose/polyhedron_proposals.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/edge_graph/build.h"
#include "core/edge_graph/edit.h"
#include "core/reading/solve/cell_labels.h"
#include "core/reading/solve/cell_solid.h"
#include "core/reading/solve/closing_planes.h"
#include "core/reading/solve/part_depths.h"
#include "core/reading/solve/simple_pieces.h"
#include "core/solid/boolean.h"
#include "core/solid/solid.h"
#include "tests/support/hand_model.h"
#include "tests/support/modification_shapes.h"
#include "tests/support/whole_shapes.h"

namespace ew::test {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Solid boxOf(const Vec3& low, const Vec3& high) { return solidOf(boxSpec(low, high)); }

Solid joined(const Solid& a, const Solid& b) { return combine(a, b, BooleanKind::Add)->solid; }
Solid lessOf(const Solid& a, const Solid& b) { return combine(a, b, BooleanKind::Cut)->solid; }

/// A block with a smaller one in the middle of its upper face.
Solid blockWithBoss() {
    return joined(boxOf({0, 0, 0}, {100, 80, 40}), boxOf({30, 25, 40}, {70, 55, 70}));
}

struct Drawn {
    WholeCase drawing;
    EdgeGraph graph;
    LineDrawing lines;
};

Drawn drawn(const Solid& solid, const Vec3& direction = Vec3(-1.0, 0.6, -0.7)) {
    OrthographicCamera camera;
    camera.direction = direction.normalized();
    camera.center = Vec3(50, 40, 30);
    Drawn out{wholeCase(solid, camera), {}, {}};
    Random random(5);
    const InkReading ink = readInk(drawByHand(out.drawing.lines, kExactHand, random), 4.0);
    out.graph = buildEdgeGraph(ink, 4.0);
    out.lines = lineDrawing(out.graph, 8.0);
    return out;
}

/// The axes of the world in camera space, in any order and with any sense.
double worstAxisDeg(const AxisFrame& frame, const OrthographicCamera& camera) {
    const Mat3 toCamera = camera.cameraToWorld().transpose();
    double worst = 0.0;
    for (int k = 0; k < 3; ++k) {
        double best = 0.0;
        for (int j = 0; j < 3; ++j) {
            best = std::max(best, std::abs(frame.axes.col(j).dot(toCamera.col(k))));
        }
        worst = std::max(worst, std::acos(std::min(1.0, best)) * 180.0 / M_PI);
    }
    return worst;
}

TEST(AxisFrames, TheAxesOfABlockAreFoundAndSeenFromAbove) {
    const Drawn d = drawn(blockWithBoss());
    const auto frames = axisFrames(d.lines, 0.5, 4);
    ASSERT_EQ(frames.size(), 2U);  // and the same in a mirror
    EXPECT_LT(worstAxisDeg(frames[0], d.drawing.camera), 0.1);
    EXPECT_GT(worstAxisDeg(frames[1], d.drawing.camera), 20.0);
    EXPECT_DOUBLE_EQ(frames[0].share, 1.0);
    EXPECT_NEAR(frames[0].axes.determinant(), 1.0, 1e-9);
    for (const int axis : frames[0].axisOf) EXPECT_GE(axis, 0);
}

TEST(AxisFrames, TwoDirectionsAreNoFrame) {
    EdgeGraph square;
    square.junctions = {{{0, 0}}, {{100, 10}}, {{90, 110}}, {{-10, 100}}};
    for (const auto& e : {std::array<int, 2>{0, 1}, {1, 2}, {2, 3}, {3, 0}}) {
        GraphEdge edge;
        edge.ends = e;
        square.edges.push_back(edge);
    }
    EXPECT_TRUE(axisFrames(lineDrawing(square, 8.0), 1.0, 6).empty());
}

TEST(FaceLift, FacesLieAsDeepAsTheyDo) {
    const Drawn d = drawn(blockWithBoss());
    ASSERT_EQ(d.lines.regions.size(), 6U);
    const AxisFrame frame = axisFrames(d.lines, 0.1, 1).front();
    const auto lifts = liftFaces(d.lines, frame, 0.1);
    ASSERT_FALSE(lifts.empty());
    const FaceLift& lift = lifts.front();
    EXPECT_EQ(lift.parts, 1);  // the boss stands on the block: edges that are seen join them
    EXPECT_LT(lift.worstPx, 0.1);
    // Depths between corners of one face are those of the solid.
    const Mat3 toCamera = d.drawing.camera.cameraToWorld().transpose();
    for (std::size_t r = 0; r < lift.faces.size(); ++r) {
        double best = 0.0;
        for (int k = 0; k < 3; ++k) {
            best = std::max(best, std::abs(toCamera.col(k).dot(lift.faces[r].normal)));
        }
        EXPECT_GT(best, 0.99999);
        EXPECT_LT(lift.faces[r].normal.z(), 0.0);
    }
}

TEST(FaceLift, WhatIsHiddenBehindABarIsNotJoined) {
    // A tower behind a lower block, some way off: only the block's upper edge is before it.
    const Drawn d =
        drawn(joined(boxOf({0, 0, 0}, {100, 40, 40}),
                     joined(boxOf({0, 40, 0}, {100, 90, 10}), boxOf({20, 70, 10}, {60, 90, 110}))),
              Vec3(-0.6, 1.0, -0.35));
    const auto frames = axisFrames(d.lines, 0.5, 1);
    ASSERT_FALSE(frames.empty());
    const auto lifts = liftFaces(d.lines, frames.front(), 0.5);
    ASSERT_FALSE(lifts.empty());
    const FaceLift& lift = lifts.front();
    for (std::size_t e = 0; e < lift.lines.size(); ++e) {
        const int a = d.lines.left[2 * e];
        const int b = d.lines.left[2 * e + 1];
        if (a >= 0 && b >= 0) continue;
        EXPECT_FALSE(lift.lines[e].shared);  // the outline has one face only
        EXPECT_EQ(lift.lines[e].front, std::max(a, b));
    }
    EXPECT_GE(lift.parts, 1);
}

TEST(LineDrawing, AnIslandIsAHoleOfTheRegionRoundIt) {
    const Drawn d =
        drawn(lessOf(boxOf({0, 0, 0}, {100, 80, 40}), boxOf({30, 25, 25}, {70, 55, 40})),
              Vec3(-1.0, 0.7, -1.6));
    const auto holed = std::count_if(d.lines.regions.begin(), d.lines.regions.end(),
                                     [](const auto& r) { return r.holes.size() == 1; });
    EXPECT_EQ(holed, 1);
    EXPECT_EQ(std::count(d.lines.left.begin(), d.lines.left.end(), -1), 6);  // the outline
}

TEST(JoinedParts, IsTheInverseOfConnectedParts) {
    const Drawn d =
        drawn(joined(boxOf({0, 0, 0}, {40, 40, 40}), boxOf({90, -40, 0}, {130, 0, 30})));
    const auto parts = connectedParts(d.graph);
    ASSERT_EQ(parts.size(), 2U);
    const EdgeGraph again = joinedParts(parts);
    EXPECT_EQ(again.edges.size(), d.graph.edges.size());
    EXPECT_EQ(again.junctions.size(), d.graph.junctions.size());
    double before = 0.0;
    double after = 0.0;
    for (const GraphEdge& e : d.graph.edges) before += (e.tips[1] - e.tips[0]).norm();
    for (const GraphEdge& e : again.edges) {
        after += (again.junctions[at(e.ends[1])].position - again.junctions[at(e.ends[0])].position)
                     .norm();
    }
    EXPECT_NEAR(before, after, 1.0);
    EXPECT_EQ(connectedParts(again).size(), 2U);
}

TEST(ClosingPlanes, ABoxIsClosedByThreePlanesBehind) {
    const Drawn d = drawn(boxOf({0, 0, 0}, {100, 80, 60}));
    const AxisFrame frame = axisFrames(d.lines, 0.5, 1).front();
    const auto lifts = liftFaces(d.lines, frame, 0.5);
    ASSERT_FALSE(lifts.empty());
    const FaceLift& lift = lifts.front();
    const SolidPlanes found = solidPlanes(d.lines, frame, lift, 0.5);
    EXPECT_EQ(found.directions.size(), 3U);
    std::vector<std::pair<int, int>> behind;  // direction and rounded offset
    for (const SolidPlane& p : found.planes) {
        if (p.region >= 0) continue;
        const std::pair<int, int> key{p.direction, static_cast<int>(std::lround(p.offset / 2.0))};
        if (std::find(behind.begin(), behind.end(), key) == behind.end()) behind.push_back(key);
    }
    EXPECT_EQ(behind.size(), 3U);
}

TEST(PartDepths, TwoBoxesStandOnOneGround) {
    const Drawn d =
        drawn(joined(boxOf({0, 0, 0}, {40, 40, 40}), boxOf({70, -10, 0}, {110, 30, 30})));
    const AxisFrame frame = axisFrames(d.lines, 0.5, 1).front();
    const auto lifts = liftFaces(d.lines, frame, 0.5);
    ASSERT_FALSE(lifts.empty());
    const FaceLift& lift = lifts.front();
    ASSERT_EQ(lift.parts, 2);
    const SolidPlanes planes = solidPlanes(d.lines, frame, lift, 0.5);
    const auto depths = partDepths(d.lines, lift, planes, 0.5);
    ASSERT_FALSE(depths.empty());
    EXPECT_DOUBLE_EQ(depths.front().less, 0.0);
    for (const PartDepths& depth : depths) {
        EXPECT_EQ(depth.shifts.size(), 2U);
        EXPECT_GE(depth.less, 0.0);
    }
}

TEST(CellComplex, PlanesCutAllCellsThatTheyMeet) {
    CellComplex complex(Vec3::Zero(), Vec3::Constant(10.0));
    EXPECT_EQ(complex.cellCount(), 1);
    ASSERT_TRUE(complex.cut({Vec3::UnitX(), 4.0}, 1e-6));
    ASSERT_TRUE(complex.cut({Vec3::UnitY(), 5.0}, 1e-6));
    ASSERT_TRUE(complex.cut({Vec3::UnitZ(), 6.0}, 1e-6));
    EXPECT_EQ(complex.cellCount(), 8);
    // A slanted plane through the crossing cuts six of the eight.
    ASSERT_TRUE(complex.cut({Vec3(1, 1, 1).normalized(), 15.0 / std::sqrt(3.0)}, 1e-6));
    EXPECT_EQ(complex.cellCount(), 14);
    EXPECT_GE(complex.cellAt(0), 0);
    EXPECT_FALSE(complex.isPositive(complex.cellAt(0), 3));
    // A facet between two cells is one facet; every one has area.
    for (std::size_t f = 0; f < complex.facets().size(); ++f) {
        EXPECT_GT(complex.area(static_cast<int>(f)), 0.0);
        const auto& cells = complex.facets()[f].cells;
        EXPECT_EQ(complex.facets()[f].plane < 0, cells[0] < 0 || cells[1] < 0);
    }
}

TEST(CellComplex, APlaneOnACellFaceCutsNothing) {
    CellComplex complex(Vec3::Zero(), Vec3::Constant(10.0));
    ASSERT_TRUE(complex.cut({Vec3::UnitX(), 4.0}, 1e-6));
    ASSERT_TRUE(complex.cut({Vec3::UnitX(), 4.0}, 1e-6));
    EXPECT_EQ(complex.cellCount(), 2);
}

TEST(CellComplex, TooManyPlanesAreRefused) {
    CellComplex complex(Vec3::Zero(), Vec3::Constant(100.0));
    for (int k = 0; k < CellComplex::kMostPlanes; ++k) {
        ASSERT_TRUE(complex.cut({Vec3::UnitX(), 1.0 + k}, 1e-6));
    }
    EXPECT_FALSE(complex.cut({Vec3::UnitX(), 99.0}, 1e-6));
}

/// 3 x 3 x 3 cubes of 10, and a layer of cells round them.
CellComplex cubes() {
    CellComplex complex(Vec3::Constant(-10.0), Vec3::Constant(40.0));
    for (int k = 0; k < 3; ++k) {
        for (const double at : {0.0, 10.0, 20.0, 30.0}) complex.cut({Vec3::Unit(k), at}, 1e-6);
    }
    return complex;
}

std::uint64_t sidesOf(int x, int y, int z) {
    // Planes in the order of cubes(); cube n is beyond n + 1 of the four of its axis.
    const auto bits = [](int n) { return (std::uint64_t{2} << static_cast<unsigned>(n)) - 1U; };
    return bits(x) | bits(y) << 4U | bits(z) << 8U;
}

TEST(CellSolid, FacetsOfOnePlaneAreOneFace) {
    const CellComplex complex = cubes();
    std::vector<bool> solid(at(complex.cellCount()), false);
    solid[at(complex.cellAt(sidesOf(1, 1, 1)))] = true;
    auto made = cellSolid(complex, solid);
    ASSERT_TRUE(made);
    EXPECT_EQ(made->faces.size(), 6U);
    EXPECT_EQ(made->vertices.size(), 8U);
    solid[at(complex.cellAt(sidesOf(2, 1, 1)))] = true;
    made = cellSolid(complex, solid);
    ASSERT_TRUE(made);
    EXPECT_EQ(made->faces.size(), 6U);
    EXPECT_EQ(made->vertices.size(), 8U);
    // An L, and two cubes that share an edge only.
    solid[at(complex.cellAt(sidesOf(1, 2, 1)))] = true;
    made = cellSolid(complex, solid);
    ASSERT_TRUE(made);
    EXPECT_EQ(made->faces.size(), 8U);
    solid[at(complex.cellAt(sidesOf(1, 1, 1)))] = false;
    EXPECT_FALSE(cellSolid(complex, solid));
    EXPECT_FALSE(cellSolid(complex, std::vector<bool>(solid.size(), false)));
}

TEST(CellSolid, FacesAreCounterClockwiseFromOutside) {
    const CellComplex complex = cubes();
    std::vector<bool> solid(at(complex.cellCount()), false);
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}}) {
        solid[at(complex.cellAt(sidesOf(x, y, 1)))] = true;
    }
    const auto made = cellSolid(complex, solid);
    ASSERT_TRUE(made);
    PolyhedronSpec spec;
    spec.vertices = made->vertices;
    for (const auto& f : made->faces) spec.faces.push_back(f.loops.front());
    const auto body = Solid::fromSpec(spec);
    ASSERT_TRUE(body) << body.error().message;
    EXPECT_NEAR(body->volume(), 3000.0, 1e-6);
}

TEST(CellLabels, WhatIsNotSeenIsFilledTheSimplestWay) {
    const CellComplex complex = cubes();
    // All but a corner is seen to be solid, and all round them to be empty.
    std::vector<CellVotes> votes(at(complex.cellCount()));
    for (CellVotes& v : votes) v.empty = 100.0;
    for (int n = 0; n < 27; ++n) {
        CellVotes& v = votes[at(complex.cellAt(sidesOf(n % 3, n / 3 % 3, n / 9)))];
        v = {};
        if (n != 26) v.solid = 100.0;
    }
    const auto labels = cellLabels(complex, votes);
    ASSERT_FALSE(labels.empty());
    const bool whole = std::any_of(labels.begin(), labels.end(), [](const auto& solid) {
        return std::count(solid.begin(), solid.end(), true) == 27;
    });
    EXPECT_TRUE(whole);
    for (const auto& solid : labels) EXPECT_GE(std::count(solid.begin(), solid.end(), true), 26);
}

TEST(SimplePieces, AFaceWithoutHolesStaysAsItIs) {
    const std::vector<Vec3> square{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
    EXPECT_EQ(simplePieces(square, {{0, 1, 2, 3}}), (std::vector<std::vector<int>>{{0, 1, 2, 3}}));
}

double areaOf(const std::vector<Vec3>& points, const std::vector<int>& loop) {
    double sum = 0.0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Vec3& a = points[at(loop[k])];
        const Vec3& b = points[at(loop[(k + 1) % loop.size()])];
        sum += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    return sum;
}

TEST(SimplePieces, HolesAreCutOpen) {
    std::vector<Vec3> points{{0, 0, 0}, {100, 0, 0}, {100, 100, 0}, {0, 100, 0}};
    std::vector<std::vector<int>> loops{{0, 1, 2, 3}};
    for (const auto& [x, y] : {std::pair{20.0, 20.0}, {60.0, 30.0}, {30.0, 65.0}}) {
        const int first = static_cast<int>(points.size());
        for (const auto& [dx, dy] : {std::pair{0, 0}, {0, 15}, {15, 15}, {15, 0}}) {
            points.emplace_back(x + dx, y + dy, 0.0);
        }
        loops.push_back({first, first + 1, first + 2, first + 3});
    }
    const auto pieces = simplePieces(points, loops);
    ASSERT_EQ(pieces.size(), 4U);
    double sum = 0.0;
    for (const auto& piece : pieces) {
        EXPECT_GT(areaOf(points, piece), 0.0);
        sum += areaOf(points, piece);
    }
    EXPECT_NEAR(sum, 10000.0 - 3 * 225.0, 1e-9);
}

TEST(PolyhedronProposals, OneIsTheSolidThatWasDrawn) {
    const Solid solids[] = {
        blockWithBoss(),
        lessOf(boxOf({0, 0, 0}, {100, 80, 40}), boxOf({30, -1, 20}, {60, 50, 41})),
        joined(boxOf({0, 0, 0}, {100, 40, 30}),
               joined(boxOf({0, 0, 30}, {30, 40, 60}), boxOf({60, 0, 30}, {100, 20, 80}))),
    };
    for (const Solid& solid : solids) {
        const Drawn d = drawn(solid);
        const double px = d.drawing.camera.worldPerPixel;
        bool found = false;
        for (const AxisFrame& frame : axisFrames(d.lines, 0.5, 2)) {
            for (const ShapeHypothesis& h : polyhedronProposals(d.lines, frame, 0.5)) {
                PolyhedronSpec spec = h.rough;
                for (Vec3& v : spec.vertices) v *= px;
                const auto made = Solid::fromSpec(spec);
                if (!made || made->faces().size() != solid.faces().size()) continue;
                found = found || std::abs(made->volume() / solid.volume() - 1.0) < 0.01;
            }
        }
        EXPECT_TRUE(found) << solid.faces().size();
    }
}

}  // namespace
}  // namespace ew::test
