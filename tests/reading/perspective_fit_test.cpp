// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/perspective_fit.h"

#include <gtest/gtest.h>

#include "core/edge_graph/build.h"
#include "core/tlib/matcher.h"
#include "tests/reading/reading_fixture.h"
#include "tests/support/line_changes.h"

namespace ew {
namespace {

/// The sighting of a drawing of a box.
Sighting boxSighting(const std::vector<Stroke>& strokes, TemplateAnalysis& analysis) {
    const EdgeGraph graph = buildEdgeGraph(readInk(strokes, 14.0), 14.0);
    MatchOptions options;
    options.templateId = "cube";
    const auto matches = matchGraph(graph, test::shippedLibrary().index(), options);
    if (matches.empty()) return {};
    analysis = matches.front().entry->analysis;
    Sighting sighting = sightingOf(graph, matches.front(), 14.0);
    sighting.doubt = 0.0;  // an exact drawing
    return sighting;
}

TEST(PerspectiveFit, AnExactPerspectiveBoxComesBack) {
    int fitted = 0;
    for (std::uint64_t i = 0; i < 12; ++i) {
        test::Random random(test::Random::mix(5, i));
        const test::SketchCase sketch = test::randomSketch("cube", random);
        const auto lines = test::linesInPerspective(sketch, 4.0);
        TemplateAnalysis analysis;
        const Sighting sighting = boxSighting(test::ruledStrokes(lines), analysis);
        if (sighting.edges.size() != 9) continue;
        const auto picture = fitAffine(sighting, analysis);
        ASSERT_TRUE(picture);
        auto depths = cornerDepths(picture->axes);
        if (!depths) continue;
        // One of the two Necker roots is the box.
        double best = 1e9;
        std::array<Vec3, 3> axes;
        for (int root = 0; root < 2; ++root) {
            for (double& d : *depths) d = -d;
            const auto seen = fitPerspective(sighting, analysis, *picture, *depths);
            if (!seen) continue;
            double off = 0;
            for (const DrawnEdge& d : sighting.edges) {
                for (std::size_t end = 0; end < 2; ++end) {
                    const Vec3 p =
                        seen->at(*analysis.rectilinear, static_cast<std::size_t>(d.vertex[end]));
                    off = std::max(off, (p.head<2>() - d.tips[end]).norm());
                }
            }
            if (off < best) {
                best = off;
                axes = seen->axes;
                EXPECT_GT(seen->kappa, 0.0);
            }
        }
        ASSERT_LT(best, 0.5) << i;
        ++fitted;
        for (std::size_t a = 0; a < 3; ++a) {
            const Vec3& u = axes[a];
            const Vec3& v = axes[(a + 1) % 3];
            EXPECT_NEAR(u.normalized().dot(v.normalized()), 0.0, 1e-9);
        }
        // Proportions as drawn.
        std::array<double, 3> have{};
        for (std::size_t a = 0; a < 3; ++a) have[a] = axes[a].norm();
        std::array<double, 3> want{};
        const auto& v = sketch.spec.vertices;
        want = {(v[1] - v[0]).norm(), (v[3] - v[0]).norm(), (v[4] - v[0]).norm()};
        std::sort(have.begin(), have.end());
        std::sort(want.begin(), want.end());
        EXPECT_NEAR(have[0] / have[2], want[0] / want[2], 0.02) << i;
        EXPECT_NEAR(have[1] / have[2], want[1] / want[2], 0.02) << i;
    }
    EXPECT_GE(fitted, 8);
}

}  // namespace
}  // namespace ew
