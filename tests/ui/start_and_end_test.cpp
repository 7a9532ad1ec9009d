// SPDX-License-Identifier: GPL-3.0-or-later
// The window's first size on small screens, and how it ends when it is told to.
#include <QApplication>
#include <QDockWidget>
#include <QScreen>
#include <QSlider>
#include <QTest>
#include <array>
#include <csignal>

#include "tests/ui/window_fixture.h"
#include "ui/actions/file_actions.h"
#include "ui/lesson/lesson_dock.h"
#include "ui/live_reading.h"
#include "ui/panels/message_bar.h"
#include "ui/session_end.h"
#include "ui/viewport/viewport_widget.h"

namespace ew::test {
namespace {

/// Of two screens, less what a desktop's bar takes, and of one of 1600 x 1000 at scale 2.
class FirstStart : public testing::TestWithParam<QSize> {};

TEST_P(FirstStart, FitsTheScreenWithAllThatIsNeeded) {
    const QSize available = GetParam();
    auto load = loadLibrary(std::string(EDGEWRIGHT_SOURCE_DIR) + "/resources/templates");
    ASSERT_TRUE(load);
    Appearance look;
    MainWindow window(load->library, look, {.remember = false, .available = available});
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    QApplication::processEvents();
    // Its frame needs room too.
    EXPECT_LE(window.width(), available.width());
    EXPECT_LE(window.height(), available.height() - 30);
    EXPECT_LE(window.minimumSizeHint().width(), available.width());
    EXPECT_LE(window.minimumSizeHint().height(), available.height() - 30);
    // Not even where there is much to say and to repair.
    const OrthographicCamera& camera = window.document().camera();
    const Vec2 middle(camera.width / 2, camera.height / 2);
    const std::array<Vec2, 6> corners{Vec2(-90, -60), Vec2(90, -60), Vec2(90, 60),
                                      Vec2(-90, 60),  Vec2(-60, 90), Vec2(70, 95)};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 from = middle + corners[i];
        const Vec2 to = middle + corners[(i + 1) % corners.size()];
        ASSERT_TRUE(
            window.document().addStroke(Stroke{{{from, 1, 0}, {from + 0.8 * (to - from), 1, 0}}}));
    }
    window.reading().refreshNow();
    window.reading().settleNow();
    QApplication::processEvents();
    EXPECT_NE(window.findChild<QWidget*>("repair1"), nullptr)
        << window.messages().text().toStdString();
    EXPECT_LE(window.minimumSizeHint().width(), available.width());
    EXPECT_LE(window.width(), available.width());
    const auto isSeen = [&](const QWidget* w) {
        return w != nullptr && w->isVisible() &&
               window.rect().contains(QRect(w->mapTo(&window, QPoint(0, 0)), w->size())) &&
               w->visibleRegion().boundingRect().size() == w->size();
    };
    EXPECT_TRUE(isSeen(&window.messages()));
    for (const char* name : {"distanceSlider", "angleSlider", "distanceNumber", "angleNumber"}) {
        EXPECT_TRUE(isSeen(window.findChild<QWidget*>(name))) << name;
    }
    // Drawing is what it is for.
    EXPECT_GE(window.viewport().width(), 400);
    EXPECT_GE(window.viewport().height(), 300);
    // Every panel is there, if behind a tab; that of a lesson comes with one.
    for (const QDockWidget* panel : window.findChildren<QDockWidget*>()) {
        if (panel == &window.lesson()) continue;
        EXPECT_FALSE(panel->isHidden()) << panel->objectName().toStdString();
    }
}

INSTANTIATE_TEST_SUITE_P(Screens, FirstStart,
                         testing::Values(QSize(1366, 728), QSize(1280, 680), QSize(800, 460),
                                         QSize(1920, 1040)));

class End : public WindowTest {};

TEST_F(End, ASignalClosesTheWindowInOrder) {
    const SessionEnd end(*window_, [] { return true; });
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
        window_->show();
        std::raise(signal);
        EXPECT_TRUE(QTest::qWaitFor([&] { return !window_->isVisible(); }, 20000)) << signal;
    }
}

TEST_F(End, ASignalAsksAboutWorkThatIsNotSaved) {
    const SessionEnd end(*window_, [] { return true; });
    drawLine(Hand::Mouse, {100, 100}, {200, 100});
    int asked = 0;
    window_->files().setQuestion([&] {
        // Impatient: the same signal again while it asks.
        if (asked++ == 0) std::raise(SIGTERM);
        QApplication::processEvents();
        return FileActions::Answer::Cancel;
    });
    std::raise(SIGTERM);
    EXPECT_TRUE(QTest::qWaitFor([&] { return asked > 0; }, 20000));
    EXPECT_TRUE(window_->isVisible());
    EXPECT_EQ(document().pendingStrokes().size(), 1U);
    EXPECT_FALSE(window_->mayClose());
    window_->files().setQuestion([] { return FileActions::Answer::Discard; });
    std::raise(SIGTERM);
    EXPECT_TRUE(QTest::qWaitFor([&] { return !window_->isVisible(); }, 20000));
}

}  // namespace
}  // namespace ew::test
