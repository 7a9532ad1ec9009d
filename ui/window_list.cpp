// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window_list.h"

#include <QFileInfo>

#include "core/document/document.h"
#include "core/document/file_names.h"
#include "ui/actions/file_actions.h"
#include "ui/panels/message_bar.h"
#include "ui/theme/appearance.h"

namespace ew {

namespace {
// A new window beside another one: how far to the lower right [logical px].
constexpr int kOffset = 32;
}  // namespace

WindowList::WindowList(TemplateLibrary library, Appearance& appearance, MainWindowOptions options)
    : library_(std::move(library)), appearance_(appearance), options_(std::move(options)) {}

WindowList::~WindowList() {
    for (MainWindow* window : windows()) delete window;
}

QList<MainWindow*> WindowList::windows() const {
    QList<MainWindow*> there;
    for (const QPointer<MainWindow>& window : windows_) {
        if (window) there.append(window);
    }
    return there;
}

MainWindow* WindowList::make() {
    auto* window = new MainWindow(library_, appearance_, options_);
    window->setAttribute(Qt::WA_DeleteOnClose);
    windows_.removeAll(nullptr);
    windows_.append(window);
    connect(window, &MainWindow::windowsWanted, this, [this, window](const QStringList& paths) {
        if (paths.isEmpty())
            showNew(*window);
        else
            open(paths, *window);
    });
    return window;
}

MainWindow* WindowList::showNew(const MainWindow& beside) {
    MainWindow* window = make();
    window->resize(beside.size());
    window->move(beside.pos() + QPoint(kOffset, kOffset));
    window->leaveStart();
    window->show();
    return window;
}

MainWindow* WindowList::windowOf(const QString& path) const {
    const QFileInfo wanted(path);
    for (MainWindow* window : windows()) {
        const QString shown = window->document().filePath();
        if (!shown.isEmpty() && QFileInfo(shown) == wanted) return window;
    }
    return nullptr;
}

bool WindowList::open(const QStringList& paths, MainWindow& first) {
    bool all = true;
    MainWindow* beside = &first;
    for (const QString& name : paths) {
        const auto path = localFile(name);
        if (!path) {
            beside->messages().showError(path.error());
            all = false;
            continue;
        }
        if (MainWindow* there = windowOf(*path)) {
            there->show();
            there->raise();
            there->activateWindow();
            continue;
        }
        const bool empty =
            beside->document().untouched() && beside->document().filePath().isEmpty();
        MainWindow* window = beside == &first && empty ? beside : showNew(*beside);
        all &= window->files().openPath(*path);
        beside = window;
    }
    return all;
}

bool WindowList::mayCloseAll() {
    for (MainWindow* window : windows()) {
        if (!window->mayClose()) return false;
    }
    return true;
}

}  // namespace ew
