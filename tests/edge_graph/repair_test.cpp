// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edge_graph/repair.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "core/edge_graph/canonical.h"

namespace ew {
namespace {

constexpr double kThreshold = 14.0;
using Lines = std::vector<std::array<Vec2, 2>>;

const Vec2 kY(400, 400), kA(300, 340), kB(500, 350), kC(410, 520);

/// Hexagon outline and Y of a box; the first line runs from the middle to kA.
Lines boxLines() {
    const Vec2 ab = kA + kB - kY, bc = kB + kC - kY, ca = kC + kA - kY;
    return {{kY, kA}, {kY, kB}, {kY, kC}, {kA, ab}, {kB, ab},
            {kB, bc}, {kC, bc}, {kC, ca}, {kA, ca}};
}

InkReading inkOf(const Lines& lines) {
    std::vector<Stroke> strokes;
    for (const auto& l : lines) {
        Stroke s;
        for (int i = 0; i <= 20; ++i)
            s.samples.push_back({l[0] + (l[1] - l[0]) * i / 20.0, 1, 8.0 * i});
        strokes.push_back(std::move(s));
    }
    return readInk(strokes, kThreshold);
}

std::string codeOf(const EdgeGraph& g) {
    PlaneGraph p;
    for (const Junction& j : g.junctions) p.points.push_back(j.position);
    for (const GraphEdge& e : g.edges) p.edges.push_back(e.ends);
    return canonicalForm(p).code;
}

/// Repairs of the lines that end in a graph like the box's.
std::vector<RepairedGraph> boxesIn(const Lines& lines, double spreadPx) {
    const InkReading ink = inkOf(lines);
    RepairOptions o;
    o.distancePx = kThreshold;
    o.spreadPx = spreadPx;
    const std::string box = codeOf(buildEdgeGraph(inkOf(boxLines()), kThreshold));
    o.known = [&](const PlaneGraph& g) { return canonicalForm(g).code == box; };
    return repairedGraphs(ink, {draftEdgeGraph(ink, kThreshold)}, o);
}

TEST(RepairedGraphs, AGraphOfAKnownShapeCostsNothing) {
    const auto found = boxesIn(boxLines(), 2.0);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.front().price, 0.0);
    EXPECT_EQ(found.front().dropped, 0);
}

TEST(RepairedGraphs, ARoughHandsGapIsClosedAndASteadyHandsIsMeant) {
    Lines lines = boxLines();
    const Vec2 back = (kY - kA).normalized();
    lines[0][1] = kA + 19.0 * back;  // past the distance threshold
    const auto rough = boxesIn(lines, 6.0);
    ASSERT_FALSE(rough.empty());
    EXPECT_GT(rough.front().price, 0.0);
    EXPECT_EQ(rough.front().graph.edges.size(), 9u);
    EXPECT_TRUE(boxesIn(lines, 1.5).empty());
}

TEST(RepairedGraphs, AWiderGapIsDearer) {
    double last = 0.0;
    for (const double gap : {16.0, 18.0, 20.0}) {
        Lines lines = boxLines();
        lines[0][1] = kA + gap * (kY - kA).normalized();
        const auto found = boxesIn(lines, 6.0);
        ASSERT_FALSE(found.empty()) << gap;
        EXPECT_GT(found.front().price, last) << gap;
        last = found.front().price;
    }
}

TEST(RepairedGraphs, ALineBesideAnEdgeIsLeftOutForLessThanOneAcrossAFace) {
    Lines beside = boxLines();
    // A retrace that starts at the corner and strays too far to be taken for one.
    beside.push_back({kA, kA + (kC - kY) + Vec2(14, -4)});
    Lines across = boxLines();
    across.push_back({kA, kC});
    const auto cheap = boxesIn(beside, 6.0);
    const auto dear = boxesIn(across, 6.0);
    ASSERT_FALSE(cheap.empty());
    ASSERT_FALSE(dear.empty());
    EXPECT_LT(cheap.front().price, dear.front().price);
    EXPECT_EQ(dear.front().dropped, 1);
    EXPECT_GE(dear.front().price, 12.0);
}

TEST(RepairedGraphs, NothingIsForcedIntoAShapeThatIsFarAway) {
    const Lines square{{Vec2(100, 100), Vec2(300, 100)},
                       {Vec2(300, 100), Vec2(300, 300)},
                       {Vec2(300, 300), Vec2(100, 300)},
                       {Vec2(100, 300), Vec2(100, 100)}};
    EXPECT_TRUE(boxesIn(square, 7.0).empty());
}

}  // namespace
}  // namespace ew
