// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edge_graph/guide_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/edge_graph/ink_of_lines.h"

namespace ew {
namespace {

constexpr double kDistance = 8.0;
using test::Lines;

InkReading inkOf(const Lines& lines) { return test::inkOf(lines, kDistance); }

/// The nine edges of a box that are seen.
Lines box() {
    const Vec2 front(400, 300);
    const Vec2 a(-90, -60);
    const Vec2 b(120, -50);
    const Vec2 c(8, 130);
    const auto edge = [](const Vec2& p, const Vec2& d) {
        return std::array<Vec2, 2>{p, Vec2(p + d)};
    };
    return {edge(front, a),     edge(front, b),     edge(front, c),
            edge(front + a, b), edge(front + b, a), edge(front + a, c),
            edge(front + c, a), edge(front + b, c), edge(front + c, b)};
}

/// Each line goes on by so much [px] before its start and behind its end.
Lines past(const Lines& lines, double before, double after) {
    Lines out;
    for (const auto& l : lines) {
        const Vec2 d = (l[1] - l[0]).normalized();
        out.push_back({Vec2(l[0] - before * d), Vec2(l[1] + after * d)});
    }
    return out;
}

/// Every segment is one of the lines, and every line has one.
void expectLines(const InkReading& ink, const Lines& lines, double nearPx) {
    ASSERT_EQ(ink.segments.size(), lines.size());
    for (const auto& l : lines) {
        const bool found =
            std::any_of(ink.segments.begin(), ink.segments.end(), [&](const Segment& s) {
                return std::max((s.a - l[0]).norm(), (s.b - l[1]).norm()) < nearPx ||
                       std::max((s.a - l[1]).norm(), (s.b - l[0]).norm()) < nearPx;
            });
        EXPECT_TRUE(found) << l[0].transpose() << " to " << l[1].transpose();
    }
}

TEST(GuideLines, EdgesOfABoxAreWhatLiesBetweenTheCorners) {
    const auto ways = trimGuideLines(inkOf(past(box(), 40, 55)), kDistance, 4);
    ASSERT_FALSE(ways.empty());
    expectLines(ways.front().ink, box(), 1e-6);
    EXPECT_TRUE(ways.front().dropped.empty());
    EXPECT_EQ(ways.front().tails.size(), 18U);
    EXPECT_TRUE(std::is_sorted(ways.begin(), ways.end(),
                               [](const auto& a, const auto& b) { return a.cost < b.cost; }));
}

TEST(GuideLines, TheOrderOfLinesDoesNotMatter) {
    Lines lines = past(box(), 35, 35);
    std::rotate(lines.begin(), lines.begin() + 4, lines.end());
    for (auto& l : lines) std::swap(l[0], l[1]);
    const auto ways = trimGuideLines(inkOf(lines), kDistance, 1);
    ASSERT_EQ(ways.size(), 1U);
    expectLines(ways.front().ink, box(), 1e-6);
}

TEST(GuideLines, ADrawingWithoutThemHasNoWays) {
    EXPECT_TRUE(trimGuideLines(inkOf(box()), kDistance, 4).empty());
    EXPECT_TRUE(trimGuideLines(inkOf(past(box(), 3, 3)), kDistance, 4).empty());
    EXPECT_TRUE(trimGuideLines(inkOf({}), kDistance, 4).empty());
}

TEST(GuideLines, HiddenEdgesAreNone) {
    Lines all = box();
    const Vec2 back = Vec2(400, 300) + Vec2(-90, -60) + Vec2(120, -50) + Vec2(8, 130);
    for (const Vec2& d : {Vec2(90, 60), Vec2(-120, 50), Vec2(-8, -130)}) {
        all.push_back({back, Vec2(back + d)});
    }
    EXPECT_TRUE(trimGuideLines(inkOf(all), kDistance, 4).empty());
}

TEST(GuideLines, ALineInTwoStrokesIsOne) {
    Lines lines = past(box(), 40, 40);
    const auto whole = lines.front();
    const Vec2 middle = 0.5 * (whole[0] + whole[1]);
    lines.front() = {whole[0], middle};
    lines.push_back({middle, whole[1]});
    const auto ways = trimGuideLines(inkOf(lines), kDistance, 1);
    ASSERT_EQ(ways.size(), 1U);
    EXPECT_EQ(ways.front().ink.segments.size(), 10U);
    EXPECT_TRUE(ways.front().dropped.empty());
}

TEST(GuideLines, TwoEdgesInLineStayTwo) {
    // The tops of both legs of a U, whose guide lines lie on one another in part.
    const Lines u{{Vec2(100, 100), Vec2(180, 100)}, {Vec2(180, 100), Vec2(180, 220)},
                  {Vec2(180, 220), Vec2(300, 220)}, {Vec2(300, 220), Vec2(300, 100)},
                  {Vec2(300, 100), Vec2(380, 100)}, {Vec2(380, 100), Vec2(380, 300)},
                  {Vec2(380, 300), Vec2(100, 300)}, {Vec2(100, 300), Vec2(100, 100)}};
    const auto ways = trimGuideLines(inkOf(past(u, 70, 70)), kDistance, 1);
    ASSERT_EQ(ways.size(), 1U);
    expectLines(ways.front().ink, u, 1e-6);
}

TEST(GuideLines, ALineThroughTheDrawingMayBeLeftOut) {
    Lines lines = past(box(), 40, 40);
    lines.push_back({Vec2(340, 150), Vec2(455, 500)});
    const auto ways = trimGuideLines(inkOf(lines), kDistance, 12);
    const auto without = std::find_if(ways.begin(), ways.end(), [](const TrimmedInk& way) {
        return way.dropped == std::vector<int>{9};
    });
    ASSERT_NE(without, ways.end());
    expectLines(without->ink, box(), 1e-6);
}

}  // namespace
}  // namespace ew
