// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointF>
#include <functional>

#include "ui/input/pen_event.h"

class QMouseEvent;
class QTabletEvent;
class QTouchEvent;
class QWheelEvent;
class QNativeGestureEvent;
class QWidget;

namespace ew {

/// The one place where pen, touch and mouse meet. Watches a widget and turns native events into
/// PenEvents; while the pen is near, mouse and touch are ignored; mouse events that Qt makes out of
/// pen or touch are dropped; every pen event is accepted. A gesture that began with one device and
/// intent ends with it.
class InputArbiter : public QObject {
    Q_OBJECT

  public:
    struct Sink {
        std::function<void(const PenEvent&)> pointer;
        /// factor > 1 comes nearer; position [logical px] stays where it is.
        std::function<void(const Vec2& position, double factor)> zoom;
        /// two fingers: movement [logical px].
        std::function<void(const Vec2& delta)> pan;
    };

    /// \param surface  the widget that is drawn on; outlives this.
    InputArbiter(QWidget* surface, Sink sink);

    /// Ends whatever is under way without leaving anything (Escape, focus lost).
    void cancel();
    bool gestureUnderWay() const { return active_; }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool surfaceEvent(QEvent* event);
    bool tablet(QTabletEvent* event);
    bool mouse(QMouseEvent* event);
    bool wheel(QWheelEvent* event);
    bool touch(QTouchEvent* event);
    bool nativeGesture(QNativeGestureEvent* event);
    bool key(QEvent* event);
    void send(PenPhase phase, const QPointF& position, double pressure, double timeMs);
    PenIntent intentOf(Qt::MouseButton button, Qt::KeyboardModifiers modifiers, bool eraser) const;

    QWidget* surface_;
    Sink sink_;
    bool penNear_ = false;
    bool spaceDown_ = false;
    bool active_ = false;
    PenDevice device_ = PenDevice::Mouse;
    PenIntent intent_ = PenIntent::Tool;
    Qt::MouseButton button_ = Qt::NoButton;
    double lastPenMs_ = 0.0;
    double pinchDistance_ = 0.0;
    QPointF pinchCentre_;
};

}  // namespace ew
