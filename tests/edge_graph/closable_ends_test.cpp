// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edge_graph/closable_ends.h"

#include <gtest/gtest.h>

#include "core/edge_graph/build.h"
#include "core/edge_graph/open_ends.h"

namespace ew {
namespace {

/// Lines that are joined to nothing yet.
EdgeGraph loose(const std::vector<std::array<Vec2, 2>>& lines) {
    EdgeGraph graph;
    for (const auto& ends : lines) {
        DanglingEdge d;
        d.ends = ends;
        graph.dangling.push_back(d);
    }
    findOpenEnds(graph, 14.0);
    EXPECT_FALSE(graph.openEnds.empty());
    return graph;
}

TEST(ClosableEnds, TwoLinesEncloseNothing) {
    EXPECT_TRUE(
        closableEnds(loose({{Vec2(600, 300), Vec2(600, 450)}, {Vec2(640, 300), Vec2(760, 260)}}))
            .empty());
    // Nor side by side.
    EXPECT_TRUE(
        closableEnds(loose({{Vec2(100, 100), Vec2(300, 100)}, {Vec2(100, 125), Vec2(300, 125)}}))
            .empty());
}

TEST(ClosableEnds, AChainOfLinesEnclosesNothing) {
    EXPECT_TRUE(closableEnds(loose({{Vec2(100, 100), Vec2(300, 100)},
                                    {Vec2(325, 110), Vec2(325, 300)},
                                    {Vec2(350, 310), Vec2(600, 310)}}))
                    .empty());
}

TEST(ClosableEnds, ATriangleWithGapsHasOneForEachGap) {
    const auto ends = closableEnds(loose({{Vec2(110, 100), Vec2(390, 100)},
                                          {Vec2(400, 120), Vec2(260, 380)},
                                          {Vec2(240, 380), Vec2(100, 120)},
                                          {Vec2(600, 600), Vec2(800, 600)},
                                          {Vec2(820, 610), Vec2(820, 800)}}));
    EXPECT_EQ(ends.size(), 3U);
    for (const OpenEnd& o : ends) EXPECT_LT(o.edge, 3);
}

TEST(ClosableEnds, ALineThatEndsBeforeWhatHasRegionsIsOne) {
    EdgeGraph graph;
    graph.junctions.resize(2);
    graph.junctions[0].position = Vec2(100, 100);
    graph.junctions[1].position = Vec2(300, 100);
    GraphEdge edge;
    edge.ends = {0, 1};
    graph.edges.push_back(edge);
    DanglingEdge d;
    d.junction = 0;
    d.ends = {Vec2(100, 100), Vec2(275, 110)};
    graph.dangling.push_back(d);
    findOpenEnds(graph, 14.0);
    ASSERT_FALSE(graph.openEnds.empty());
    EXPECT_EQ(closableEnds(graph).size(), 1U);
}

}  // namespace
}  // namespace ew
