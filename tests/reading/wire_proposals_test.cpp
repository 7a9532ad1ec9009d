// SPDX-License-Identifier: GPL-3.0-or-later
// The stages by which a drawing with its hidden lines becomes a solid: faces of a graph, corners in
// space, faces between wires.
#include "core/reading/propose/wire_proposals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/edge_graph/wire_graph.h"
#include "core/reading/extract/wire_drawing.h"
#include "core/reading/solve/wire_faces.h"
#include "core/reading/solve/wire_lift.h"
#include "core/solid/boolean.h"
#include "core/solid/solid.h"
#include "core/solid/visibility.h"
#include "tests/support/hand_model.h"
#include "tests/support/modification_shapes.h"

namespace ew::test {
namespace {

constexpr double kSpread = 0.5;

Solid boxOf(const Vec3& low, const Vec3& high) { return solidOf(boxSpec(low, high)); }
Solid joined(const Solid& a, const Solid& b) { return combine(a, b, BooleanKind::Add)->solid; }
Solid lessOf(const Solid& a, const Solid& b) { return combine(a, b, BooleanKind::Cut)->solid; }

Solid block() { return boxOf({0, 0, 0}, {100, 80, 40}); }
/// A smaller block in the middle of its upper face.
Solid blockWithBoss() { return joined(block(), boxOf({30, 25, 40}, {70, 55, 70})); }

struct Drawn {
    OrthographicCamera camera;
    EdgeGraph graph;
};

/// All edges, each as one line.
Drawn drawn(const Solid& solid) {
    Drawn out;
    out.camera.direction = Vec3(-1.0, 0.47, -0.62).normalized();
    out.camera.center = Vec3(50, 40, 30);
    const auto view = SolidView::make(solid, Pose{}, out.camera);
    std::vector<Line2> lines;
    for (const SolidEdge& e : solid.edges()) {
        const auto end = [&](std::size_t k) -> const Vec2& {
            return view->points()[static_cast<std::size_t>(e.ends[k])];
        };
        lines.push_back({end(0), end(1)});
    }
    Random random(5);
    const auto graphs = buildWireGraphs(readInk(drawByHand(lines, kExactHand, random), 4.0), 4.0);
    if (!graphs.empty()) out.graph = graphs.front();
    return out;
}

std::optional<AxisFrame> frameOf(const LineDrawing& wires) {
    const auto frames = axisFrames(wires, kSpread, 2);
    if (frames.empty()) return std::nullopt;
    return frames.front();
}

TEST(WireDrawing, FacesOfABlockAreThoseOfItsGraph) {
    const auto wires = wireDrawing(drawn(block()).graph);
    ASSERT_TRUE(wires);
    ASSERT_EQ(wires->regions.size(), 6U);
    for (const LineDrawing::Region& face : wires->regions) EXPECT_EQ(face.loop.size(), 4U);
    for (std::size_t d = 0; d < wires->left.size(); ++d) {
        EXPECT_GE(wires->left[d], 0);
        EXPECT_NE(wires->left[d], wires->left[d ^ 1U]);
    }
}

TEST(WireDrawing, APartThatCouldBeTurnedOverLeavesTheFacesOpen) {
    // What hangs on two corners only, or on none, has more than one embedding.
    const auto wires = wireDrawing(drawn(blockWithBoss()).graph);
    ASSERT_TRUE(wires);
    EXPECT_TRUE(wires->regions.empty());
}

TEST(WireDrawing, ACornerOfTwoLinesIsNone) {
    Drawn d = drawn(block());
    ASSERT_TRUE(wireDrawing(d.graph));
    d.graph.edges.pop_back();
    EXPECT_FALSE(wireDrawing(d.graph));
    EXPECT_FALSE(wireDrawing(EdgeGraph{}));
}

/// Distances of all corners from one another do not depend on where the solid lies.
std::vector<double> distances(const std::vector<Vec3>& points) {
    std::vector<double> out;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t k = i + 1; k < points.size(); ++k) {
            out.push_back((points[i] - points[k]).norm());
        }
    }
    std::sort(out.begin(), out.end());
    return out;
}

