// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/explain/convergence.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/reading/reading_fixture.h"
#include "tests/support/line_changes.h"
#include "tests/support/sketch_generator.h"

namespace ew {
namespace {

constexpr double kSpreadPx = 2.0;

/// A graph of lines whose ends meet where they are equal.
EdgeGraph graphOf(const std::vector<test::Line2>& lines) {
    EdgeGraph graph;
    const auto junction = [&](const Vec2& p) {
        for (std::size_t i = 0; i < graph.junctions.size(); ++i) {
            if ((graph.junctions[i].position - p).norm() < 1e-6) return static_cast<int>(i);
        }
        graph.junctions.emplace_back();
        graph.junctions.back().position = p;
        return static_cast<int>(graph.junctions.size()) - 1;
    };
    for (const test::Line2& l : lines) {
        GraphEdge e;
        e.ends = {junction(l[0]), junction(l[1])};
        graph.edges.push_back(e);
    }
    return graph;
}

/// Where a point is seen from above, turned by 35 degrees, from so far away; 0: in parallel.
Vec2 seen(const Vec3& p, double eye) {
    const double c = std::cos(0.6);
    const double s = std::sin(0.6);
    const Vec3 turned(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z());
    const Vec3 tilted(turned.x(), 0.5 * turned.y() - 0.87 * turned.z(),
                      0.87 * turned.y() + 0.5 * turned.z());
    const double shrink = eye > 0.0 ? eye / (eye - tilted.z()) : 1.0;
    return {640 + shrink * tilted.x(), 400 + shrink * tilted.y()};
}

/// What stands upright over a polygon. The first corners are the near ones, whose sides are seen.
/// \param taper  its top is smaller by this share.
std::vector<test::Line2> uprightLines(const std::vector<Vec2>& base, std::size_t sides, double eye,
                                      double taper = 0.0) {
    const auto at = [&](std::size_t k, double z) {
        const Vec2 p = (z > 0.0 ? 1.0 - taper : 1.0) * base[k % base.size()];
        return seen(Vec3(p.x(), p.y(), z), eye);
    };
    std::vector<test::Line2> out;
    for (std::size_t k = 0; k < base.size(); ++k) out.push_back({at(k, 60), at(k + 1, 60)});
    for (std::size_t k = 0; k <= sides; ++k) out.push_back({at(k, 60), at(k, -60)});
    for (std::size_t k = 0; k < sides; ++k) out.push_back({at(k, -60), at(k + 1, -60)});
    return out;
}

std::vector<test::Line2> boxLines(double eye, double taper = 0.0) {
    return uprightLines({{100, -75}, {100, 75}, {-100, 75}, {-100, -75}}, 2, eye, taper);
}

TEST(Convergence, LinesOfABoxFromNearConverge) {
    const auto found = findConvergence(graphOf(boxLines(400.0)), kSpreadPx);
    ASSERT_TRUE(found);
    EXPECT_GT(found->degrees, 10.0);
    for (const Vec2& p : found->where) EXPECT_LT((p - Vec2(640, 400)).norm(), 250.0);
}

TEST(Convergence, ParallelLinesDoNot) {
    EXPECT_FALSE(findConvergence(graphOf(boxLines(0.0)), kSpreadPx));
    EXPECT_FALSE(findConvergence(graphOf(boxLines(20000.0)), kSpreadPx));
}

TEST(Convergence, SidesThatTaperAreNoPerspective) {
    EXPECT_FALSE(findConvergence(graphOf(boxLines(0.0, 0.5)), kSpreadPx));
}

TEST(Convergence, NeitherDoLinesThatMissWhereTheyMeet) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        test::Random random(seed);
        const auto lines = test::withMovedCorners(boxLines(0.0), kSpreadPx, random);
        EXPECT_FALSE(findConvergence(graphOf(lines), kSpreadPx)) << seed;
    }
}

/// Prisms over other polygons are not read in perspective; that is told.
TEST(Convergence, IsTheReasonWhyAPrismInPerspectiveIsNotRead) {
    const std::vector<Vec2> stairs{{120, -80}, {120, -20}, {60, -20},  {60, 40},
                                   {0, 40},    {0, 90},    {-100, 90}, {-100, -80}};
    const Interpretation parallel =
        test::readStrokes(test::ruledStrokes(uprightLines(stairs, 6, 0.0)));
    EXPECT_TRUE(parallel.accepted);
    const Interpretation r = test::readStrokes(test::ruledStrokes(uprightLines(stairs, 6, 500.0)));
    ASSERT_FALSE(r.accepted);
    EXPECT_EQ(r.problem->code, Errc::Perspective) << r.problem->message;
    EXPECT_EQ(r.problem->where.size(), 2U);
}

/// A drawing that is none is never said to be in perspective, however it was spoilt.
TEST(Convergence, IsNotTheReasonOfOtherFaults) {
    test::Random random(3);
    for (int n = 0; n < 10; ++n) {
        const auto sketch = test::randomSketch("cube", random, nullptr);
        std::vector<test::Line2> lines = sketch.drawing.lines();
        lines.erase(lines.begin() + n % 3);
        InterpretOptions options;
        options.camera = sketch.camera;
        const Interpretation r = interpret(test::drawByHand(lines, test::kNormalHand, random, {}),
                                           test::shippedLibrary(), options);
        if (r.problem) EXPECT_NE(r.problem->code, Errc::Perspective) << n;
    }
}

}  // namespace
}  // namespace ew
