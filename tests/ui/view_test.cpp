// SPDX-License-Identifier: GPL-3.0-or-later
// Moving the view with real events.
#include <QApplication>
#include <QToolButton>
#include <QWheelEvent>

#include "tests/ui/window_fixture.h"
#include "ui/theme/appearance.h"
#include "ui/theme/colours.h"
#include "ui/viewport/camera_moves.h"
#include "ui/viewport/viewport_widget.h"

namespace ew::test {

class View : public WindowTest {
  protected:
    void drag(const Vec2& from, const Vec2& to, Qt::MouseButton button) {
        press(Hand::Mouse, from, button);
        move(Hand::Mouse, (from + to) / 2, button);
        move(Hand::Mouse, to, button);
        release(Hand::Mouse, to, button);
    }
};

TEST_F(View, MiddleAndRightButtonOrbit) {
    for (const Qt::MouseButton button : {Qt::MiddleButton, Qt::RightButton}) {
        const OrthographicCamera before = document().camera();
        drag({300, 300}, {360, 320}, button);
        const OrthographicCamera after = document().camera();
        EXPECT_LT(before.direction.dot(after.direction), 0.95);
        EXPECT_NEAR(after.direction.norm(), 1.0, 1e-12);
        EXPECT_EQ(before.worldPerPixel, after.worldPerPixel);
        EXPECT_TRUE(document().pendingStrokes().empty());
    }
}

TEST_F(View, ATurningViewMayBeRoughAndIsFineAgainAfterwards) {
    auto& viewport = window_->viewport();
    const auto picture = [&] {
        viewport.setHover(std::nullopt);
        return viewport.grabFramebuffer();
    };
    const QImage before = picture();
    for (const Qt::KeyboardModifiers held : {Qt::NoModifier, Qt::ShiftModifier}) {
        modifiers_ = held;
        press(Hand::Mouse, {300, 300}, Qt::MiddleButton);
        move(Hand::Mouse, {330, 310}, Qt::MiddleButton);
        move(Hand::Mouse, {300, 300}, Qt::MiddleButton);
        const QImage turning = picture();
        release(Hand::Mouse, {300, 300}, Qt::MiddleButton);
        EXPECT_EQ(turning.size(), before.size());
        // The tests have no graphics card.
        EXPECT_NE(turning, before);
        EXPECT_EQ(picture(), before);
    }
}

TEST_F(View, ShiftWithTheMiddleButtonPansUnderThePointer) {
    const Vec3 grabbed = document().camera().unproject({300, 300});
    modifiers_ = Qt::ShiftModifier;
    drag({300, 300}, {380, 250}, Qt::MiddleButton);
    EXPECT_NEAR((document().camera().project(grabbed) - Vec2(380, 250)).norm(), 0.0, 1e-6);
}

TEST_F(View, WheelZoomsToTheCursor) {
    const QPointF at(200, 150);
    const Vec3 under = document().camera().unproject({200, 150});
    const double before = document().camera().worldPerPixel;
    QWheelEvent wheel(at, surface().mapToGlobal(at), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&surface(), &wheel);
    EXPECT_LT(document().camera().worldPerPixel, before);
    EXPECT_NEAR((document().camera().project(under) - Vec2(200, 150)).norm(), 0.0, 1e-6);
}

TEST_F(View, StandardViewsLookAlongTheAxes) {
    key(Qt::Key_1, Qt::ControlModifier);
    EXPECT_EQ(document().camera().direction, Vec3(0, 1, 0));
    key(Qt::Key_5, Qt::ControlModifier);
    EXPECT_EQ(document().camera().direction, Vec3(0, 0, -1));
    key(Qt::Key_H);
    EXPECT_EQ(document().camera().direction, OrthographicCamera().direction);
}

TEST_F(View, TheViewportIsTheDocumentsViewport) {
    EXPECT_EQ(document().camera().width, surface().width());
    EXPECT_EQ(document().camera().height, surface().height());
    window_->resize(1100, 760);
    settle();
    EXPECT_EQ(document().camera().width, surface().width());
    EXPECT_EQ(document().camera().height, surface().height());
}

TEST_F(View, ADrawingGoesOnAfterThePageWasMoved) {
    const auto lines = boxLines();
    drawLine(Hand::Mouse, lines[0][0], lines[0][1]);
    const OrthographicCamera first = document().camera();
    modifiers_ = Qt::ShiftModifier;
    drag({300, 300}, {340, 270}, Qt::MiddleButton);
    modifiers_ = Qt::NoModifier;
    const Vec2 moved(40, -30);
    for (std::size_t i = 1; i < lines.size(); ++i) {
        drawLine(Hand::Mouse, lines[i][0] + moved, lines[i][1] + moved);
    }
    // All strokes are on the first one's Sketch Plane, at the place where they were drawn on it.
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const PendingStroke& stroke = document().pendingStrokes()[i];
        EXPECT_TRUE(stroke.camera == first);
        EXPECT_NEAR((stroke.stroke.samples.front().position - lines[i][0]).norm(), 0.0, 0.75);
    }
    key(Qt::Key_Return);
    ASSERT_EQ(document().state().bodies.size(), 1U);
    EXPECT_NEAR(document().state().bodies[0].solid.volume(), 72000.0, 0.03 * 72000.0);
}

TEST_F(View, FitShowsTheWholeBody) {
    drawLines(Hand::Mouse, boxLines());
    key(Qt::Key_Return);
    ASSERT_EQ(document().state().bodies.size(), 1U);
    OrthographicCamera far = document().camera();
    far.center = Vec3(900, -500, 300);
    ASSERT_TRUE(document().setCamera(far));
    key(Qt::Key_F);
    for (const Vec3& p : bodyPoints(document().state().bodies)) {
        const Vec2 px = document().camera().project(p);
        EXPECT_GT(px.x(), 0);
        EXPECT_GT(px.y(), 0);
        EXPECT_LT(px.x(), surface().width());
        EXPECT_LT(px.y(), surface().height());
    }
}

TEST_F(View, TheButtonForWhatTheToolBarHasNoRoomForIsSeen) {
    window_->resize(720, 700);
    settle();
    auto* more = window_->findChild<QToolButton*>("qt_toolbar_ext_button");
    ASSERT_NE(more, nullptr);
    ASSERT_TRUE(more->isVisible()) << "there is room for everything";
    EXPECT_GE(more->width(), 20);
    for (const Appearance::Mode mode : {Appearance::Mode::Light, Appearance::Mode::Dark}) {
        appearance_->setMode(mode);
        settle();
        const QImage picture = more->grab().toImage();
        const QColor back = picture.pixelColor(picture.width() / 2, 2);
        QRect mark;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                if (contrastRatio(picture.pixelColor(x, y), back) < 3.0) continue;
                mark |= QRect(x, y, 1, 1);
            }
        }
        const double scale = picture.devicePixelRatio();
        EXPECT_GE(mark.width() / scale, 6);
        EXPECT_GE(mark.height() / scale, 6);
    }
}

}  // namespace ew::test
