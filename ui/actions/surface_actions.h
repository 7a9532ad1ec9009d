// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/window_context.h"

class QAction;
class QMenu;
class QWidget;

namespace ew {

class SurfaceController;

/// Fillet, surface and strokes on it. The panel offers the same with numbers.
class SurfaceActions : public QObject {
    Q_OBJECT

  public:
    SurfaceActions(const WindowContext& context, SurfaceController& controller, QWidget* window);

    void fill(QMenu* menu);

    QAction* filletAction;
    QAction* sharpenAction;
    QAction* smoothAction;
    QAction* cageAction;
    QAction* mapAction;
    QAction* unmapAction;

  private:
    QAction* makeAction(const char* icon, const QString& text, const QString& key,
                        const QString& tip);
    void refresh();

    WindowContext context_;
    SurfaceController& controller_;
};

}  // namespace ew
