// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/tlib/template.h"
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
    /// Opens the template editor.
    /// \param id    the template to begin with; empty: the chosen solid, else the first one, else a
    ///     prism.
    /// \param copy  a new template is made of it; one that the document does not own is copied
    ///     anyway.
    void editTemplate(const QString& id, bool copy);

    QAction* applyAction;
    QAction* automaticAction;
    QAction* levelAction;
    QList<QAction*> readingActions;  ///< keys 1 to 9

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void refresh();
    Result<Template> templateToBegin() const;

    WindowContext context_;
    QWidget* window_;
    QAction* templateAction_;
};

}  // namespace ew
