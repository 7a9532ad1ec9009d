// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edge_graph/build.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/edge_graph/canonical.h"
#include "core/edge_graph/edit.h"
#include "tests/edge_graph/ink_of_lines.h"
#include "tests/support/random.h"

namespace ew {
namespace {

constexpr double kThreshold = 14.0;
using test::Lines;
using test::strokesOf;

/// Hexagon outline and Y of a box.
Lines boxLines() {
    const Vec2 y(400, 400), a(300, 340), b(500, 350), c(410, 520);
    const Vec2 ab = a + b - y, bc = b + c - y, ca = c + a - y;
    return {{y, a}, {y, b}, {y, c}, {a, ab}, {b, ab}, {b, bc}, {c, bc}, {c, ca}, {a, ca}};
}

EdgeGraph graphOf(const Lines& lines) {
    return buildEdgeGraph(readInk(strokesOf(lines), kThreshold), kThreshold);
}

std::string codeOf(const EdgeGraph& g) {
    PlaneGraph p;
    for (const Junction& j : g.junctions) p.points.push_back(j.position);
    for (const GraphEdge& e : g.edges) p.edges.push_back(e.ends);
    return canonicalForm(p).code;
}

TEST(BuildEdgeGraph, AnExactBoxHasExactJunctions) {
    const EdgeGraph g = graphOf(boxLines());
    EXPECT_EQ(g.junctions.size(), 7u);
    EXPECT_EQ(g.edges.size(), 9u);
    EXPECT_TRUE(g.noise.empty());
    const bool found = std::any_of(g.junctions.begin(), g.junctions.end(), [](const Junction& j) {
        return (j.position - Vec2(400, 400)).norm() < 1e-9;
    });
    EXPECT_TRUE(found);
}

/// Samples along a polyline that sway by so much to both sides.
Stroke swaying(const std::vector<Vec2>& corners, double byPx) {
    Stroke s;
    double along = 0;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        const Vec2 d = corners[i + 1] - corners[i];
        const Vec2 aside = Vec2(-d.y(), d.x()).normalized();
        for (double t = 0; t < d.norm(); t += 1.5, along += 1.5) {
            s.samples.push_back(
                {corners[i] + t * d.normalized() + byPx * std::sin(along / 11.0) * aside, 1,
                 8.0 * along});
        }
    }
    s.samples.push_back({corners.back(), 1, 8.0 * along});
    return s;
}

// A leg of 28 px that turns by 36 degrees into a line three times as long.
TEST(ReadInk, AShortEdgesCornerIsFoundWhereTheHandIsKnown) {
    const std::vector<Vec2> bent{{532, 406}, {550, 385}, {629, 366}};
    const std::vector<Stroke> strokes{swaying({{767, 322}, {634, 358}}, 1.7), swaying(bent, 1.7),
                                      swaying({{527, 408}, {519, 343}}, 1.7),
                                      swaying({{515, 338}, {730, 284}}, 1.7)};
    const InkReading ink = readInk(strokes, kThreshold);
    ASSERT_EQ(ink.segments.size(), 5u);
    EXPECT_EQ(ink.segments[1].stroke, 1);
    EXPECT_EQ(ink.segments[2].stroke, 1);
    EXPECT_LT((ink.segments[2].a - bent[1]).norm(), 6.5);
}

TEST(BuildEdgeGraph, EndsWithinTheThresholdMeetAndOthersDoNot) {
    for (const double gap : {4.0, 9.0, 13.0}) {
        Lines lines = boxLines();
        const Vec2 d = (lines[3][1] - lines[3][0]).normalized();
        lines[3][1] -= gap * d;
        EXPECT_EQ(graphOf(lines).edges.size(), 9u) << gap;
    }
    Lines lines = boxLines();
    const Vec2 d = (lines[3][1] - lines[3][0]).normalized();
    lines[3][1] -= 19.0 * d;
    const EdgeGraph g = graphOf(lines);
    EXPECT_LT(g.edges.size(), 9u);
    ASSERT_FALSE(g.openEnds.empty());
    const bool told = std::any_of(g.openEnds.begin(), g.openEnds.end(), [&](const OpenEnd& o) {
        return (o.tip - lines[3][1]).norm() < 1e-6 && std::abs(o.gapPx - 19.0) < 0.1;
    });
    EXPECT_TRUE(told);
}

TEST(BuildEdgeGraph, OvershootIsTrimmed) {
    Lines lines = boxLines();
    for (auto& l : lines) {
        const Vec2 d = (l[1] - l[0]).normalized();
        l[0] -= 10 * d;
        l[1] += 11 * d;
    }
    const EdgeGraph g = graphOf(lines);
    EXPECT_EQ(g.junctions.size(), 7u);
    EXPECT_EQ(g.edges.size(), 9u);
}

TEST(BuildEdgeGraph, StrayLinesDotsAndBridgesAreDroppedAndListed) {
    Lines lines = boxLines();
    lines.push_back({Vec2(700, 100), Vec2(800, 140)});
    lines.push_back({Vec2(100, 600), Vec2(102, 601)});
    const EdgeGraph g = graphOf(lines);
    EXPECT_EQ(g.edges.size(), 9u);
    auto has = [&](NoiseKind kind, int stroke) {
        return std::any_of(g.noise.begin(), g.noise.end(), [&](const NoiseItem& n) {
            return n.kind == kind && n.stroke == stroke;
        });
    };
    EXPECT_TRUE(has(NoiseKind::Stray, 9));
    EXPECT_TRUE(has(NoiseKind::Dot, 10));
}

TEST(BuildEdgeGraph, ALineThatEndsOnAnotherMakesATJunction) {
    // A square with a bar across: both ends stop 5 px short of the sides.
    const Lines lines{{Vec2(100, 100), Vec2(300, 100)},
                      {Vec2(300, 100), Vec2(300, 300)},
                      {Vec2(300, 300), Vec2(100, 300)},
                      {Vec2(100, 300), Vec2(100, 100)},
                      {Vec2(105, 180), Vec2(295, 220)}};
    const EdgeGraph g = graphOf(lines);
    EXPECT_EQ(g.junctions.size(), 6u);
    EXPECT_EQ(g.edges.size(), 7u);
}

TEST(BuildEdgeGraph, OvertracedAndBrokenEdgesAreOneEdge) {
    Lines lines = boxLines();
    lines.push_back({lines[0][0] + Vec2(1, 3), lines[0][1] + Vec2(-2, 3)});
    const Vec2 a = lines[3][0], b = lines[3][1];
    lines[3] = {a, a + 0.48 * (b - a)};
    lines.push_back({a + 0.53 * (b - a) + Vec2(1, -1), b});
    const EdgeGraph g = graphOf(lines);
    EXPECT_EQ(g.junctions.size(), 7u);
    EXPECT_EQ(g.edges.size(), 9u);
}

TEST(BuildEdgeGraph, TwoDrawingsAreTwoParts) {
    Lines lines = boxLines();
    for (const auto& l : boxLines()) lines.push_back({l[0] + Vec2(400, 0), l[1] + Vec2(400, 0)});
    EXPECT_EQ(connectedParts(graphOf(lines)).size(), 2u);
}

TEST(WithoutEdges, TakingASpokeOfABoxLeavesTwoFaces) {
    const EdgeGraph g = graphOf(boxLines());
    int spoke = -1;
    for (std::size_t e = 0; e < g.edges.size(); ++e) {
        for (const int j : g.edges[e].ends) {
            if ((g.junctions[static_cast<std::size_t>(j)].position - Vec2(400, 400)).norm() <
                1e-6) {
                spoke = static_cast<int>(e);
            }
        }
    }
    ASSERT_GE(spoke, 0);
    const EdgeGraph less = withoutEdges(g, {spoke});
    EXPECT_EQ(less.edges.size(), 8u);
    EXPECT_EQ(less.junctions.size(), 7u);
}

RC_GTEST_PROP(BuildEdgeGraph, OrderAndDirectionOfStrokesDoNotMatter, ()) {
    test::Random random(*rc::gen::inRange<std::uint64_t>(0, 1u << 20));
    Lines lines = boxLines();
    for (auto& l : lines) {
        l[0] += random.inDisc(4);
        l[1] += random.inDisc(4);
    }
    const EdgeGraph before = graphOf(lines);
    random.shuffle(lines);
    for (auto& l : lines) {
        if (random.chance(0.5)) std::swap(l[0], l[1]);
    }
    const EdgeGraph after = graphOf(lines);
    RC_ASSERT(codeOf(before) == codeOf(after));
    for (const Junction& j : before.junctions) {
        const bool same =
            std::any_of(after.junctions.begin(), after.junctions.end(),
                        [&](const Junction& k) { return (j.position - k.position).norm() < 1e-6; });
        RC_ASSERT(same);
    }
}

}  // namespace
}  // namespace ew
