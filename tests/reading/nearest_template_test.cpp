// SPDX-License-Identifier: GPL-3.0-or-later
// Which lines a drawing has less and more than the nearest template.
#include "core/reading/explain/nearest_template.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/edge_graph/build.h"
#include "tests/reading/reading_fixture.h"

namespace ew {
namespace {

using test::boxStrokes;
using test::line;
using test::readStrokes;

const Vec3 kSize(60, 40, 30);

std::vector<Stroke> without(std::vector<Stroke> strokes, std::vector<std::size_t> gone) {
    std::sort(gone.rbegin(), gone.rend());
    for (const std::size_t i : gone) strokes.erase(strokes.begin() + static_cast<long>(i));
    return strokes;
}

/// Is this line, to a few px, among those that are missing?
bool tells(const std::vector<std::array<Vec2, 2>>& missing, const Stroke& wanted) {
    const Vec2 a = wanted.samples.front().position;
    const Vec2 b = wanted.samples.back().position;
    return std::any_of(missing.begin(), missing.end(), [&](const auto& edge) {
        const double straight = (edge[0] - a).norm() + (edge[1] - b).norm();
        const double turned = (edge[0] - b).norm() + (edge[1] - a).norm();
        return std::min(straight, turned) < 8.0;
    });
}

/// What a drawing has less and more than a box with three faces seen.
AspectDifference fromBox(const EdgeGraph& graph) {
    const auto cube = test::entryOf("cube");
    for (const Aspect& aspect : cube->aspects) {
        if (aspect.name == "explicit-3") return *compare(graph, *cube, aspect, 14.0);
    }
    return {};
}

TEST(Nearest, TellsWhichLinesOfABoxAreMissing) {
    const InterpretOptions options;
    const auto box = boxStrokes(options.camera, kSize, Vec3(-30, -20, 0));
    int told = 0;
    for (std::size_t a = 0; a < box.size(); ++a) {
        for (std::size_t b = a + 1; b < box.size(); ++b) {
            const auto r = readStrokes(without(box, {a, b}));
            // Lines that hang together with nothing closed are told as strays.
            if (r.graph.edges.size() + r.graph.dangling.size() != box.size() - 2) continue;
            const AspectDifference d = fromBox(r.graph);
            EXPECT_TRUE(d.extra.empty()) << a << " " << b;
            EXPECT_EQ(d.missing.size(), 2U) << a << " " << b;
            // Which ones follows where a corner is left that tells.
            told += tells(d.missing, box[a]) && tells(d.missing, box[b]) ? 1 : 0;
        }
    }
    EXPECT_GT(told, 10);
}

TEST(Nearest, TellsWhichLinesAreTooMany) {
    const InterpretOptions options;
    EdgeGraph graph = readStrokes(boxStrokes(options.camera, kSize, Vec3(-30, -20, 0))).graph;
    ASSERT_EQ(graph.edges.size(), 9U);
    const auto joined = [&](int a, int b) {
        return std::any_of(graph.edges.begin(), graph.edges.end(), [&](const GraphEdge& e) {
            return std::minmax(e.ends[0], e.ends[1]) == std::minmax(a, b);
        });
    };
    // Diagonals, put first so that their numbers are not the last ones.
    for (const auto& [a, b] : {std::pair{0, 3}, std::pair{1, 5}, std::pair{2, 6}, std::pair{0, 6},
                               std::pair{1, 4}, std::pair{2, 3}}) {
        if (joined(a, b) || graph.edges.size() == 11) continue;
        GraphEdge diagonal;
        diagonal.ends = {a, b};
        graph.edges.insert(graph.edges.begin(), diagonal);
    }
    ASSERT_EQ(graph.edges.size(), 11U);
    const AspectDifference d = fromBox(graph);
    EXPECT_TRUE(d.missing.empty());
    EXPECT_EQ(d.extra, (std::vector<int>{0, 1}));
}

TEST(Nearest, IsTheBoxThatMostLinesAreOf) {
    const InterpretOptions options;
    const auto box = boxStrokes(options.camera, kSize, Vec3(-30, -20, 0));
    // Closed is one face only; the other lines hang on to it.
    const auto r = readStrokes(without(box, {5, 7}));
    ASSERT_TRUE(r.nearest);
    EXPECT_EQ(r.nearest->templateId, "cube");
    EXPECT_EQ(r.nearest->missing.size(), 2U);
    EXPECT_TRUE(r.nearest->extra.empty());
    EXPECT_TRUE(tells(r.nearest->missing, box[5]));
    EXPECT_TRUE(tells(r.nearest->missing, box[7]));
}

TEST(Nearest, WhatAReadingTellsAddsUp) {
    const InterpretOptions options;
    const auto box = boxStrokes(options.camera, kSize, Vec3(-30, -20, 0));
    int seen = 0;
    for (std::size_t a = 0; a < box.size(); ++a) {
        for (std::size_t b = a + 1; b < box.size(); ++b) {
            const auto r = readStrokes(without(box, {a, b}));
            if (!r.nearest) continue;
            ++seen;
            const auto entry = test::entryOf(r.nearest->templateId);
            const auto aspect =
                std::find_if(entry->aspects.begin(), entry->aspects.end(),
                             [&](const Aspect& x) { return x.name == r.nearest->aspect; });
            ASSERT_NE(aspect, entry->aspects.end());
            const std::size_t laid = r.graph.edges.size() - r.nearest->extra.size();
            EXPECT_GT(r.nearest->missing.size() + r.nearest->extra.size(), 0U) << a << " " << b;
            EXPECT_LE(r.nearest->missing.size() + laid, aspect->graph.edges.size());
            EXPECT_GE(r.nearest->missing.size() + laid + r.graph.dangling.size(),
                      aspect->graph.edges.size());
        }
    }
    EXPECT_GT(seen, 10);
}

TEST(Nearest, CountsALineWithAnOpenEndAsDrawn) {
    const InterpretOptions options;
    auto strokes = boxStrokes(options.camera, kSize, Vec3(-30, -20, 0));
    // The upper edge at the back ends 40 px short of its corner.
    auto& tip = strokes[4].samples.back().position;
    const Vec2 start = strokes[4].samples.front().position;
    tip -= 40.0 * (tip - start).normalized();
    const auto r = readStrokes(strokes);
    ASSERT_TRUE(r.problem);
    ASSERT_EQ(r.graph.openEnds.size(), 1U);
    ASSERT_TRUE(r.nearest);
    EXPECT_EQ(r.nearest->templateId, "cube");
    EXPECT_TRUE(r.nearest->missing.empty());
    EXPECT_TRUE(r.nearest->extra.empty());
}

/// Each template, drawn as it is seen from somewhere with any two lines left out, differs from that
/// aspect by these two lines or fewer, and from the whole drawing by none.
TEST(Nearest, DiffersByNoMoreThanWasLeftOut) {
    for (const char* id : {"cube", "l-prism", "triangular-prism", "wedge-frustum"}) {
        const auto& byId = test::shippedLibrary().index().byId;
        if (!byId.contains(id)) continue;
        const auto entry = test::entryOf(id);
        for (const Aspect& aspect : entry->aspects) {
            const auto count = aspect.graph.edges.size();
            for (std::size_t a = 0; a < count; ++a) {
                const std::size_t b = (a + 1 + a % 3) % count;
                EdgeGraph graph;
                for (const Vec2& p : aspect.graph.points) graph.junctions.push_back({300.0 * p});
                for (std::size_t e = 0; e < count; ++e) {
                    if (e == a || e == b) continue;
                    GraphEdge edge;
                    edge.ends = aspect.graph.edges[e];
                    graph.edges.push_back(edge);
                }
                const auto d = compare(graph, *entry, aspect, 14.0);
                ASSERT_TRUE(d);
                EXPECT_LE(d->missing.size(), 2U) << id << " " << aspect.name << " " << a;
                EXPECT_EQ(d->missing.size(), 2U + d->extra.size());
            }
        }
    }
}

}  // namespace
}  // namespace ew
