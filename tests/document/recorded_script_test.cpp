// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <QUndoStack>
#include <cmath>
#include <limits>
#include <set>

#include "core/document/document.h"
#include "core/document/replay.h"
#include "tests/document/fixtures.h"

namespace ew {
namespace {

using test::fakeDocument;
using test::line;

void draw(Document& d, double size) {
    ASSERT_TRUE(d.addStroke(line({100, 100}, {100 + size, 103})));
}

TEST(Document, RecordsOnlyTheLastCameraBeforeAStroke) {
    const auto d = fakeDocument();
    for (int i = 1; i <= 20; ++i) {
        OrthographicCamera c;
        c.worldPerPixel = 0.1 * i;
        ASSERT_TRUE(d->setCamera(c));
        ASSERT_TRUE(d->setThresholds({10.0 + i, 5}));
    }
    draw(*d, 5);
    ASSERT_TRUE(d->apply());
    const SketchScript script = d->recordedScript();
    EXPECT_EQ(script.thresholds, (Thresholds{30, 5}));
    ASSERT_EQ(script.steps.size(), 3U);
    EXPECT_EQ(std::get<CameraStep>(script.steps[0]).worldPerPixel, 2.0);
    EXPECT_FALSE(std::get<CameraStep>(script.steps[0]).direction);
    EXPECT_TRUE(std::holds_alternative<StrokeStep>(script.steps[1]));
    EXPECT_TRUE(std::holds_alternative<ApplyStep>(script.steps[2]));
}

/// Replays what a document recorded and compares.
void expectReplays(const Document& d) {
    const SketchScript recorded = d.recordedScript();
    const auto read = readSketchScript(writeSketchScript(recorded));
    ASSERT_TRUE(read) << read.error().message;
    const auto again = fakeDocument();
    const ReplayReport report = replay(*again, *read, {});
    ASSERT_EQ(report.firstFailure(), nullptr) << report.firstFailure()->error->message;
    EXPECT_TRUE(test::sameState(again->state(), d.state()));
    EXPECT_EQ(again->undoStack().index(), d.undoStack().index());
    EXPECT_EQ(again->undoStack().count(), d.undoStack().count());
    EXPECT_EQ(again->camera(), d.camera());
    EXPECT_EQ(again->thresholds(), d.thresholds());
    ASSERT_EQ(again->pendingStrokes().size(), d.pendingStrokes().size());
    for (std::size_t i = 0; i < d.pendingStrokes().size(); ++i) {
        const PendingStroke& a = again->pendingStrokes()[i];
        const PendingStroke& b = d.pendingStrokes()[i];
        EXPECT_EQ(a.camera, b.camera);
        ASSERT_EQ(a.stroke.samples.size(), b.stroke.samples.size());
        for (std::size_t k = 0; k < b.stroke.samples.size(); ++k) {
            EXPECT_EQ(a.stroke.samples[k].position, b.stroke.samples[k].position);
        }
    }
}

TEST(Document, RecordsAScriptThatLeadsToTheSameState) {
    const auto d = fakeDocument();
    OrthographicCamera c;
    c.width = 1000;
    c.height = 700;
    c.direction = Vec3(0.3, 0.4, -0.5).normalized();
    ASSERT_TRUE(d->setCamera(c));
    draw(*d, 5);
    draw(*d, 5);  // exactly over the first
    draw(*d, 9);
    d->removeStrokes({d->pendingStrokes()[0].id, 4711});
    expectReplays(*d);
    ASSERT_TRUE(d->undoInk());
    expectReplays(*d);
    ASSERT_TRUE(d->eraseAt({101, 101}));
    ASSERT_TRUE(d->eraseAt({101, 101}));
    c.width = 640;  // the window was made smaller
    ASSERT_TRUE(d->setCamera(c));
    d->setObliqueFactor(0.7);
    ASSERT_TRUE(d->apply());
    ASSERT_TRUE(d->chooseReading(1));
    expectReplays(*d);
    ASSERT_TRUE(d->defineTemplateFromSolid("mine", "Mine"));
    ASSERT_TRUE(d->defineTemplate(test::boxTemplate("slab", "Slab")));
    ASSERT_TRUE(d->undo(3));
    ASSERT_TRUE(d->redo(2));
    draw(*d, 4);
    Repair repair;
    repair.strokes = {0};
    repair.from = Vec2(104, 103);
    repair.to = Vec2(140, 120);
    ASSERT_TRUE(d->repair(repair));
    ASSERT_TRUE(d->setThresholds({22, 9}));
    expectReplays(*d);
    ASSERT_TRUE(d->deleteBodies());
    d->clearStrokes();
    expectReplays(*d);
    d->reset();
    EXPECT_TRUE(d->recordedScript().steps.empty());
    EXPECT_FALSE(d->isModified());
    expectReplays(*d);
}

TEST(Document, RecordsTheSurface) {
    const auto d = fakeDocument();
    draw(*d, 40);
    ASSERT_TRUE(d->apply());
    draw(*d, 40);
    ASSERT_TRUE(d->apply());  // covers the first one
    FilletRequest all;
    all.radius = 0.25;
    all.segments = 3;
    ASSERT_TRUE(d->fillet(all));
    for (const double radius : {0.3, 0.4}) {
        FilletRequest some;
        some.edges.which = EdgeChoice::Which::Picked;
        some.edges.picked = {{0, 3}, {1, 3}, {1, 7}};
        some.radius = radius;
        some.replace = true;
        ASSERT_TRUE(d->fillet(some));
    }
    ASSERT_TRUE(d->crease({EdgeChoice::Which::Picked, {{1, 2}}}, 2.5));
    SubdivisionSettings s;
    s.on = true;
    s.tolerance = 0.25;
    s.sharpness = 3;
    s.sharpCorners = true;
    ASSERT_TRUE(d->subdivide(s));
    expectReplays(*d);
    ASSERT_TRUE(d->sharpen({EdgeChoice::Which::Picked, {{0, 3}, {1, 3}}}));
    ASSERT_TRUE(d->subdivide({}));
    ASSERT_TRUE(d->addStroke(line({690, 280}, {700, 285})));
    OrthographicCamera c;
    c.direction = Vec3(0, 0, -1);
    c.up = Vec3(0, 1, 0);
    ASSERT_TRUE(d->setCamera(c));
    ASSERT_TRUE(d->addStroke(line({700, 310}, {760, 318})));
    ASSERT_TRUE(d->mapStrokes({1, 2, 3}));
    EXPECT_GE(d->state().mapped.size(), 1U);
    expectReplays(*d);
    ASSERT_TRUE(d->undo(2));
    expectReplays(*d);
}

RC_GTEST_PROP(Document, WhateverIsDoneReplaysToTheSame, ()) {
    const auto d = fakeDocument();
    const auto steps = *rc::gen::container<std::vector<std::pair<int, int>>>(
        rc::gen::pair(rc::gen::inRange(0, test::kDeeds), rc::gen::inRange(0, 30)));
    for (const auto& [what, number] : steps) test::doSomething(*d, what, number);
    expectReplays(*d);
}

}  // namespace
}  // namespace ew
