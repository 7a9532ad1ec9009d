// SPDX-License-Identifier: GPL-3.0-or-later
// A change is taken by itself only where no other one is as likely.
#include <cmath>

#include "core/base/tolerance.h"
#include "tests/reading/reading_fixture.h"
#include "tests/support/hand_model.h"
#include "tests/support/modification_cases.h"

namespace ew::test {
namespace {

/// How much more a candidate costs than the best one: its score says it, with how far it is off.
double dearer(const Candidate& c, double distancePx) {
    const double off = c.residualPx / distancePx;
    return -30.0 * (std::log(c.score) + 2.0 * off * off);
}

TEST(Rivals, WhatIsTakenByItselfHasNoOtherThatCostsAsLittle) {
    int taken = 0;
    int behindItsTwin =
        0;  // another one comes after the best one's own, adjusted to stop elsewhere
    for (int view = 0; view < 4; ++view) {
        for (const auto& cases : {boxModifications({}, view), jointModifications(view)}) {
            for (std::size_t k = 0; k < cases.size(); ++k) {
                SCOPED_TRACE(cases[k].scene + ": " + cases[k].name);
                Random random(Random::mix(static_cast<std::uint64_t>(view), k));
                InterpretOptions options;
                options.camera = cases[k].camera;
                options.bodies = {cases[k].target};
                const auto reading =
                    readStrokes(drawByHand(linesOnPlane(cases[k]), kNormalHand, random), options);
                if (!reading.accepted || reading.candidates.front().readingId != "default")
                    continue;
                ++taken;
                const auto& all = reading.candidates;
                behindItsTwin += all.size() > 2 && all[1].readingId == "adjusted" ? 1 : 0;
                for (std::size_t i = 1; i < all.size(); ++i) {
                    if (all[i].readingId == "adjusted") continue;
                    EXPECT_GE(dearer(all[i], options.thresholds.distancePx), tol::kClearMargin)
                        << i << " " << all[i].templateId;
                }
            }
        }
    }
    EXPECT_GT(taken, 60);
    EXPECT_GT(behindItsTwin, 0);
}

}  // namespace
}  // namespace ew::test
