// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/template_panel.h"

#include <QDesktopServices>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPixmap>
#include <QPushButton>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>

#include "core/document/document.h"
#include "core/document/resources.h"
#include "ui/core_text.h"
#include "ui/template_names.h"
#include "ui/theme/appearance.h"
#include "ui/theme/themed_icon.h"
#include "ui/viewport/solid_picture.h"

namespace ew {

namespace {
constexpr QSize kPicture(58, 48);
// More than this are listed without a picture each.
constexpr std::size_t kMostPictures = 200;
constexpr int kIdRole = Qt::UserRole;
}  // namespace

TemplatePanel::TemplatePanel(Document& document, Appearance& appearance, QWidget* parent)
    : QWidget(parent),
      document_(document),
      appearance_(appearance),
      list_(new QListWidget(this)),
      text_(new QLabel(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::kMargin, metrics::kSpace, metrics::kMargin,
                               metrics::kMargin);
    layout->setSpacing(metrics::kSpace);
    list_->setIconSize(kPicture);
    list_->setUniformItemSizes(true);
    list_->setAccessibleName(tr("Templates"));
    list_->setObjectName(QStringLiteral("templateList"));
    text_->setWordWrap(true);
    text_->setTextFormat(Qt::PlainText);
    text_->setForegroundRole(QPalette::PlaceholderText);
    text_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* open =
        new QPushButton(themedIcon(QStringLiteral("folder")), tr("Open template f&older"), this);
    open->setToolTip(tr("A template file that is put there is used from the next start on."));
    auto* add = new QPushButton(themedIcon(QStringLiteral("add-template")),
                                tr("New tem&plate\u2026"), this);
    add->setObjectName(QStringLiteral("newTemplate"));
    add->setToolTip(
        tr("The solid on screen, or a prism, pyramid or frustum, becomes a shape that drawings can "
           "match."));
    layout->addWidget(list_, 1);
    layout->addWidget(text_);
    layout->addWidget(add);
    layout->addWidget(open);
    connect(list_, &QListWidget::currentRowChanged, this, &TemplatePanel::describe);
    connect(add, &QPushButton::clicked, this, [this] { emit editorWanted({}, true); });
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(list_, &QListWidget::customContextMenuRequested, this, &TemplatePanel::showMenu);
    connect(list_, &QListWidget::itemDoubleClicked, this, [this](const QListWidgetItem* item) {
        const QString id = item->data(kIdRole).toString();
        emit editorWanted(id, !isOwn(id));
    });
    connect(open, &QPushButton::clicked, this, [] {
        if (const auto folder = ensurePersonalTemplateFolder()) {
            QDesktopServices::openUrl(QUrl::fromLocalFile(*folder));
        }
    });
    connect(&appearance, &Appearance::changed, this, &TemplatePanel::refresh);
    connect(&document, &Document::changed, this, [this](DocumentChange what) {
        if (what == DocumentChange::Library) refresh();
    });
    refresh();
}

void TemplatePanel::refresh() {
    const int row = std::max(0, list_->currentRow());
    const TemplateLibrary& library = document_.state().library;
    learnTemplateNames(library);
    // A little off the isometric direction, where corners of a cube would fall on each other.
    OrthographicCamera camera;
    camera.direction = Vec3(-0.55, 1.0, -0.6).normalized();
    list_->clear();
    for (std::size_t i = 0; i < library.size(); ++i) {
        const Template& t = library.at(i);
        auto* item = new QListWidgetItem(coreText(t.name), list_);
        item->setData(kIdRole, QString::fromStdString(t.id));
        if (i >= kMostPictures) continue;
        const QPixmap picture = QPixmap::fromImage(solidPicture(
            t.shape, {}, camera, kPicture, devicePixelRatioF(), appearance_.colours()));
        QIcon icon(picture);
        icon.addPixmap(picture, QIcon::Selected);  // else it is tinted
        item->setIcon(icon);
    }
    list_->setCurrentRow(std::min(row, list_->count() - 1));
    describe();
}

bool TemplatePanel::isOwn(const QString& id) const {
    const auto& own = document_.state().addedTemplates;
    return std::find(own.begin(), own.end(), id.toStdString()) != own.end();
}

void TemplatePanel::showMenu(const QPoint& at) {
    const QListWidgetItem* item = list_->itemAt(at);
    if (item == nullptr) item = list_->currentItem();  // the menu key
    if (item == nullptr) return;
    const QString id = item->data(kIdRole).toString();
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->setToolTipsVisible(true);
    QAction* edit =
        menu->addAction(tr("&Edit\u2026"), this, [this, id] { emit editorWanted(id, false); });
    edit->setObjectName(QStringLiteral("editTemplate"));
    edit->setEnabled(isOwn(id));
    if (!edit->isEnabled()) {
        edit->setToolTip(tr("Only templates of this document can be changed; duplicate this one."));
    }
    menu->addAction(tr("&Duplicate\u2026"), this, [this, id] { emit editorWanted(id, true); })
        ->setObjectName(QStringLiteral("duplicateTemplate"));
    menu->popup(list_->viewport()->mapToGlobal(at));
}

void TemplatePanel::describe() {
    const TemplateLibrary& library = document_.state().library;
    const int row = list_->currentRow();
    if (row < 0 || static_cast<std::size_t>(row) >= library.size()) {
        text_->clear();
        return;
    }
    const Template& t = library.at(static_cast<std::size_t>(row));
    const TemplateRelations& r = t.relations;
    QStringList lines;
    if (!t.description.empty()) lines << coreText(t.description);
    lines << tr("%1 vertices, %2 faces").arg(t.shape.vertices.size()).arg(t.shape.faces.size());
    QStringList relations;
    if (!r.parallel.empty()) relations << tr("%1 parallel").arg(r.parallel.size());
    if (!r.perpendicular.empty()) relations << tr("%1 perpendicular").arg(r.perpendicular.size());
    if (!r.equalLength.empty()) relations << tr("%1 equal length").arg(r.equalLength.size());
    lines << (relations.isEmpty() ? tr("No relations")
                                  : tr("Relations: %1").arg(relations.join(", ")));
    QStringList readings;
    for (const TemplateReading& reading : t.readings) readings << coreText(reading.name);
    if (!readings.isEmpty()) lines << tr("Also read as: %1").arg(readings.join(", "));
    text_->setText(lines.join('\n'));
}

}  // namespace ew
