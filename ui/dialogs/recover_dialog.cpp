// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/recover_dialog.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPixmap>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/core_text.h"

namespace ew {

namespace {

constexpr int kPictureWidth = 120;
constexpr int kPictureHeight = 75;
constexpr int kWidth = 520;
constexpr int kHeight = 420;

QPixmap pictureOf(const WorkCopyEntry& entry) {
    QPixmap picture;
    const std::string& png = entry.summary.thumbnail;
    picture.loadFromData(reinterpret_cast<const uchar*>(png.data()), static_cast<uint>(png.size()),
                         "PNG");
    if (!picture.isNull()) {
        return picture.scaled(kPictureWidth, kPictureHeight, Qt::KeepAspectRatio,
                              Qt::SmoothTransformation);
    }
    picture = QPixmap(kPictureWidth, kPictureHeight);
    picture.fill(Qt::transparent);
    return picture;
}

}  // namespace

RecoverDialog::RecoverDialog(const std::vector<WorkCopyEntry>& entries, QWidget* parent)
    : QDialog(parent), list_(new QListWidget(this)) {
    setWindowTitle(tr("Recover documents"));
    auto* layout = new QVBoxLayout(this);
    auto* text = new QLabel(tr("These documents were kept while they were being worked on. What "
                               "is put away stays for 30 days."),
                            this);
    text->setWordWrap(true);
    layout->addWidget(text);
    layout->addWidget(list_, 1);
    list_->setObjectName(QStringLiteral("recoverList"));
    list_->setAccessibleName(tr("Documents that can be recovered"));
    list_->setIconSize({kPictureWidth, kPictureHeight});
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const WorkCopyEntry& entry = entries[i];
        const QString path = entry.note.documentPath;
        QString name = coreText(entry.summary.title);
        if (!path.isEmpty()) name = QFileInfo(path).completeBaseName();
        if (name.isEmpty()) name = tr("Untitled");
        const QString counts = tr("%n step(s)", "", entry.summary.steps) + QStringLiteral(", ") +
                               tr("%n stroke(s) waiting", "", entry.summary.strokes);
        const QString time = QLocale().toString(entry.time.toLocalTime(), QLocale::ShortFormat);
        auto* item =
            new QListWidgetItem(QIcon(pictureOf(entry)), name + '\n' + time + '\n' + counts, list_);
        item->setData(Qt::UserRole, static_cast<qulonglong>(i));
        if (!path.isEmpty()) item->setToolTip(path);
    }
    auto* buttons = new QDialogButtonBox(this);
    open_ = buttons->addButton(tr("&Recover"), QDialogButtonBox::AcceptRole);
    putAway_ = buttons->addButton(tr("&Put away"), QDialogButtonBox::ActionRole);
    buttons->addButton(tr("&Later"), QDialogButtonBox::RejectRole);
    layout->addWidget(buttons);
    connect(open_, &QPushButton::clicked, this, &RecoverDialog::open);
    connect(putAway_, &QPushButton::clicked, this, &RecoverDialog::putAway);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(list_, &QListWidget::itemActivated, this, &RecoverDialog::open);
    connect(list_, &QListWidget::currentRowChanged, this, &RecoverDialog::refresh);
    list_->setCurrentRow(0);
    open_->setDefault(true);
    resize(kWidth, kHeight);
    refresh();
}

void RecoverDialog::refresh() {
    const bool any = list_->currentItem() != nullptr;
    open_->setEnabled(any);
    putAway_->setEnabled(any);
}

void RecoverDialog::open() {
    const QListWidgetItem* item = list_->currentItem();
    if (item == nullptr) return;
    chosen_ = static_cast<std::size_t>(item->data(Qt::UserRole).toULongLong());
    accept();
}

void RecoverDialog::putAway() {
    const QListWidgetItem* item = list_->currentItem();
    if (item == nullptr) return;
    declined_.insert(static_cast<std::size_t>(item->data(Qt::UserRole).toULongLong()));
    delete item;
    if (list_->count() == 0) accept();
}

}  // namespace ew
