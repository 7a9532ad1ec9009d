// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QUndoStack>
#include <algorithm>
#include <memory>

#include "core/document/document.h"
#include "core/document/replay.h"
#include "tests/support/modification_cases.h"

namespace ew::test {
namespace {

const TemplateLibrary& library() {
    static const TemplateLibrary shipped =
        loadLibrary(EDGEWRIGHT_SOURCE_DIR "/resources/templates")->library;
    return shipped;
}

/// The edges of the cases' box that the default camera sees.
std::vector<Line2> boxOutline(const OrthographicCamera& camera) {
    const auto p = [&](int x, int y, int z) {
        return camera.project(Vec3(80 * x, 60 * y, 40 * z));
    };
    return {{p(0, 0, 0), p(1, 0, 0)}, {p(1, 0, 0), p(1, 1, 0)}, {p(0, 0, 1), p(1, 0, 1)},
            {p(1, 0, 1), p(1, 1, 1)}, {p(1, 1, 1), p(0, 1, 1)}, {p(0, 1, 1), p(0, 0, 1)},
            {p(0, 0, 0), p(0, 0, 1)}, {p(1, 0, 0), p(1, 0, 1)}, {p(1, 1, 0), p(1, 1, 1)}};
}

void draw(Document& d, const std::vector<Line2>& lines) {
    for (Stroke& s : exactStrokes(lines)) ASSERT_TRUE(d.addStroke(std::move(s)));
}

const ModificationCase& caseNamed(const std::string& name) {
    static const std::vector<ModificationCase> all = boxModifications();
    return *std::find_if(all.begin(), all.end(), [&](const auto& c) { return c.name == name; });
}

/// A document with the box, drawn.
std::unique_ptr<Document> withBox() {
    auto d = std::make_unique<Document>(library());
    EXPECT_TRUE(d->setCamera(defaultBoxCamera()));
    draw(*d, boxOutline(d->camera()));
    EXPECT_TRUE(d->apply());
    return d;
}

ApplyRequest asking(Operation operation) {
    ApplyRequest request;
    request.operation = operation;
    return request;
}

TEST(DocumentModification, AddsAndCutsAreNamedStepsThatCanBeTakenBack) {
    const auto d = withBox();
    ASSERT_EQ(d->state().bodies.size(), 1u);
    EXPECT_NEAR(d->state().bodies[0].solid.volume(), 192000, 1);
    const Solid box = d->state().bodies[0].solid;

    draw(*d, linesOnPlane(caseNamed("edge notch by its outline")));
    const auto cut = d->apply();
    ASSERT_TRUE(cut) << cut.error().message;
    EXPECT_EQ(d->undoStack().undoText(), QStringLiteral("Cut cube"));
    ASSERT_EQ(d->state().bodies.size(), 1u);
    EXPECT_NEAR(d->state().bodies[0].solid.volume(), 183000, 1);
    EXPECT_TRUE(d->pendingStrokes().empty());
    const Solid notched = d->state().bodies[0].solid;

    ASSERT_TRUE(d->undo());
    EXPECT_TRUE(d->state().bodies[0].solid.identicalTo(box));
    EXPECT_EQ(d->pendingStrokes().size(), 6u) << "the ink is back";
    ASSERT_TRUE(d->redo());
    EXPECT_TRUE(d->state().bodies[0].solid.identicalTo(notched));

    draw(*d, linesOnPlane(caseNamed("box on a side face")));
    ASSERT_TRUE(d->apply(asking(Operation::Add)));
    EXPECT_EQ(d->undoStack().undoText(), QStringLiteral("Add cube"));
    EXPECT_NEAR(d->state().bodies[0].solid.volume(), 183000 + 25 * 30 * 20, 1);
}

TEST(DocumentModification, AnImpossibleOperationLeavesSolidAndInk) {
    const auto d = withBox();
    const auto state = &d->state();
    draw(*d, linesOnPlane(caseNamed("corner cut by a triangle")));
    const auto added = d->apply(asking(Operation::Add));
    ASSERT_FALSE(added);
    EXPECT_FALSE(added.error().message.empty());
    EXPECT_EQ(&d->state(), state);
    EXPECT_EQ(d->pendingStrokes().size(), 3u);
    EXPECT_TRUE(d->apply(asking(Operation::Cut)));
}

TEST(DocumentModification, TheRecordedScriptReplaysToTheSameSolid) {
    const auto d = withBox();
    for (const char* name : {"edge notch by its outline", "box on a side face"}) {
        draw(*d, linesOnPlane(caseNamed(name)));
        ASSERT_TRUE(d->apply()) << name;
    }
    Document again(library());
    const QTemporaryDir folder;
    const ReplayReport report =
        replay(again, d->recordedScript(), {folder.path(), folder.path(), false});
    EXPECT_EQ(report.firstFailure(), nullptr);
    ASSERT_EQ(again.state().bodies.size(), 1u);
    EXPECT_TRUE(again.state().bodies[0].solid.identicalTo(d->state().bodies[0].solid));
}

}  // namespace
}  // namespace ew::test
