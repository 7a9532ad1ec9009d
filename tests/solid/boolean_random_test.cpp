// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/solid/boolean.h"
#include "core/solid/exact_tool.h"
#include "tests/solid/boolean_fixture.h"
#include "tests/solid/shapes.h"
#include "tests/support/random.h"

namespace ew::test {
namespace {

constexpr std::array<BooleanKind, 3> kKinds{BooleanKind::Add, BooleanKind::Cut,
                                            BooleanKind::Intersect};

RC_GTEST_PROP(BooleanChain, RandomBoxesAgainstVoxels, ()) {
    Random random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1 << 30)));
    std::vector<BoxStep> steps{{{{2, 2, 2}, {9, 9, 9}}, BooleanKind::Add}};
    for (int i = 0; i < 12; ++i) {
        BoxStep step;
        for (std::size_t k = 0; k < 3; ++k) {
            step.box.low[k] = random.index(10);
            step.box.high[k] = step.box.low[k] + 1 + random.index(11 - step.box.low[k]);
        }
        // Common parts end a chain early, so they come seldom.
        step.kind = random.chance(0.05) ? BooleanKind::Intersect
                                        : kKinds[static_cast<std::size_t>(random.index(2))];
        steps.push_back(step);
    }
    const auto& rotations = cubeRotations();
    checkSteps(steps, rotations[static_cast<std::size_t>(random.index(24))]);
    RC_ASSERT(!::testing::Test::HasFatalFailure());
}

// 200 modifications in a row
// ---------------------------------------------------------------------------------------

/// A frame on a face: origin on it, x along an edge, z outwards.
struct FaceFrame {
    int face = -1;
    int edge = -1;  ///< of the solid, along x
    Mat3 axes;
    Vec3 origin;
    double room = 0.0;  ///< length of the edge
};

FaceFrame randomFrame(const Solid& solid, Random& random) {
    FaceFrame frame;
    frame.edge = random.index(static_cast<int>(solid.edges().size()));
    const SolidEdge& edge = solid.edges()[static_cast<std::size_t>(frame.edge)];
    frame.face = edge.faces[0];
    const SolidFace& face = solid.faces()[static_cast<std::size_t>(frame.face)];
    const Vec3 a = solid.vertices()[static_cast<std::size_t>(edge.ends[0])];
    const Vec3 b = solid.vertices()[static_cast<std::size_t>(edge.ends[1])];
    frame.room = (b - a).norm();
    frame.axes.col(0) = (b - a).normalized();
    frame.axes.col(2) = face.normal;
    frame.axes.col(1) = face.normal.cross(frame.axes.col(0));  // into the face
    frame.origin = a;
    return frame;
}

