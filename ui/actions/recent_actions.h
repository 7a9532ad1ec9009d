// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/document/recent_files.h"
#include "ui/window_context.h"

class QMenu;
class QWidget;

namespace ew {

class FileActions;
class WorkKeeper;

/// Writes down which files are opened and saved in a window, with a small picture of each, and
/// lists them in a menu.
class RecentActions : public QObject {
    Q_OBJECT

  public:
    /// \param work  makes the pictures; null: there are none.
    RecentActions(const WindowContext& context, FileActions& files, WorkKeeper* work,
                  RecentFiles recent, QWidget* window);

    /// Puts a submenu in, which is filled whenever it opens.
    void addMenuTo(QMenu* menu);
    const RecentFiles& recent() const { return recent_; }

  private:
    void fill(QMenu* menu);
    void used(const QString& path);
    void pictured();

    WindowContext context_;
    FileActions& files_;
    RecentFiles recent_;
    QString path_;  ///< of what the window shows
};

}  // namespace ew
