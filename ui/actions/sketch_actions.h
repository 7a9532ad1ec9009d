// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/window_context.h"

class QAction;
class QMenu;
class QWidget;

namespace ew {

/// Applying, choosing a reading, templates.
class SketchActions : public QObject {
    Q_OBJECT

  public:
    SketchActions(const WindowContext& context, QWidget* window);

    void fill(QMenu* menu);
    /// Asks for a name and adds the solid as a template.
    void addTemplate();

    QAction* applyAction;
    QAction* automaticAction;
    QAction* levelAction;
    QList<QAction*> readingActions;  ///< keys 1 to 9

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void refresh();

    WindowContext context_;
    QWidget* window_;
    QAction* templateAction_;
};

}  // namespace ew