/// A box, wedge or pyramid on or in a face, its base in the face's plane exactly and, by chance, a
/// side along the face's edge, a corner on a vertex.
ToolSpec randomTool(const Solid& solid, bool inward, Random& random) {
    const FaceFrame frame = randomFrame(solid, random);
    const double width = std::min(frame.room, 25.0) * random.uniform(0.2, 0.6);
    const double depth = random.uniform(3.0, 12.0);
    const double height = (inward ? -1.0 : 1.0) * random.uniform(2.0, 9.0);
    const bool atCorner = random.chance(0.3);
    const bool atEdge = atCorner || random.chance(0.4);
    const double x = atCorner ? 0.0 : frame.room * random.uniform(0.1, 0.4);
    const double y = atEdge ? 0.0 : random.uniform(1.0, 4.0);
    ToolSpec spec;
    const int kind = random.index(3);
    if (kind == 0) {
        spec.shape = box(Vec3(0, 0, 0), Vec3(width, depth, std::abs(height)));
    } else if (kind == 1) {
        spec.shape.vertices = {{0, 0, 0},
                               {width, 0, 0},
                               {width, depth, 0},
                               {0, depth, 0},
                               {0, 0, std::abs(height)},
                               {width, 0, std::abs(height)}};
        spec.shape.faces = {{0, 3, 2, 1}, {0, 1, 5, 4}, {4, 5, 2, 3}, {0, 4, 3}, {1, 2, 5}};
    } else {
        spec.shape.vertices = {{0, 0, 0},
                               {width, 0, 0},
                               {width, depth, 0},
                               {0, depth, 0},
                               {0.4 * width, 0.5 * depth, std::abs(height)}};
        spec.shape.faces = {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    }
    for (Vec3& p : spec.shape.vertices) {
        const Vec3 local(x + p.x(), y + p.y(), height < 0 ? -p.z() : p.z());
        p = frame.origin + frame.axes * local;
    }
    if (height < 0) {
        for (auto& face : spec.shape.faces) std::reverse(face.begin(), face.end());
    }
    spec.faces.push_back({0, ToolFaceRule::Kind::InFace, frame.face});
    if (kind < 2) {
        // The uprights along the face's normal, the front along its edge, all exactly.
        spec.edges.push_back({{0, 4}, ToolEdgeRule::Kind::AlongNormal, frame.face});
        spec.edges.push_back({{1, 5}, ToolEdgeRule::Kind::AlongNormal, frame.face});
        spec.edges.push_back({{0, 1}, ToolEdgeRule::Kind::AlongEdge, frame.edge});
        spec.edges.push_back({{2, 3}, ToolEdgeRule::Kind::AlongEdge, frame.edge});
    }
    const SolidEdge& edge = solid.edges()[static_cast<std::size_t>(frame.edge)];
    if (atCorner) {
        spec.vertices.push_back({0, ToolVertexRule::Kind::AtVertex, edge.ends[0], -1, 0.0});
    } else if (atEdge) {
        spec.vertices.push_back({0, ToolVertexRule::Kind::OnEdge, frame.edge, -1, 0.0});
    }
    if (atEdge) spec.vertices.push_back({1, ToolVertexRule::Kind::OnEdge, frame.edge, -1, 0.0});
    return spec;
}

bool isRefusal(Errc code) {
    return code == Errc::NoChange || code == Errc::NothingLeft || code == Errc::TouchesInEdge ||
           code == Errc::TouchesInPoint || code == Errc::Sliver || code == Errc::TooLarge;
}

struct Chain {
    std::vector<Solid> states;
    std::vector<Solid> tools;
    std::vector<BooleanKind> kinds;
};

/// The volumes of union, difference and common part belong together.
void checkVolume(const Solid& target, const Solid& tool, BooleanKind kind, const Solid& result) {
    const auto common = combine(target, tool, BooleanKind::Intersect);
    // A common part that touches itself says nothing; without any, nothing is shared.
    if (!common && common.error().code != Errc::NothingLeft) return;
    const double shared = common ? common->solid.volume() : 0.0;
    const double change = kind == BooleanKind::Cut ? -shared : tool.volume() - shared;
    const double expected = target.volume() + change;
    EXPECT_NEAR(result.volume(), expected, 1e-9 * expected);
}

/// Adds and cuts in turns so that the solid neither vanishes nor fills everything.
Chain randomChain(const PolyhedronSpec& start, int length, Random& random) {
    Chain chain;
    chain.states.push_back(*Solid::fromSpec(start));
    int attempts = 0;
    while (static_cast<int>(chain.tools.size()) < length && attempts < 6 * length) {
        ++attempts;
        const Solid& solid = chain.states.back();
        const bool cut = random.chance(0.5);
        const auto tool = makeTool(solid, randomTool(solid, cut, random));
        if (!tool) {
            EXPECT_NE(errcName(tool.error().code), "internal") << tool.error().message;
            EXPECT_NE(errcName(tool.error().code), "contradiction") << tool.error().message;
            continue;
        }
        const auto kind = cut ? BooleanKind::Cut : BooleanKind::Add;
        const auto out = combine(solid, *tool, kind);
        if (!out) {
            EXPECT_TRUE(isRefusal(out.error().code))
                << errcName(out.error().code) << " " << out.error().message;
            continue;
        }
        checkVolume(solid, *tool, kind, out->solid);
        chain.states.push_back(out->solid);
        chain.tools.push_back(*tool);
        chain.kinds.push_back(kind);
        if (chain.tools.size() % 50 == 0) checkWholeGate(out->solid);
    }
    return chain;
}

TEST(BooleanChain, TwoHundredModificationsStayValidAndRedoToTheBit) {
    Random random(2024);
    const Chain chain = randomChain(box(Vec3(0, 0, 0), Vec3(150, 120, 90)), 200, random);
    ASSERT_EQ(chain.tools.size(), 200U);
    // Numbers stay short although every part hangs on slanted earlier ones.
    std::istringstream text(chain.states.back().serialize());
    for (std::string word; text >> word;) ASSERT_LT(word.size(), 2000U);
    Solid again = chain.states.front();
    for (std::size_t i = 0; i < chain.tools.size(); ++i) {
        const auto out = combine(again, chain.tools[i], chain.kinds[i]);
        ASSERT_TRUE(out) << i;
        ASSERT_TRUE(out->solid.identicalTo(chain.states[i + 1])) << i;
        again = out->solid;
    }
}

RC_GTEST_PROP(BooleanChain, RandomModificationsStayValid, ()) {
    Random random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1 << 30)));
    const Chain chain = randomChain(
        moved(box(Vec3(0, 0, 0), Vec3(60, 40, 30)), 0.4, 1.0, Vec3(1, 2, 3)), 4, random);
    checkWholeGate(chain.states.back());
    RC_ASSERT(!::testing::Test::HasFailure());
}

}  // namespace
}  // namespace ew::test
