// SPDX-License-Identifier: GPL-3.0-or-later
// Input as an X server sends it, while frames are slow. The other tests put events in behind the
// place where the platform would merge them.
#include <sys/uio.h>
#include <xcb/xcb.h>
#include <xcb/xcbext.h>

#include <QApplication>
#include <QTest>
#include <QWindow>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>

#include "tests/ui/window_fixture.h"
#include "ui/viewport/viewport_widget.h"

namespace ew::test {
namespace {

/// A pointer of the X server that is moved by its XTEST extension.
class ServerPointer {
  public:
    ServerPointer() : connection_(xcb_connect(nullptr, nullptr)) {}
    ~ServerPointer() { xcb_disconnect(connection_); }
    ServerPointer(const ServerPointer&) = delete;
    ServerPointer& operator=(const ServerPointer&) = delete;

    bool usable() {
        if (xcb_connection_has_error(connection_) != 0) return false;
        const auto* data = xcb_get_extension_data(connection_, &xtest_);
        return data != nullptr && data->present != 0;
    }
    void moveTo(const QPoint& px) { fake(XCB_MOTION_NOTIFY, 0, px); }
    void press() { fake(XCB_BUTTON_PRESS, 1, {}); }
    void release() { fake(XCB_BUTTON_RELEASE, 1, {}); }
    /// All of it has happened, and whoever listens was sent its events.
    void finish() {
        std::unique_ptr<xcb_get_input_focus_reply_t, decltype(&std::free)> reply(
            xcb_get_input_focus_reply(connection_, xcb_get_input_focus(connection_), nullptr),
            &std::free);
    }

  private:
    /// XTestFakeInput, as its protocol has it.
    struct FakeInput {
        std::uint8_t major = 0;
        std::uint8_t minor = 2;
        std::uint16_t length = 9;
        std::uint8_t type = 0;
        std::uint8_t detail = 0;
        std::uint16_t pad0 = 0;
        std::uint32_t time = 0;
        std::uint32_t root = XCB_NONE;
        std::uint32_t pad1[2] = {0, 0};
        std::int16_t x = 0;
        std::int16_t y = 0;
        std::uint8_t pad2[7] = {};
        std::uint8_t device = 0;
    };
    void fake(std::uint8_t type, std::uint8_t detail, const QPoint& px) {
        FakeInput request;
        request.type = type;
        request.detail = detail;
        request.x = static_cast<std::int16_t>(px.x());
        request.y = static_cast<std::int16_t>(px.y());
        // Two places before the parts are xcb's own.
        std::array<iovec, 4> parts{};
        parts[2] = {&request, sizeof request};
        parts[3] = {nullptr, 0};
        const xcb_protocol_request_t protocol{2, &xtest_, 2, 1};
        xcb_send_request(connection_, 0, parts.data() + 2, &protocol);
    }

    xcb_connection_t* connection_;
    xcb_extension_t xtest_{"XTEST", 0};
};

class SlowFrames : public WindowTest {
  protected:
    QPoint onScreen(const Vec2& at) {
        return (surface().mapToGlobal(QPointF(at.x(), at.y())) *
                window_->windowHandle()->devicePixelRatio())
            .toPoint();
    }
};

TEST_F(SlowFrames, AMouseStrokeKeepsEverySample) {
    ServerPointer pointer;
    if (QGuiApplication::platformName() != "xcb" || !pointer.usable()) {
        GTEST_SKIP() << "needs an X server with XTEST";
    }
    // A corner, with all of it waiting when the program looks the next time.
    constexpr int kSteps = 60;
    pointer.moveTo(onScreen({100, 100}));
    pointer.press();
    for (int i = 1; i <= kSteps; ++i) pointer.moveTo(onScreen({100.0 + 3 * i, 100.0}));
    for (int i = 1; i <= kSteps; ++i) pointer.moveTo(onScreen({100.0 + 3 * kSteps, 100.0 + 3 * i}));
    pointer.release();
    pointer.finish();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !document().pendingStrokes().empty(); }, 20000));
    const auto& samples = document().pendingStrokes().front().stroke.samples;
    EXPECT_GE(samples.size(), 2U * kSteps);
    const bool corner = std::any_of(samples.begin(), samples.end(), [](const PenSample& s) {
        return (s.position - Vec2(100.0 + 3 * kSteps, 100.0)).norm() < 2.0;
    });
    EXPECT_TRUE(corner);
}

/// The X server of a test has no pen and no touch screen; what merges their events is known by its
/// switches, which the plugin looks at for each event.
TEST_F(SlowFrames, PenAndTouchAreNotMergedEither) {
    EXPECT_FALSE(QCoreApplication::testAttribute(Qt::AA_CompressHighFrequencyEvents));
    EXPECT_FALSE(QCoreApplication::testAttribute(Qt::AA_CompressTabletEvents));
    // All of them are handled in one turn of the event loop, with no frame in between.
    press(Hand::Pen, {100, 100});
    for (int i = 1; i <= 50; ++i) move(Hand::Pen, {100.0 + 2 * i, 100});
    release(Hand::Pen, {200, 100});
    ASSERT_EQ(document().pendingStrokes().size(), 1U);
    EXPECT_GE(document().pendingStrokes().front().stroke.samples.size(), 51U);
}

}  // namespace
}  // namespace ew::test
