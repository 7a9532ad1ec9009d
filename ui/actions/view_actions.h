// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <vector>

#include "ui/viewport/camera_moves.h"
#include "ui/window_context.h"

class QAction;
class QMenu;
class QWidget;

namespace ew {

/// Standard views, fit, what is shown, theme.
class ViewActions : public QObject {
    Q_OBJECT

  public:
    ViewActions(const WindowContext& context, QWidget* window);

    void fill(QMenu* menu);

    void setView(StandardView view);
    /// Bodies and ink, or the start view where there is neither.
    void fitAll();

    std::vector<QAction*> viewActions;  ///< in the order of StandardView
    QAction* fitAction;
    QAction* gridAction;
    QAction* hiddenAction;
    QAction* readingAction;
    QAction* occlusionAction;

  private:
    void fillTheme(QMenu* menu);

    WindowContext context_;
};

}  // namespace ew
