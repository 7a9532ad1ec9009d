// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/template_editor/rule_list.h"

#include <QSignalBlocker>
#include <algorithm>

#include "ui/theme/themed_icon.h"

namespace ew {

namespace {
constexpr int kIconPx = 16;
}

QString ruleText(const FoundRelation& relation) {
    const QString edges = edgesText(relation.edges);
    switch (relation.kind) {
        case RelationKind::Parallel:
            return RuleList::tr("Parallel: %1").arg(edges);
        case RelationKind::Perpendicular:
            return RuleList::tr("Right angle: %1").arg(edges);
        case RelationKind::EqualLength:
            break;
    }
    return RuleList::tr("Equally long: %1").arg(edges);
}

RuleList::RuleList(TemplateModel& model, QWidget* parent) : QListWidget(parent), model_(model) {
    setAccessibleName(tr("Rules"));
    setObjectName(QStringLiteral("ruleList"));
    setWordWrap(true);
    setTextElideMode(Qt::ElideNone);
    setResizeMode(Adjust);
    setIconSize({kIconPx, kIconPx});
    setMouseTracking(true);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(ScrollPerPixel);
    connect(&model, &TemplateModel::changed, this, [this](DraftChange what) {
        if (what.shape || what.rules) refresh();
    });
    connect(this, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
        model_.setRule(row(item), item->checkState() == Qt::Checked);
    });
    connect(this, &QListWidget::itemEntered, this,
            [this](const QListWidgetItem* item) { emit pointedAt(row(item)); });
    connect(this, &QListWidget::currentRowChanged, this, &RuleList::pointedAt);
    refresh();
}

void RuleList::setReport(const DraftReport& report) {
    report_ = report;
    restyle();
}

void RuleList::setMarkedEdge(const std::optional<TemplateEdge>& edge) {
    marked_ = edge;
    restyle();
    for (int i = 0; edge && i < count(); ++i) {
        if (!item(i)->font().bold()) continue;
        scrollToItem(item(i));
        break;
    }
}

void RuleList::leaveEvent(QEvent* event) {
    QListWidget::leaveEvent(event);
    emit pointedAt(hasFocus() ? currentRow() : -1);
}

void RuleList::refresh() {
    const QSignalBlocker quiet(this);
    const auto& rules = model_.draft().rules;
    const int current = currentRow();
    // Rows are kept where they can be: the list must not jump under the pointer.
    while (count() > static_cast<int>(rules.size())) delete takeItem(count() - 1);
    while (count() < static_cast<int>(rules.size())) {
        auto* row = new QListWidgetItem(this);
        row->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    }
    for (int i = 0; i < count(); ++i) {
        item(i)->setCheckState(rules[static_cast<std::size_t>(i)].on ? Qt::Checked : Qt::Unchecked);
    }
    setCurrentRow(std::min(current, count() - 1));
    restyle();
}

void RuleList::restyle() {
    const QSignalBlocker quiet(this);
    const auto& rules = model_.draft().rules;
    const QPixmap warning = themedIcon(QStringLiteral("warning")).pixmap(kIconPx, kIconPx);
    QIcon mark(warning);
    mark.addPixmap(warning, QIcon::Selected);  // else it is white there
    for (int i = 0; i < count() && static_cast<std::size_t>(i) < rules.size(); ++i) {
        const auto index = static_cast<std::size_t>(i);
        const FoundRelation& relation = rules[index].relation;
        const bool follows = index < report_.follows.size() && report_.follows[index];
        const bool broken = std::any_of(
            report_.faults.begin(), report_.faults.end(),
            [i](const DraftFault& f) { return f.place == DraftFault::Place::Rule && f.rule == i; });
        QString text = ruleText(relation);
        if (follows) text += '\n' + tr("follows from the rules above");
        if (broken) text += '\n' + tr("not true of this shape");
        item(i)->setText(text);
        item(i)->setIcon(broken ? mark : QIcon());
        QFont font = this->font();
        font.setItalic(follows);
        font.setBold(marked_ &&
                     std::any_of(relation.edges.begin(), relation.edges.end(),
                                 [this](const TemplateEdge& e) {
                                     return e == *marked_ || TemplateEdge{e[1], e[0]} == *marked_;
                                 }));
        item(i)->setFont(font);
    }
}

}  // namespace ew
