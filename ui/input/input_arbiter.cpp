// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/input/input_arbiter.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QTabletEvent>
#include <QTouchEvent>
#include <QWheelEvent>
#include <QWidget>
#include <algorithm>
#include <cmath>

namespace ew {

namespace {

// One notch of a wheel is 120 eighths of a degree; it changes the scale by this factor.
constexpr double kZoomPerNotch = 1.15;

// Some drivers never say that the pen left. After this long without a pen event the mouse counts
// again [ms of event time].
constexpr double kPenGoneMs = 600.0;

double timeOf(const QInputEvent& event) { return static_cast<double>(event.timestamp()); }

bool isEraser(const QTabletEvent& event) {
    return event.pointerType() == QPointingDevice::PointerType::Eraser;
}

}  // namespace

InputArbiter::InputArbiter(QWidget* surface, Sink sink)
    : QObject(surface), surface_(surface), sink_(std::move(sink)) {
    surface_->setTabletTracking(true);
    surface_->setMouseTracking(true);
    surface_->setAttribute(Qt::WA_AcceptTouchEvents);
    surface_->installEventFilter(this);
    // Proximity events are sent to the application, not to a widget.
    qApp->installEventFilter(this);
}

bool InputArbiter::eventFilter(QObject* watched, QEvent* event) {
    if (watched == surface_) return surfaceEvent(event);
    switch (event->type()) {
        case QEvent::TabletEnterProximity:
            penNear_ = true;
            break;
        case QEvent::TabletLeaveProximity:
            penNear_ = false;
            if (active_ && (device_ == PenDevice::Pen || device_ == PenDevice::Eraser)) cancel();
            if (sink_.pointer) sink_.pointer({PenPhase::Leave, PenDevice::Pen, {}, {}, 0.0, 0.0});
            break;
        default:
            break;
    }
    return false;
}

bool InputArbiter::surfaceEvent(QEvent* event) {
    switch (event->type()) {
        case QEvent::TabletPress:
        case QEvent::TabletMove:
        case QEvent::TabletRelease:
            return tablet(static_cast<QTabletEvent*>(event));
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick:
        case QEvent::MouseMove:
        case QEvent::MouseButtonRelease:
            return mouse(static_cast<QMouseEvent*>(event));
        case QEvent::Wheel:
            return wheel(static_cast<QWheelEvent*>(event));
        case QEvent::TouchBegin:
        case QEvent::TouchUpdate:
        case QEvent::TouchEnd:
        case QEvent::TouchCancel:
            return touch(static_cast<QTouchEvent*>(event));
        case QEvent::NativeGesture:
            return nativeGesture(static_cast<QNativeGestureEvent*>(event));
        case QEvent::KeyPress:
        case QEvent::KeyRelease:
            return key(event);
        case QEvent::Leave:
            if (!active_) send(PenPhase::Leave, {}, 0.0, 0.0);
            return false;
        case QEvent::FocusOut:
            spaceDown_ = false;
            return false;
        case QEvent::ContextMenu:
            return true;  // the right button orbits
        default:
            return false;
    }
}

PenIntent InputArbiter::intentOf(Qt::MouseButton button, Qt::KeyboardModifiers modifiers,
                                 bool eraser) const {
    if (button == Qt::MiddleButton) {
        return modifiers.testFlag(Qt::ShiftModifier) ? PenIntent::Pan : PenIntent::Orbit;
    }
    if (button == Qt::RightButton) return PenIntent::Orbit;
    if (spaceDown_) return PenIntent::Pan;
    if (modifiers.testFlag(Qt::AltModifier)) return PenIntent::Orbit;
    return eraser ? PenIntent::Erase : PenIntent::Tool;
}

bool InputArbiter::tablet(QTabletEvent* event) {
    event->accept();  // else Qt sends a mouse event as well
    lastPenMs_ = timeOf(*event);
    const PenDevice device = isEraser(*event) ? PenDevice::Eraser : PenDevice::Pen;
    const bool byPen = device_ == PenDevice::Pen || device_ == PenDevice::Eraser;
    const double pressure = std::clamp(event->pressure(), 0.0, 1.0);
    switch (event->type()) {
        case QEvent::TabletPress:
            if (active_) {
                if (byPen) return true;  // a second pen button: the first gesture goes on
                cancel();                // the pen takes over from a palm or a mouse
            }
            penNear_ = true;
            device_ = device;
            intent_ = intentOf(event->button(), event->modifiers(), device == PenDevice::Eraser);
            button_ = event->button();
            active_ = true;
            surface_->setFocus(Qt::MouseFocusReason);
            send(PenPhase::Begin, event->position(), pressure, timeOf(*event));
            return true;
        case QEvent::TabletMove:
            if (active_ && !byPen) return true;
            if (!active_) device_ = device;
            send(active_ ? PenPhase::Update : PenPhase::Hover, event->position(), pressure,
                 timeOf(*event));
            return true;
        default:
            if (!active_ || !byPen || event->button() != button_) return true;
            active_ = false;
            send(PenPhase::End, event->position(), pressure, timeOf(*event));
            return true;
    }
}

bool InputArbiter::mouse(QMouseEvent* event) {
    if (penNear_ && !active_ && timeOf(*event) > lastPenMs_ + kPenGoneMs) penNear_ = false;
    if (event->source() != Qt::MouseEventNotSynthesized || penNear_) return true;
    if (active_ && device_ != PenDevice::Mouse) return true;
    device_ = PenDevice::Mouse;
    switch (event->type()) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick:
            if (active_) return true;
            if (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton &&
                event->button() != Qt::RightButton) {
                return false;
            }
            intent_ = intentOf(event->button(), event->modifiers(), false);
            button_ = event->button();
            active_ = true;
            surface_->setFocus(Qt::MouseFocusReason);
            send(PenPhase::Begin, event->position(), 1.0, timeOf(*event));
            return true;
        case QEvent::MouseMove:
            send(active_ ? PenPhase::Update : PenPhase::Hover, event->position(), 1.0,
                 timeOf(*event));
            return true;
        default:
            if (!active_ || event->button() != button_) return true;
            active_ = false;
            send(PenPhase::End, event->position(), 1.0, timeOf(*event));
            return true;
    }
}

