// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edge_graph/wire_graph.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/edge_graph/ink_of_lines.h"

namespace ew {
namespace {

constexpr double kDistance = 8.0;
using test::Lines;

InkReading inkOf(const Lines& lines) { return test::inkOf(lines, kDistance); }

std::vector<EdgeGraph> wiresOf(const Lines& lines) {
    return buildWireGraphs(inkOf(lines), kDistance);
}

/// All twelve edges of a box; `b` goes to the right, `c` down, `a` to the back.
struct Box {
    Vec2 at{400, 300}, a{-90, -60}, b{120, -50}, c{8, 130};

    Vec2 corner(int i) const { return at + (i & 1) * a + (i >> 1 & 1) * b + (i >> 2 & 1) * c; }
    Lines lines() const {
        Lines out;
        for (int i = 0; i < 8; ++i) {
            for (const int bit : {1, 2, 4}) {
                if ((i & bit) == 0) out.push_back({corner(i), corner(i | bit)});
            }
        }
        return out;
    }
};

void expectBox(const EdgeGraph& g) {
    EXPECT_EQ(g.junctions.size(), 8U);
    EXPECT_EQ(g.edges.size(), 12U);
    std::vector<int> degree(g.junctions.size(), 0);
    for (const GraphEdge& e : g.edges) {
        for (const int end : e.ends) ++degree[static_cast<std::size_t>(end)];
    }
    EXPECT_TRUE(std::all_of(degree.begin(), degree.end(), [](int d) { return d == 3; }));
}

TEST(WireGraph, LinesThatCrossDoNotMeet) {
    const auto graphs = wiresOf(Box{}.lines());
    ASSERT_EQ(graphs.size(), 1U);
    expectBox(graphs.front());
    for (const Junction& j : graphs.front().junctions) {
        double off = 1e9;
        for (int i = 0; i < 8; ++i) off = std::min(off, (Box{}.corner(i) - j.position).norm());
        EXPECT_LT(off, 1e-9);
    }
}

TEST(WireGraph, AnEdgeDrawnInPiecesIsOneEdge) {
    Lines lines = Box{}.lines();
    for (const std::size_t k : {0U, 5U}) {
        const Vec2 middle = 0.4 * lines[k][0] + 0.6 * lines[k][1];
        lines.push_back({middle, lines[k][1]});
        lines[k][1] = middle;
    }
    const auto graphs = wiresOf(lines);
    ASSERT_FALSE(graphs.empty());
    expectBox(graphs.front());
}

TEST(WireGraph, TwoLinesInPiecesThatMeetWhereTheyCrossPassEachOther) {
    Lines lines = Box{}.lines();
    // Two edges that cross in the picture, each in two pieces.
    const auto crossing = [&](std::size_t i, std::size_t k) -> std::optional<Vec2> {
        const Vec2 p = lines[i][0], d = lines[i][1] - p, q = lines[k][0], e = lines[k][1] - q;
        const double det = cross2(d, e);
        if (std::abs(det) < 1.0) return std::nullopt;
        const double s = cross2(q - p, e) / det;
        const double t = cross2(q - p, d) / det;
        if (s < 0.2 || s > 0.8 || t < 0.2 || t > 0.8) return std::nullopt;
        return Vec2(p + s * d);
    };
    for (std::size_t i = 0; i < 12; ++i) {
        for (std::size_t k = i + 1; k < 12; ++k) {
            const auto at = crossing(i, k);
            if (!at) continue;
            for (const std::size_t line : {i, k}) {
                lines.push_back({*at, lines[line][1]});
                lines[line][1] = *at;
            }
            const auto graphs = wiresOf(lines);
            ASSERT_FALSE(graphs.empty());
            expectBox(graphs.front());
            return;
        }
    }
    FAIL() << "no two edges cross";
}

TEST(WireGraph, ALineThatAnotherCoversIsThereAllTheSame) {
    // Two upright edges come to lie on one another: one stroke shows both.
    Box box;
    box.a = Vec2(-90, -60);
    box.b = Vec2(90, -50);
    box.c = Vec2(0, 300);
    Lines lines = box.lines();
    // 0-4 runs from y 300 to 600, 3-7 at the same x from 190 to 490.
    std::erase_if(lines, [&](const auto& l) { return l[0].x() == 400.0 && l[1].x() == 400.0; });
    lines.push_back({box.corner(3), box.corner(4)});
    const auto graphs = wiresOf(lines);
    ASSERT_FALSE(graphs.empty());
    bool box8 = false;
    for (const EdgeGraph& g : graphs) box8 = box8 || g.edges.size() == 12U;
    EXPECT_TRUE(box8);
}

TEST(WireGraph, LinesThatLieOnOneAnotherAreReadAsTheyWereDrawnFirst) {
    Box box;
    box.b = Vec2(90, -50);
    box.c = Vec2(0, 300);
    const auto graphs = wiresOf(box.lines());
    ASSERT_FALSE(graphs.empty());
    expectBox(graphs.front());
}

TEST(WireGraph, ScribblesAndNothingMakeNone) {
    EXPECT_TRUE(buildWireGraphs(InkReading{}, kDistance).front().empty());
    for (const EdgeGraph& g : wiresOf({{Vec2(0, 0), Vec2(100, 0)}, {Vec2(50, 40), Vec2(60, 90)}})) {
        EXPECT_TRUE(g.empty());
    }
}

TEST(WireGraph, HiddenEdgesCrossAndDetailsHardlyDo) {
    const auto crosses = [](const Lines& lines) {
        return crossesLikeWires(inkOf(lines), kDistance);
    };
    // Two boxes into each other, as a boss through a plate.
    Lines two = Box{}.lines();
    Box other;
    other.at = {420, 320};
    for (const auto& l : other.lines()) two.push_back(l);
    EXPECT_TRUE(crosses(two));
    // What is seen of a box, with a window of four panes on one face.
    Lines seen;
    const Lines box = Box{}.lines();
    for (const auto& l : box) {
        const Vec2 back = Box{}.corner(7);
        if ((l[0] - back).norm() > 1e-9 && (l[1] - back).norm() > 1e-9) seen.push_back(l);
    }
    const Vec2 b = Box{}.b / 4;
    const Vec2 c = Box{}.c / 4;
    const Vec2 w = Box{}.at + b + c;
    for (const Lines& more : {Lines{{w, w + 2 * b},
                                    {w + 2 * b, w + 2 * b + 2 * c},
                                    {w + 2 * b + 2 * c, w + 2 * c},
                                    {w + 2 * c, w}},
                              Lines{{w + b, w + b + 2 * c}, {w + c, w + c + 2 * b}}}) {
        seen.insert(seen.end(), more.begin(), more.end());
        EXPECT_FALSE(crosses(seen));
    }
    // Ends that go too far are no crossings.
    Lines over = box;
    for (auto& l : over) {
        const Vec2 d = (l[1] - l[0]).normalized() * kDistance;
        l = {l[0] - d, l[1] + d};
    }
    over.resize(9);
    EXPECT_FALSE(crosses(over));
}

}  // namespace
}  // namespace ew
