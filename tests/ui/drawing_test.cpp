// SPDX-License-Identifier: GPL-3.0-or-later
// A box drawn with real events, end to end, against the headless result. Run at several scales.
#include <QFile>

#include "core/document/replay.h"
#include "core/document/sketch_script.h"
#include "tests/ui/window_fixture.h"
#include "ui/actions/file_actions.h"
#include "ui/apply_controller.h"

namespace ew::test {

namespace {

QByteArray bytesOf(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    return file.readAll();
}

class Drawing : public WindowTest {
  protected:
    void boxEndToEnd(Hand hand) {
        drawLines(hand, boxLines());
        ASSERT_EQ(document().pendingStrokes().size(), 9U);
        key(Qt::Key_Return);
        ASSERT_EQ(document().state().bodies.size(), 1U);
        EXPECT_TRUE(document().pendingStrokes().empty());
        const Solid box = document().state().bodies.front().solid;
        EXPECT_EQ(box.vertices().size(), 8U);
        EXPECT_EQ(box.edges().size(), 12U);
        EXPECT_EQ(box.faces().size(), 6U);
        // Drawn at 0.25 mm/px with straight strokes: the box that was meant.
        EXPECT_NEAR(box.volume(), 60.0 * 40.0 * 30.0, 0.03 * 60 * 40 * 30);

        key(Qt::Key_Z, Qt::ControlModifier);
        EXPECT_TRUE(document().state().bodies.empty());
        EXPECT_EQ(document().pendingStrokes().size(), 9U);
        key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        ASSERT_EQ(document().state().bodies.size(), 1U);
        EXPECT_TRUE(document().state().bodies.front().solid.identicalTo(box));

        const QString windowFile = folder_.filePath("window.obj");
        const QString scriptFile = folder_.filePath("done.json");
        ASSERT_TRUE(window_->files().exportTo(windowFile));
        ASSERT_TRUE(window_->files().saveScriptTo(scriptFile));
        const auto script = readSketchScript(bytesOf(scriptFile).toStdString());
        ASSERT_TRUE(script) << script.error().message;
        Document headless(document().state().library);
        const ReplayReport report = replay(headless, *script, {});
        ASSERT_EQ(report.firstFailure(), nullptr) << report.firstFailure()->error->message;
        const QString headlessFile = folder_.filePath("headless.obj");
        ASSERT_TRUE(headless.exportTo(headlessFile));
        EXPECT_EQ(bytesOf(windowFile), bytesOf(headlessFile));
        EXPECT_GT(bytesOf(windowFile).size(), 100);
    }
};

}  // namespace

TEST_F(Drawing, BoxWithTheMouseIsWhatReplayMakes) { boxEndToEnd(Hand::Mouse); }

TEST_F(Drawing, BoxWithThePenIsWhatReplayMakes) { boxEndToEnd(Hand::Pen); }

TEST_F(Drawing, TheWindowHasTheScaleThatItIsTestedAt) {
    const QByteArray wanted = qgetenv("QT_SCALE_FACTOR");
    EXPECT_NEAR(surface().devicePixelRatioF(), wanted.isEmpty() ? 1.0 : wanted.toDouble(), 1e-9);
}

TEST_F(Drawing, StrokesLieWhereThePointerWas) {
    drawLine(Hand::Pen, {100, 120}, {300, 140});
    drawLine(Hand::Pen, {100.5, 200.25}, {90, 300});
    leaveProximity();
    drawLine(Hand::Mouse, {200, 220}, {320, 330});
    ASSERT_EQ(document().pendingStrokes().size(), 3U);
    const auto& strokes = document().pendingStrokes();
    EXPECT_NEAR((strokes[0].stroke.samples.front().position - Vec2(100, 120)).norm(), 0.0, 0.01);
    EXPECT_NEAR((strokes[0].stroke.samples.back().position - Vec2(300, 140)).norm(), 0.0, 0.01);
    EXPECT_NEAR((strokes[1].stroke.samples.front().position - Vec2(100.5, 200.25)).norm(), 0.0,
                0.01);
    EXPECT_NEAR((strokes[2].stroke.samples.back().position - Vec2(320, 330)).norm(), 0.0, 0.6);
    EXPECT_GT(strokes[0].stroke.samples.size(), 20U);
    // Time counts from pen-down.
    EXPECT_EQ(strokes[0].stroke.samples.front().timeMs, 0.0);
    EXPECT_GT(strokes[0].stroke.samples.back().timeMs, 100.0);
}

}  // namespace ew::test
