// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_fixture.h"

#include <qpa/qwindowsysteminterface.h>

#include <QApplication>
#include <QTest>
#include <QWindow>

#include "ui/actions/file_actions.h"
#include "ui/apply_controller.h"
#include "ui/live_reading.h"
#include "ui/viewport/viewport_widget.h"

namespace ew::test {

namespace {

constexpr double kSampleStepPx = 6.0;
constexpr unsigned long kSampleMs = 8;

const QPointingDevice& penDevice(bool eraser) {
    const auto make = [](QPointingDevice::PointerType type, int id) {
        return new QPointingDevice(
            QStringLiteral("test pen"), id, QInputDevice::DeviceType::Stylus, type,
            QInputDevice::Capability::Position | QInputDevice::Capability::Pressure |
                QInputDevice::Capability::Hover,
            1, 3, QString(), QPointingDeviceUniqueId::fromNumericId(4711));
    };
    static const QPointingDevice* const kPen = make(QPointingDevice::PointerType::Pen, 71);
    static const QPointingDevice* const kEraser = make(QPointingDevice::PointerType::Eraser, 72);
    return eraser ? *kEraser : *kPen;
}

}  // namespace

void WindowTest::SetUp() {
    auto load = loadLibrary(std::string(EDGEWRIGHT_SOURCE_DIR) + "/resources/templates");
    ASSERT_TRUE(load) << load.error().message;
    ASSERT_TRUE(load->problems.empty()) << load->problems.front().message;
    appearance_ = std::make_unique<Appearance>();
    appearance_->setMode(Appearance::Mode::Light);
    window_ = std::make_unique<MainWindow>(
        load->library, *appearance_,
        MainWindowOptions{.remember = false, .workFolder = workFolder_, .recentList = recentList_});
    window_->files().setQuestion([] { return FileActions::Answer::Discard; });
    window_->applyController().setAutomatic(false);
    window_->resize(1280, 860);
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
    // Shortcuts belong to the active window, and there may be no window manager to say so.
    window_->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
    settle();
}

void WindowTest::TearDown() {
    window_.reset();
    appearance_.reset();
}

QWidget& WindowTest::surface() { return window_->viewport(); }

QPointF WindowTest::nativeLocal(const Vec2& at) {
    const QPointF inWindow = surface().mapTo(window_.get(), QPointF(at.x(), at.y()));
    return inWindow * window_->windowHandle()->devicePixelRatio();
}

QPointF WindowTest::nativeGlobal(const Vec2& at) {
    return surface().mapToGlobal(QPointF(at.x(), at.y())) *
           window_->windowHandle()->devicePixelRatio();
}

void WindowTest::mouse(QEvent::Type type, const Vec2& at, Qt::MouseButtons buttons,
                       Qt::MouseButton button) {
    clockMs_ += kSampleMs;
    QWindowSystemInterface::handleMouseEvent(window_->windowHandle(), clockMs_, nativeLocal(at),
                                             nativeGlobal(at), buttons, button, type, modifiers_);
    QWindowSystemInterface::sendWindowSystemEvents(QEventLoop::AllEvents);
}

void WindowTest::tablet(const Vec2& at, Qt::MouseButtons buttons) {
    clockMs_ += kSampleMs;
    const double pressure = buttons == Qt::NoButton ? 0.0 : 0.6;
    QWindowSystemInterface::handleTabletEvent(
        window_->windowHandle(), clockMs_, &penDevice(eraserEnd_), nativeLocal(at),
        nativeGlobal(at), buttons, pressure, 0, 0, 0.0, 0.0, 0, modifiers_);
    QWindowSystemInterface::sendWindowSystemEvents(QEventLoop::AllEvents);
}

void WindowTest::press(Hand hand, const Vec2& at, Qt::MouseButton button) {
    if (hand == Hand::Mouse) {
        mouse(QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton);
        mouse(QEvent::MouseButtonPress, at, button, button);
    } else {
        tablet(at, Qt::NoButton);
        tablet(at, button);
    }
}

void WindowTest::move(Hand hand, const Vec2& at, Qt::MouseButton button) {
    if (hand == Hand::Mouse) {
        mouse(QEvent::MouseMove, at, button, Qt::NoButton);
    } else {
        tablet(at, button);
    }
}

void WindowTest::release(Hand hand, const Vec2& at, Qt::MouseButton button) {
    if (hand == Hand::Mouse) {
        mouse(QEvent::MouseButtonRelease, at, Qt::NoButton, button);
    } else {
        tablet(at, Qt::NoButton);
    }
}

void WindowTest::drawLine(Hand hand, const Vec2& from, const Vec2& to) {
    const int steps = std::max(2, static_cast<int>((to - from).norm() / kSampleStepPx));
    press(hand, from);
    for (int i = 1; i <= steps; ++i) {
        move(hand, from + (to - from) * (static_cast<double>(i) / steps));
    }
    release(hand, to);
    settle();
}

void WindowTest::drawLines(Hand hand, const std::vector<std::array<Vec2, 2>>& lines) {
    for (const auto& line : lines) drawLine(hand, line[0], line[1]);
}

void WindowTest::leaveProximity() {
    clockMs_ += kSampleMs;
    QWindowSystemInterface::handleTabletEnterLeaveProximityEvent(nullptr, clockMs_,
                                                                 &penDevice(eraserEnd_), false);
    QWindowSystemInterface::sendWindowSystemEvents(QEventLoop::AllEvents);
}

void WindowTest::key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
    QTest::keyClick(window_->windowHandle(), key, modifiers);
    settle();
}

void WindowTest::settle() {
    QApplication::processEvents();
    window_->reading().refreshNow();
    QApplication::processEvents();
}

std::vector<std::array<Vec2, 2>> WindowTest::boxLines(const Vec3& size) const {
    OrthographicCamera camera;  // looks along (-1, 1, -1): sees right, front and top
    camera.width = window_->document().camera().width;
    camera.height = window_->document().camera().height;
    const auto at = [&](double x, double y, double z) {
        return camera.project({(x - 0.5) * size.x(), (y - 0.5) * size.y(), (z - 0.5) * size.z()});
    };
    const Vec2 corner = at(1, 0, 1);
    return {{corner, at(0, 0, 1)},      {corner, at(1, 1, 1)},      {corner, at(1, 0, 0)},
            {at(0, 0, 1), at(0, 1, 1)}, {at(0, 1, 1), at(1, 1, 1)}, {at(1, 1, 1), at(1, 1, 0)},
            {at(1, 1, 0), at(1, 0, 0)}, {at(1, 0, 0), at(0, 0, 0)}, {at(0, 0, 0), at(0, 0, 1)}};
}

std::vector<std::array<Vec2, 2>> WindowTest::prismLines() const {
    OrthographicCamera camera;
    camera.width = window_->document().camera().width;
    camera.height = window_->document().camera().height;
    const Vec2 a = camera.project({-30, -20, -15});
    const Vec2 b = camera.project({30, -20, -15});
    const Vec2 c = camera.project({0, -20, 35});
    const Vec2 behindB = camera.project({30, 20, -15});
    const Vec2 behindC = camera.project({0, 20, 35});
    return {{a, b}, {b, c}, {c, a}, {b, behindB}, {behindB, behindC}, {behindC, c}};
}

}  // namespace ew::test
