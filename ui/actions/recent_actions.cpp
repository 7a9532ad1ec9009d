// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/recent_actions.h"

#include <QFileInfo>
#include <QMenu>

#include "ui/actions/file_actions.h"
#include "ui/panels/message_bar.h"
#include "ui/work_keeper.h"

namespace ew {

RecentActions::RecentActions(const WindowContext& context, FileActions& files, WorkKeeper* work,
                             RecentFiles recent, QWidget* window)
    : QObject(window), context_(context), files_(files), recent_(std::move(recent)) {
    connect(&files, &FileActions::fileUsed, this, &RecentActions::used);
    if (work != nullptr) connect(work, &WorkKeeper::pictured, this, &RecentActions::pictured);
}

void RecentActions::addMenuTo(QMenu* menu) {
    QMenu* list = menu->addMenu(tr("Open &recent"));
    list->setToolTipsVisible(true);
    connect(list, &QMenu::aboutToShow, this, [this, list] { fill(list); });
}

void RecentActions::fill(QMenu* menu) {
    constexpr std::size_t kMost = 12;
    menu->clear();
    for (const RecentFile& file : recent_.list()) {
        if (static_cast<std::size_t>(menu->actions().size()) == kMost) break;
        // An ampersand in a name is no shortcut.
        QString name = QFileInfo(file.path).fileName().replace('&', QStringLiteral("&&"));
        if (file.missing) name = tr("%1 (not found)").arg(name);
        QAction* action =
            menu->addAction(name, this, [this, path = file.path] { files_.openAsked(path); });
        action->setToolTip(file.path);
        action->setEnabled(!file.missing);
    }
    if (menu->isEmpty()) menu->addAction(tr("Nothing was opened yet"))->setEnabled(false);
}

void RecentActions::used(const QString& path) {
    path_ = path;
    if (path.isEmpty()) return;
    const bool document = context_.document.filePath() == path;
    const auto ok = recent_.add(path, document ? context_.document.thumbnail() : std::string());
    if (!ok) context_.messages.showError(ok.error());
}

void RecentActions::pictured() {
    // What was only looked at has a picture for the list, too.
    const bool shown = !path_.isEmpty() && !context_.document.isModified();
    if (shown) static_cast<void>(recent_.add(path_, context_.document.thumbnail()));
}

}  // namespace ew
