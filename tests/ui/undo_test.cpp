// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl+Z and its way back: what is drawn, ink and steps in one line of time.
#include <QAction>
#include <QListView>
#include <QListWidget>
#include <QUndoStack>

#include "tests/ui/window_fixture.h"
#include "ui/tools/tool_box.h"

namespace ew::test {
namespace {

class Undo : public WindowTest {
  protected:
    void undo() { key(Qt::Key_Z, Qt::ControlModifier); }
    void redo() { key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier); }
    std::size_t ink() { return document().pendingStrokes().size(); }
    int steps() { return document().undoStack().index(); }
};

TEST_F(Undo, WhileAStrokeIsDrawnTakesThatStrokeOnly) {
    for (const Hand hand : {Hand::Mouse, Hand::Pen}) {
        document().reset();
        // The first stroke of all: there is nothing else to take back.
        press(hand, {100, 100});
        move(hand, {160, 100});
        undo();
        EXPECT_FALSE(window_->tools().gestureUnderWay());
        move(hand, {180, 120});
        release(hand, {180, 120});
        EXPECT_EQ(ink(), 0U);
        redo();
        ASSERT_EQ(ink(), 1U) << "the part that was drawn comes back";
        EXPECT_NEAR(document().pendingStrokes()[0].stroke.samples.back().position.x(), 160, 0.01);
        drawLine(hand, {100, 200}, {200, 200});
        press(hand, {100, 300});
        move(hand, {160, 300});
        undo();
        move(hand, {180, 320});
        release(hand, {180, 320});
        EXPECT_EQ(ink(), 2U) << "the strokes before it stay";
        undo();
        EXPECT_EQ(ink(), 1U);
        leaveProximity();
    }
}

TEST_F(Undo, WhileErasingBringsBackWhatThatErasedOnly) {
    drawLine(Hand::Mouse, {100, 100}, {300, 100});
    drawLine(Hand::Mouse, {100, 200}, {300, 200});
    key(Qt::Key_E);
    press(Hand::Mouse, {200, 95});
    move(Hand::Mouse, {200, 105});
    EXPECT_EQ(ink(), 1U);
    undo();
    EXPECT_EQ(ink(), 2U);
    move(Hand::Mouse, {200, 205});
    release(Hand::Mouse, {200, 205});
    EXPECT_EQ(ink(), 2U);
}

TEST_F(Undo, InkOfAStepThatWasUndoneIsNext) {
    drawLines(Hand::Mouse, boxLines());
    key(Qt::Key_Return);
    ASSERT_EQ(steps(), 1);
    ASSERT_TRUE(document().fillet({{}, 2.0, {}, false}));
    drawLine(Hand::Mouse, {60, 60}, {160, 60});
    undo();
    EXPECT_EQ(ink(), 0U);
    EXPECT_EQ(steps(), 2);
    undo();
    EXPECT_EQ(steps(), 1);
    undo();
    EXPECT_EQ(steps(), 0);
    EXPECT_EQ(ink(), 9U);
    undo();
    EXPECT_EQ(ink(), 8U) << "not all of it at once, and no step";
    undo();
    EXPECT_EQ(ink(), 7U);
    redo();
    redo();
    EXPECT_EQ(ink(), 9U);
    EXPECT_EQ(steps(), 0);
    redo();
    EXPECT_EQ(steps(), 1);
    EXPECT_EQ(ink(), 0U);
    redo();
    EXPECT_EQ(steps(), 2);
    redo();
    EXPECT_EQ(ink(), 1U);
}

TEST_F(Undo, TheHistoryPanelTakesInkAlong) {
    drawLines(Hand::Mouse, boxLines());
    key(Qt::Key_Return);
    auto* list = window_->findChild<QListView*>("historyList");
    ASSERT_NE(list, nullptr);
    drawLine(Hand::Mouse, {60, 60}, {160, 60});
    list->setCurrentIndex(list->model()->index(0, 0));
    EXPECT_EQ(ink(), 9U) << "the stroke came later";
    list->setCurrentIndex(list->model()->index(1, 0));
    EXPECT_EQ(ink(), 0U);
    redo();
    EXPECT_EQ(ink(), 1U);
}

TEST_F(Undo, AClickOfThePenLeavesNothingInTheWay) {
    drawLines(Hand::Pen, boxLines());
    key(Qt::Key_Return);
    ASSERT_NE(document().lastApply(), nullptr);
    for (const Hand hand : {Hand::Pen, Hand::Mouse}) {
        press(hand, {200, 200});
        move(hand, {201, 201});
        release(hand, {201, 200});
        leaveProximity();
        EXPECT_EQ(ink(), 0U);
        EXPECT_NE(document().lastApply(), nullptr) << "the other readings are still there";
    }
    // The next tool works.
    key(Qt::Key_B);
    const auto lines = boxLines();
    const Vec2 middle = (lines[0][0] + lines[0][1] + lines[1][1]) / 3.0;
    drawLine(Hand::Mouse, middle, middle + Vec2(12, 0));
    EXPECT_EQ(document().state().mapped.size(), 1U);
    // A short stroke is a stroke.
    key(Qt::Key_P);
    drawLine(Hand::Mouse, {60, 60}, {66, 60});
    EXPECT_EQ(ink(), 1U);
}

}  // namespace
}  // namespace ew::test
