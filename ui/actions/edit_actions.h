// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/window_context.h"

class QAction;
class QMenu;
class QWidget;

namespace ew {

/// Undo, redo, clearing, deleting and the choice of tool.
class EditActions : public QObject {
    Q_OBJECT

  public:
    EditActions(const WindowContext& context, QWidget* window);

    void fill(QMenu* menu);

    QAction* undoAction;
    QAction* redoAction;
    QAction* clearAction;
    QAction* deleteAction;
    QList<QAction*> toolActions;  ///< in the order of ToolBox::Kind

  private:
    void undo();
    void redo();
    void deleteChosen();
    void cancel();
    void addTools();
    void refresh();

    WindowContext context_;
    QWidget* window_;
};

}  // namespace ew
