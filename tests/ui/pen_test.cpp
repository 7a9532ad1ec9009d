// SPDX-License-Identifier: GPL-3.0-or-later
// Pen, eraser, mouse and keys on a real window.
#include <QApplication>
#include <QTabletEvent>

#include "tests/ui/window_fixture.h"
#include "ui/tools/tool_box.h"
#include "ui/viewport/viewport_widget.h"

namespace ew::test {

class Pen : public WindowTest {};

TEST_F(Pen, PressureIsKeptAndMouseHasNone) {
    drawLine(Hand::Pen, {100, 100}, {200, 100});
    leaveProximity();
    drawLine(Hand::Mouse, {100, 200}, {200, 200});
    ASSERT_EQ(document().pendingStrokes().size(), 2U);
    for (const PenSample& s : document().pendingStrokes()[0].stroke.samples) {
        EXPECT_NEAR(s.pressure, 0.6, 1e-6);
    }
    for (const PenSample& s : document().pendingStrokes()[1].stroke.samples) {
        EXPECT_EQ(s.pressure, 1.0);
    }
}

TEST_F(Pen, EscapeCancelsTheStrokeUnderWay) {
    drawLine(Hand::Pen, {100, 100}, {200, 100});
    press(Hand::Pen, {100, 200});
    move(Hand::Pen, {150, 220});
    EXPECT_TRUE(window_->tools().gestureUnderWay());
    key(Qt::Key_Escape);
    EXPECT_FALSE(window_->tools().gestureUnderWay());
    move(Hand::Pen, {180, 230});
    release(Hand::Pen, {190, 240});
    EXPECT_EQ(document().pendingStrokes().size(), 1U);
    // The next stroke is a stroke again.
    drawLine(Hand::Pen, {100, 300}, {200, 300});
    EXPECT_EQ(document().pendingStrokes().size(), 2U);
}

TEST_F(Pen, EraserEndRemovesTheStrokeItTouches) {
    drawLine(Hand::Pen, {100, 100}, {300, 100});
    drawLine(Hand::Pen, {100, 200}, {300, 200});
    useEraserEnd(true);
    drawLine(Hand::Pen, {200, 190}, {200, 210});
    useEraserEnd(false);
    ASSERT_EQ(document().pendingStrokes().size(), 1U);
    EXPECT_NEAR(document().pendingStrokes()[0].stroke.samples[0].position.y(), 100, 0.01);
    // Away from any stroke it does nothing.
    useEraserEnd(true);
    drawLine(Hand::Pen, {400, 400}, {420, 420});
    useEraserEnd(false);
    EXPECT_EQ(document().pendingStrokes().size(), 1U);
}

TEST_F(Pen, EraserToolErasesAndEscapeBringsBack) {
    drawLine(Hand::Mouse, {100, 100}, {300, 100});
    drawLine(Hand::Mouse, {100, 200}, {300, 200});
    key(Qt::Key_E);
    EXPECT_EQ(window_->tools().active(), ToolBox::Kind::Eraser);
    press(Hand::Mouse, {200, 95});
    move(Hand::Mouse, {200, 205});
    EXPECT_TRUE(document().pendingStrokes().empty());
    key(Qt::Key_Escape);
    EXPECT_EQ(document().pendingStrokes().size(), 2U);
    release(Hand::Mouse, {200, 205});
    EXPECT_EQ(document().pendingStrokes().size(), 2U);
}

TEST_F(Pen, UndoTakesTheNewestStrokeFirstThenTheStep) {
    drawLines(Hand::Mouse, boxLines());
    key(Qt::Key_Return);
    ASSERT_EQ(document().state().bodies.size(), 1U);
    drawLine(Hand::Mouse, {60, 60}, {160, 60});
    drawLine(Hand::Mouse, {60, 90}, {160, 90});
    key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(document().pendingStrokes().size(), 1U);
    EXPECT_EQ(document().state().bodies.size(), 1U);
    key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(document().pendingStrokes().size(), 0U);
    EXPECT_EQ(document().state().bodies.size(), 1U);
    key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(document().state().bodies.empty());
    EXPECT_EQ(document().pendingStrokes().size(), 9U);
}

TEST_F(Pen, SynthesisedMouseIsDroppedAndTabletEventsAreAccepted) {
    const QPointF at(120, 130);
    QMouseEvent fake(QEvent::MouseButtonPress, at, at, at, Qt::LeftButton, Qt::LeftButton,
                     Qt::NoModifier, Qt::MouseEventSynthesizedByQt);
    QApplication::sendEvent(&surface(), &fake);
    EXPECT_FALSE(window_->tools().gestureUnderWay());
    QTabletEvent pen(QEvent::TabletPress, QPointingDevice::primaryPointingDevice(), at, at, 0.5, 0,
                     0, 0, 0, 0, Qt::NoModifier, Qt::LeftButton, Qt::LeftButton);
    pen.ignore();
    QApplication::sendEvent(&surface(), &pen);
    EXPECT_TRUE(pen.isAccepted());
    EXPECT_TRUE(window_->tools().gestureUnderWay());
    window_->tools().cancelGesture();
}

TEST_F(Pen, MouseIsIgnoredWhileThePenIsNear) {
    press(Hand::Pen, {100, 100});
    press(Hand::Mouse, {300, 300});
    move(Hand::Mouse, {350, 300});
    release(Hand::Mouse, {350, 300});
    move(Hand::Pen, {200, 100});
    release(Hand::Pen, {200, 100});
    ASSERT_EQ(document().pendingStrokes().size(), 1U);
    EXPECT_NEAR(document().pendingStrokes()[0].stroke.samples.back().position.x(), 200, 0.01);
    for (const PenSample& s : document().pendingStrokes()[0].stroke.samples) {
        EXPECT_NEAR(s.position.y(), 100, 0.01);
    }
}

TEST_F(Pen, LeavingProximityInMidStrokeLeavesNothing) {
    press(Hand::Pen, {100, 100});
    move(Hand::Pen, {150, 100});
    leaveProximity();
    EXPECT_FALSE(window_->tools().gestureUnderWay());
    EXPECT_TRUE(document().pendingStrokes().empty());
}

TEST_F(Pen, TheRingIsWhereThePenIsWhenItIsLifted) {
    for (const Hand hand : {Hand::Pen, Hand::Mouse}) {
        press(hand, {300, 300});
        move(hand, {340, 310});
        move(hand, {400, 330});
        release(hand, {420, 340});
        const auto ring = window_->viewport().hover();
        ASSERT_TRUE(ring);
        EXPECT_LT((*ring - Vec2(420, 340)).norm(), 1.0) << ring->transpose();
        leaveProximity();
    }
    // After a turn of the view, too.
    press(Hand::Mouse, {300, 300}, Qt::MiddleButton);
    move(Hand::Mouse, {350, 300}, Qt::MiddleButton);
    release(Hand::Mouse, {380, 310}, Qt::MiddleButton);
    ASSERT_TRUE(window_->viewport().hover());
    EXPECT_LT((*window_->viewport().hover() - Vec2(380, 310)).norm(), 1.0);
}

}  // namespace ew::test