bool InputArbiter::wheel(QWheelEvent* event) {
    event->accept();
    if (active_) return true;
    const double notches = event->angleDelta().y() / 120.0;
    if (notches != 0.0 && sink_.zoom) {
        sink_.zoom({event->position().x(), event->position().y()},
                   std::pow(kZoomPerNotch, notches));
    }
    return true;
}

bool InputArbiter::touch(QTouchEvent* event) {
    event->accept();
    const auto& points = event->points();
    if (penNear_ || active_ || points.size() != 2 || event->type() == QEvent::TouchEnd ||
        event->type() == QEvent::TouchCancel) {
        pinchDistance_ = 0.0;
        return true;
    }
    const QPointF a = points[0].position();
    const QPointF b = points[1].position();
    const QPointF centre = (a + b) / 2.0;
    const double distance = std::hypot(a.x() - b.x(), a.y() - b.y());
    if (pinchDistance_ > 0.0 && distance > 0.0) {
        const QPointF moved = centre - pinchCentre_;
        if (sink_.pan) sink_.pan({moved.x(), moved.y()});
        if (sink_.zoom) sink_.zoom({centre.x(), centre.y()}, distance / pinchDistance_);
    }
    pinchDistance_ = distance;
    pinchCentre_ = centre;
    return true;
}

bool InputArbiter::nativeGesture(QNativeGestureEvent* event) {
    if (event->gestureType() != Qt::ZoomNativeGesture || active_) return false;
    if (sink_.zoom) {
        sink_.zoom({event->position().x(), event->position().y()},
                   std::clamp(1.0 + event->value(), 0.5, 2.0));
    }
    return true;
}

bool InputArbiter::key(QEvent* event) {
    auto* keyEvent = static_cast<QKeyEvent*>(event);
    if (keyEvent->key() == Qt::Key_Space) {
        if (!keyEvent->isAutoRepeat()) spaceDown_ = event->type() == QEvent::KeyPress;
        return true;
    }
    return false;
}

void InputArbiter::cancel() {
    if (!active_) return;
    active_ = false;
    send(PenPhase::Cancel, {}, 0.0, 0.0);
}

void InputArbiter::send(PenPhase phase, const QPointF& position, double pressure, double timeMs) {
    if (!sink_.pointer) return;
    PenEvent event;
    event.phase = phase;
    event.device = device_;
    event.intent = intent_;
    // A hovering eraser shows what it will do before it touches.
    if (phase == PenPhase::Hover) {
        event.intent = device_ == PenDevice::Eraser ? PenIntent::Erase : PenIntent::Tool;
    }
    event.position = {position.x(), position.y()};
    event.pressure = pressure;
    event.timeMs = timeMs;
    sink_.pointer(event);
}

}  // namespace ew
