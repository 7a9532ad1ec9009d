// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/body_panel.h"

#include <QAction>
#include <QGridLayout>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/body_selection.h"
#include "ui/dialogs/move_dialog.h"
#include "ui/theme/colours.h"

namespace ew {

namespace {
constexpr int kLeastHeight = 72;
}  // namespace

QString shownBodyName(const std::vector<Body>& bodies, std::size_t body) {
    const std::string& name = bodies[body].name;
    return name.empty() ? BodyPanel::tr("Solid %1").arg(body + 1) : QString::fromStdString(name);
}

BodyPanel::BodyPanel(Document& document, BodySelection& selection, QWidget* parent)
    : QWidget(parent),
      document_(document),
      selection_(selection),
      list_(new QListWidget(this)),
      size_(new QLabel(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::kSpace, metrics::kGap, metrics::kSpace, metrics::kSpace);
    layout->setSpacing(metrics::kGap);
    list_->setObjectName(QStringLiteral("bodyList"));
    list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    list_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    list_->setMinimumHeight(kLeastHeight);
    list_->setAccessibleName(tr("Solids"));
    layout->addWidget(list_, 1);
    size_->setObjectName(QStringLiteral("bodySize"));
    size_->setForegroundRole(QPalette::PlaceholderText);
    size_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    size_->setWordWrap(true);
    layout->addWidget(size_);
    addButtons();
    connect(list_, &QListWidget::itemChanged, this, &BodyPanel::itemChanged);
    connect(list_, &QListWidget::itemSelectionChanged, this, [this] {
        if (refreshing_) return;
        std::vector<int> chosen;
        for (const QListWidgetItem* item : list_->selectedItems()) {
            chosen.push_back(list_->row(item));
        }
        selection_.choose(std::move(chosen));
        refreshButtons();
    });
    connect(list_, &QListWidget::customContextMenuRequested, this, &BodyPanel::menuAt);
    connect(&document, &Document::changed, this, [this](DocumentChange what) {
        if (what == DocumentChange::Bodies) refresh();
    });
    connect(&selection, &BodySelection::changed, this, &BodyPanel::refresh);
    refresh();
}

void BodyPanel::addButtons() {
    auto* grid = new QGridLayout;
    grid->setSpacing(metrics::kGap);
    move_ = button(tr("Move\u2026"), tr("Move, turn, scale or mirror the chosen solid by numbers"),
                   &BodyPanel::move);
    duplicate_ = button(tr("Duplicate"), tr("Put a copy of the chosen solid beside it"),
                        &BodyPanel::duplicate);
    join_ = new QPushButton(tr("Join"), this);
    join_->setToolTip(tr("Make one solid of two chosen ones that touch"));
    connect(join_, &QPushButton::clicked, this, [this] { combine(BooleanKind::Add); });
    remove_ = button(tr("Delete"), tr("Delete the chosen solids"), &BodyPanel::remove);
    grid->addWidget(move_, 0, 0);
    grid->addWidget(duplicate_, 0, 1);
    grid->addWidget(join_, 1, 0);
    grid->addWidget(remove_, 1, 1);
    static_cast<QVBoxLayout*>(layout())->addLayout(grid);
}

QPushButton* BodyPanel::button(const QString& text, const QString& tip, void (BodyPanel::*deed)()) {
    auto* made = new QPushButton(text, this);
    made->setToolTip(tip);
    connect(made, &QPushButton::clicked, this, deed);
    return made;
}

void BodyPanel::refresh() {
    refreshing_ = true;
    const std::vector<Body>& bodies = document_.state().bodies;
    while (list_->count() > static_cast<int>(bodies.size()))
        delete list_->takeItem(list_->count() - 1);
    while (list_->count() < static_cast<int>(bodies.size())) {
        auto* item = new QListWidgetItem(list_);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable |
                       Qt::ItemIsEditable);
        item->setToolTip(tr("The check mark shows or hides it; double click to name it."));
    }
    const std::vector<int>& chosen = selection_.chosen();
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        QListWidgetItem* item = list_->item(static_cast<int>(b));
        item->setText(shownBodyName(bodies, b));
        item->setCheckState(bodies[b].hidden ? Qt::Unchecked : Qt::Checked);
        item->setSelected(std::binary_search(chosen.begin(), chosen.end(), static_cast<int>(b)));
    }
    refreshing_ = false;
    refreshButtons();
}

void BodyPanel::refreshButtons() {
    const std::size_t chosen = selection_.chosen().size();
    move_->setEnabled(chosen == 1);
    duplicate_->setEnabled(chosen == 1);
    join_->setEnabled(chosen == 2);
    remove_->setEnabled(chosen > 0);
    refreshSize();
}

