// SPDX-License-Identifier: GPL-3.0-or-later
// The distance threshold that the pending strokes tell, until somebody sets it.
#include <gtest/gtest.h>

#include "core/document/replay.h"
#include "tests/document/fixtures.h"

namespace ew {
namespace {

using test::fakeDocument;
using test::line;

constexpr double kDefault = Thresholds{}.distancePx;

/// A large triangle whose corners stay open by 24 px.
std::vector<Stroke> careless() {
    return {line({124, 100}, {600, 100}), line({590, 122}, {350, 500}),
            line({340, 480}, {100, 100})};
}

void draw(Document& d) {
    for (const Stroke& s : careless()) ASSERT_TRUE(d.addStroke(s));
}

TEST(AutomaticDistance, FollowsTheStrokes) {
    const auto d = fakeDocument();
    EXPECT_TRUE(d->automaticDistance());
    draw(*d);
    EXPECT_GT(d->thresholds().distancePx, kDefault);
    d->clearStrokes();
    EXPECT_EQ(d->thresholds().distancePx, kDefault);
}

TEST(AutomaticDistance, EndsWhereSomebodySetsTheDistance) {
    const auto d = fakeDocument();
    ASSERT_TRUE(d->setThresholds({kDefault, 20.0}));
    EXPECT_TRUE(d->automaticDistance());  // that was the angle
    ASSERT_TRUE(d->setThresholds({9.0, 20.0}));
    EXPECT_FALSE(d->automaticDistance());
    draw(*d);
    EXPECT_EQ(d->thresholds().distancePx, 9.0);
    d->setAutomaticDistance(true);
    EXPECT_GT(d->thresholds().distancePx, kDefault);
}

TEST(AutomaticDistance, AScriptThatNamesItIsObeyedAndOneThatDoesNotIsTold) {
    SketchScript script;
    for (const Stroke& s : careless()) script.steps.emplace_back(StrokeStep{s});
    const auto free = fakeDocument();
    replay(*free, script, {});
    EXPECT_GT(free->thresholds().distancePx, kDefault);
    script.namesDistance = true;
    const auto named = fakeDocument();
    replay(*named, script, {});
    EXPECT_EQ(named->thresholds().distancePx, kDefault);
}

// What was read with a threshold that the strokes told is read with it again.
TEST(AutomaticDistance, ARecordedScriptNamesWhatWasInUse) {
    const auto d = fakeDocument();
    ASSERT_TRUE(d->addStroke(line({10, 10}, {60, 10})));
    ASSERT_TRUE(d->apply());
    draw(*d);
    ASSERT_TRUE(d->addStroke(line({100, 300}, {500, 300})));
    ASSERT_TRUE(d->apply());
    const double used = d->thresholds().distancePx;
    EXPECT_GT(used, kDefault);
    const SketchScript script = d->recordedScript();
    EXPECT_TRUE(script.namesDistance);
    const auto again = fakeDocument();
    const ReplayReport report = replay(*again, script, {});
    EXPECT_EQ(report.firstFailure(), nullptr);
    EXPECT_EQ(again->thresholds().distancePx, used);
    EXPECT_TRUE(test::sameState(again->state(), d->state()));
}

}  // namespace
}  // namespace ew
