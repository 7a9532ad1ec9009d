// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/class_actions.h"

#include <QFileDialog>
#include <QMenu>
#include <QSettings>
#include <QStandardPaths>

#include "core/document/resources.h"
#include "ui/actions/file_actions.h"
#include "ui/core_text.h"
#include "ui/lesson/class_session.h"
#include "ui/lesson/join_dialog.h"
#include "ui/lesson/overview_dialog.h"
#include "ui/panels/message_bar.h"

namespace ew {

namespace {

constexpr const char* kFolder = "class/folder";  // the one that was used last

}  // namespace

ClassActions::ClassActions(const WindowContext& context, ClassSession& session, FileActions& files,
                           QWidget* window)
    : QObject(window), context_(context), session_(session), files_(files), window_(window) {
    connect(&session_, &ClassSession::failed, &context_.messages, &MessageBar::showError);
    connect(&session_, &ClassSession::noticed, &context_.messages, &MessageBar::showNotice);
}

void ClassActions::fill(QMenu* menu) {
    menu->addAction(tr("&Work in a class\u2026"), this, &ClassActions::askToJoin);
    if (session_.joined()) {
        QString name = session_.pupil();
        name.replace('&', QStringLiteral("&&"));
        menu->addAction(tr("&Leave the class (%1)").arg(name), &session_, &ClassSession::leave);
    }
    menu->addAction(tr("&Class overview\u2026"), this, &ClassActions::askForOverview);
}

void ClassActions::askToJoin() {
    JoinDialog dialog(context_.appearance, QSettings().value(kFolder).toString(), window_);
    connect(&dialog, &JoinDialog::joinWanted, this, [this, &dialog] { join(dialog); });
    dialog.exec();
}

void ClassActions::join(JoinDialog& dialog) {
    const auto joined = session_.join(dialog.folder(), dialog.pupil());
    if (!joined) {
        dialog.showProblem(coreText(joined.error().message));
        return;
    }
    QSettings().setValue(kFolder, session_.classFolder());
    dialog.accept();
}

void ClassActions::askForOverview() {
    QString start = session_.classFolder();
    if (start.isEmpty()) start = QSettings().value(kFolder).toString();
    if (start.isEmpty()) {
        start = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    }
    const QString chosen = QFileDialog::getExistingDirectory(window_, tr("Class folder"), start);
    if (!chosen.isEmpty()) showOverview(chosen);
}

bool ClassActions::showOverview(const QString& folder) {
    if (overview_ == nullptr) {
        const auto resources = resourcesFolder();
        overview_ = new OverviewDialog(
            context_.appearance, resources ? *resources + QStringLiteral("/lessons") : QString(),
            window_);
        connect(overview_, &OverviewDialog::workWanted, &files_, &FileActions::lookAt);
    }
    const auto shown = overview_->show(folder);
    if (!shown) {
        context_.messages.showError(shown.error());
        return false;
    }
    QSettings().setValue(kFolder, overview_->folder());
    return true;
}

}  // namespace ew