/// Of the chosen solid, or of the only one: how far it reaches along the world's axes, and volume.
void BodyPanel::refreshSize() {
    const std::vector<Body>& bodies = document_.state().bodies;
    std::vector<int> chosen = selection_.chosen();
    if (chosen.empty() && bodies.size() == 1) chosen = {0};
    size_->setVisible(chosen.size() == 1);
    if (chosen.size() != 1) return;
    const Body& body = bodies[static_cast<std::size_t>(chosen.front())];
    const auto [low, high] = worldBounds(body);
    const auto text = [this](double x) {
        constexpr int kDigits = 5;
        return locale().toString(x, 'g', kDigits);
    };
    const Vec3 size = high - low;
    size_->setText(tr("%1 \u00d7 %2 \u00d7 %3 mm, volume %4 cm\u00b3")
                       .arg(text(size.x()), text(size.y()), text(size.z()),
                            text(body.solid.volume() / 1000.0)));
}

void BodyPanel::tell(const Result<void>& result) {
    if (!result) emit failed(result.error());
}

void BodyPanel::itemChanged(QListWidgetItem* item) {
    if (refreshing_) return;
    const int body = list_->row(item);
    const std::vector<Body>& bodies = document_.state().bodies;
    const auto place = static_cast<std::size_t>(body);
    const bool visible = item->checkState() == Qt::Checked;
    if (visible == bodies[place].hidden) {
        tell(document_.showBody(body, visible));
    } else if (item->text() != shownBodyName(bodies, place)) {
        tell(document_.nameBody(body, item->text().trimmed().toStdString()));
    }
    refresh();  // what was refused is as it was
}

void BodyPanel::menuAt(const QPoint& place) {
    QListWidgetItem* item = list_->itemAt(place);
    if (item == nullptr) return;
    QMenu menu(this);
    QAction* name = menu.addAction(tr("Name\u2026"));
    const bool shown = item->checkState() == Qt::Checked;
    QAction* show = menu.addAction(shown ? tr("Hide") : tr("Show"));
    menu.addSeparator();
    QAction* moved = menu.addAction(tr("Move\u2026"));
    QAction* copied = menu.addAction(tr("Duplicate"));
    QAction* joined = menu.addAction(tr("Join"));
    QAction* cut = menu.addAction(tr("Subtract the second from the first"));
    menu.addSeparator();
    QAction* removed = menu.addAction(tr("Delete"));
    moved->setEnabled(move_->isEnabled());
    copied->setEnabled(duplicate_->isEnabled());
    joined->setEnabled(join_->isEnabled());
    cut->setEnabled(join_->isEnabled());
    const QAction* picked = menu.exec(list_->viewport()->mapToGlobal(place));
    if (picked == name)
        list_->editItem(item);
    else if (picked == show)
        tell(document_.showBody(list_->row(item), !shown));
    else if (picked == moved)
        move();
    else if (picked == copied)
        duplicate();
    else if (picked == joined || picked == cut)
        combine(picked == cut ? BooleanKind::Cut : BooleanKind::Add);
    else if (picked == removed)
        remove();
}

void BodyPanel::combine(BooleanKind kind) {
    const std::vector<int> chosen = selection_.chosen();
    if (chosen.size() == 2) tell(document_.combineBodies(chosen[0], chosen[1], kind));
}

void BodyPanel::move() {
    const std::vector<int> chosen = selection_.chosen();
    if (chosen.size() != 1) return;
    const std::vector<Body>& bodies = document_.state().bodies;
    const auto body = static_cast<std::size_t>(chosen.front());
    MoveDialog dialog(shownBodyName(bodies, body), middleOf(bodies[body]), this);
    if (dialog.exec() != QDialog::Accepted) return;
    const auto moved = document_.moveBody(chosen.front(), dialog.move());
    if (!moved) return emit failed(moved.error());
    selection_.choose({*moved});
}

void BodyPanel::duplicate() {
    const std::vector<int> chosen = selection_.chosen();
    if (chosen.size() != 1) return;
    const Body& body = document_.state().bodies[static_cast<std::size_t>(chosen.front())];
    // Beside it, along the world's first axis.
    const auto [low, high] = worldBounds(body);
    constexpr double kGap = 1.25;
    BodyMove move;
    move.copy = true;
    move.translate = Vec3(kGap * (high.x() - low.x()), 0, 0);
    const auto made = document_.moveBody(chosen.front(), move);
    if (!made) return emit failed(made.error());
    selection_.choose({*made});
}

void BodyPanel::remove() { tell(selection_.remove()); }

}  // namespace ew
