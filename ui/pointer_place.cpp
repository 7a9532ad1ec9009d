// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pointer_place.h"

#include <QCoreApplication>
#include <QTouchEvent>
#include <QWidget>

namespace ew {

PointerPlace::PointerPlace(QObject* parent) : QObject(parent) {
    QCoreApplication::instance()->installEventFilter(this);
}

bool PointerPlace::isOver(const QWidget& widget) const {
    if (!global_ || !widget.isVisible()) return false;
    return QRectF(widget.rect()).contains(widget.mapFromGlobal(*global_));
}

bool PointerPlace::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonRelease:
        case QEvent::MouseButtonDblClick:
        case QEvent::MouseMove:
        case QEvent::Wheel:
        case QEvent::TabletPress:
        case QEvent::TabletRelease:
        case QEvent::TabletMove:
            global_ = static_cast<QSinglePointEvent*>(event)->globalPosition();
            break;
        case QEvent::TouchBegin:
        case QEvent::TouchUpdate:
            global_ = static_cast<QTouchEvent*>(event)->points().front().globalPosition();
            break;
        case QEvent::Leave:
            // A window, not one of its widgets: the pointer went elsewhere on the screen.
            if (watched->isWindowType()) global_.reset();
            break;
        default:
            break;
    }
    return false;
}

}  // namespace ew
