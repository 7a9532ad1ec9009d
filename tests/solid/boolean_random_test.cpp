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
#include "tests/support/random_modifications.h"

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

// 200 modifications in a row ---------------------------------------------------------------------

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
