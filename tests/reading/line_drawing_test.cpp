// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/extract/line_drawing.h"

#include <gtest/gtest.h>

namespace ew::test {
namespace {

EdgeGraph graphOf(const std::vector<Vec2>& points, const std::vector<std::array<int, 2>>& edges) {
    EdgeGraph graph;
    for (const Vec2& p : points) graph.junctions.push_back({p});
    for (const auto& e : edges) {
        GraphEdge edge;
        edge.ends = e;
        graph.edges.push_back(edge);
    }
    return graph;
}

/// A square, and behind it what is seen of a larger one: lines end on the right side.
EdgeGraph squareBeforeAnother() {
    return graphOf(
        {{0, 0}, {100, 0}, {100, 100}, {0, 100}, {100, 30}, {180, 30}, {180, 70}, {100, 70}},
        {{0, 1}, {1, 4}, {4, 7}, {7, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}});
}

TEST(LineDrawing, RegionsAreTheFacesThatAreSeen) {
    const LineDrawing drawing = lineDrawing(squareBeforeAnother(), 8.0);
    ASSERT_EQ(drawing.regions.size(), 2U);
    const bool squareFirst = drawing.regions[0].areaPx > drawing.regions[1].areaPx;
    const auto& square = drawing.regions[squareFirst ? 0 : 1];
    const auto& other = drawing.regions[squareFirst ? 1 : 0];
    EXPECT_DOUBLE_EQ(square.areaPx, 10000.0);
    EXPECT_EQ(square.corners.size(), 4U);  // the side goes straight on where others end at it
    EXPECT_FALSE(square.partly);
    EXPECT_DOUBLE_EQ(other.areaPx, 3200.0);
    EXPECT_TRUE(other.partly);
    EXPECT_EQ(drawing.outline.size(), 8U);
}

TEST(LineDrawing, ALineThatEndsAtAStraightOneIsAStem) {
    const LineDrawing drawing = lineDrawing(squareBeforeAnother(), 8.0);
    for (const int node : {4, 7}) {
        ASSERT_TRUE(drawing.isT(node)) << node;
        const int far = drawing.to(drawing.nodes[static_cast<std::size_t>(node)].stem);
        EXPECT_TRUE(far == 5 || far == 6) << node;
    }
    for (const int node : {0, 1, 2, 3, 5, 6}) EXPECT_FALSE(drawing.isT(node)) << node;
}

TEST(LineDrawing, ABendMakesACornerOfABar) {
    EdgeGraph graph = squareBeforeAnother();
    graph.junctions[4].position.x() = 125.0;
    const LineDrawing drawing = lineDrawing(graph, 8.0);
    EXPECT_FALSE(drawing.isT(4));
}

TEST(LineDrawing, EveryDirectedEdgeIsOnOneLoop) {
    const LineDrawing drawing = lineDrawing(squareBeforeAnother(), 8.0);
    std::size_t count = drawing.outline.size();
    for (std::size_t r = 0; r < drawing.regions.size(); ++r) {
        for (const int d : drawing.regions[r].loop) {
            EXPECT_EQ(drawing.left[static_cast<std::size_t>(d)], static_cast<int>(r));
        }
        count += drawing.regions[r].loop.size();
    }
    EXPECT_EQ(count, drawing.from.size());
}

}  // namespace
}  // namespace ew::test