TEST(WireLift, CornersComeToLieWhereTheyAre) {
    for (const Solid& solid : {block(), blockWithBoss()}) {
        const Drawn d = drawn(solid);
        const auto wires = wireDrawing(d.graph);
        ASSERT_TRUE(wires);
        const auto frame = frameOf(*wires);
        ASSERT_TRUE(frame);
        const auto lifts = liftWires(*wires, *frame, kSpread);
        ASSERT_FALSE(lifts.empty());
        std::vector<Vec3> truth;
        for (const Vec3& v : solid.vertices()) truth.push_back(v / d.camera.worldPerPixel);
        const auto found = distances(lifts.front().points);
        const auto wanted = distances(truth);
        ASSERT_EQ(found.size(), wanted.size());
        for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], wanted[i], 0.1);
    }
}

TEST(WireLift, WithoutALineAlongAnAxisThereIsNone) {
    const auto wires = wireDrawing(drawn(block()).graph);
    ASSERT_TRUE(wires);
    AxisFrame frame = *frameOf(*wires);
    std::fill(frame.axisOf.begin(), frame.axisOf.end(), -1);
    EXPECT_TRUE(liftWires(*wires, frame, kSpread).empty());
}

TEST(WireFaces, HolesBossesAndTunnelsHaveTheirFaces) {
    const Solid tunnel = lessOf(block(), boxOf({30, 25, -1}, {70, 55, 41}));
    const Solid notch = lessOf(block(), boxOf({60, -1, 20}, {101, 30, 41}));
    const Solid flush = joined(block(), boxOf({60, 20, 40}, {100, 80, 60}));
    for (const Solid& solid : {block(), blockWithBoss(), tunnel, notch, flush}) {
        const auto wires = wireDrawing(drawn(solid).graph);
        ASSERT_TRUE(wires);
        const auto frame = frameOf(*wires);
        ASSERT_TRUE(frame);
        bool right = false;
        for (const WireLift& lift : liftWires(*wires, *frame, kSpread)) {
            for (const auto& faces : wireFaces(*wires, *frame, lift, kSpread)) {
                std::size_t loops = 0;
                std::size_t truth = 0;
                for (const WireFace& f : faces) loops += f.loops.size();
                for (const SolidFace& f : solid.faces()) truth += f.loops.size();
                right = right || (faces.size() == solid.faces().size() && loops == truth);
            }
        }
        EXPECT_TRUE(right) << solid.faces().size();
    }
}

TEST(WireProposals, TheSolidIsAmongThem) {
    const Solid solid = blockWithBoss();
    const Drawn d = drawn(solid);
    const auto wires = wireDrawing(d.graph);
    ASSERT_TRUE(wires);
    const auto proposals = wireProposals(*wires, *frameOf(*wires), kSpread);
    const double scale = std::pow(d.camera.worldPerPixel, 3);
    const bool found =
        std::any_of(proposals.begin(), proposals.end(), [&](const ShapeHypothesis& h) {
            const auto made = Solid::fromSpec(h.rough);
            return made && std::abs(made->volume() * scale / solid.volume() - 1.0) < 0.01;
        });
    EXPECT_TRUE(found);
}

TEST(WireProposals, UprightLinesTellAboveFromBelow) {
    const auto wires = wireDrawing(drawn(block()).graph);
    ASSERT_TRUE(wires);
    const auto frames = axisFrames(*wires, kSpread, 2);
    ASSERT_EQ(frames.size(), 2U);  // and the same in a mirror
    const auto above = wireProposals(*wires, frames[0], kSpread);
    const auto below = wireProposals(*wires, frames[1], kSpread);
    ASSERT_FALSE(above.empty());
    ASSERT_FALSE(below.empty());
    EXPECT_DOUBLE_EQ(seenFromBelow(above.front()), 0.0);
    EXPECT_DOUBLE_EQ(seenFromBelow(below.front()), 1.0);
}

}  // namespace
}  // namespace ew::test
