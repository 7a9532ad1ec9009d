// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "ui/window_context.h"

class QMenu;
class QWidget;

namespace ew {

class ClassSession;
class FileActions;
class JoinDialog;
class OverviewDialog;

/// A class in the menus: a pupil goes to work in one and leaves it, a teacher looks at how it gets
/// on.
class ClassActions : public QObject {
    Q_OBJECT

  public:
    ClassActions(const WindowContext& context, ClassSession& session, FileActions& files,
                 QWidget* window);

    /// Adds to a menu what can be done now.
    void fill(QMenu* menu);
    /// Shows how a class gets on. On error nothing is shown, and the message bar says why.
    bool showOverview(const QString& folder);
    /// Null where it was not shown yet.
    OverviewDialog* overviewDialog() const { return overview_; }

  private:
    void askToJoin();
    void join(JoinDialog& dialog);
    void askForOverview();

    WindowContext context_;
    ClassSession& session_;
    FileActions& files_;
    QWidget* window_;
    OverviewDialog* overview_ = nullptr;
};

}  // namespace ew
