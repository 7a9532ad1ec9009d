// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <QPointer>
#include <QString>
#include <QStringList>

#include "core/tlib/library.h"
#include "ui/main_window.h"

namespace ew {

class Appearance;

/// The windows of the program. Each has a document of its own; one that is closed is deleted.
class WindowList : public QObject {
    Q_OBJECT

  public:
    /// \param appearance  outlives all windows.
    WindowList(TemplateLibrary library, Appearance& appearance, MainWindowOptions options);
    ~WindowList() override;

    /// A new window, which is not shown yet.
    MainWindow* make();
    /// Opens files, each in a window of its own; one that is open in a window already brings that
    /// to the front. The first one takes the place of a document that nothing was done to.
    /// \param first  the window that is asked for it.
    /// \return false where one of them could not be opened; its window says why.
    bool open(const QStringList& paths, MainWindow& first);
    /// Asks each window; false where one of them stays.
    bool mayCloseAll();
    /// Those that are there, in the order in which they were made.
    QList<MainWindow*> windows() const;

  private:
    MainWindow* windowOf(const QString& path) const;
    MainWindow* showNew(const MainWindow& beside);

    TemplateLibrary library_;
    Appearance& appearance_;
    MainWindowOptions options_;
    QList<QPointer<MainWindow>> windows_;
};

}  // namespace ew
