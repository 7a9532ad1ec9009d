// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/history_panel.h"

#include <QListWidget>
#include <QSignalBlocker>
#include <QUndoStack>
#include <QVBoxLayout>

#include "core/document/document.h"
#include "ui/theme/colours.h"

namespace ew {

HistoryPanel::HistoryPanel(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), list_(new QListWidget(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::kMargin, metrics::kSpace, metrics::kMargin,
                               metrics::kMargin);
    layout->addWidget(list_);
    list_->setAccessibleName(tr("History"));
    list_->setObjectName(QStringLiteral("historyList"));
    list_->setToolTip(tr("Click a step to go back or forward to it."));
    list_->setUniformItemSizes(true);
    connect(list_, &QListWidget::currentRowChanged, this, &HistoryPanel::goTo);
    connect(&document, &Document::changed, this, [this](DocumentChange what) {
        if (what == DocumentChange::History) refresh();
    });
    refresh();
}

void HistoryPanel::refresh() {
    const QSignalBlocker quiet(list_);
    const QUndoStack& stack = document_.undoStack();
    list_->clear();
    list_->addItem(tr("Empty document"));
    for (int i = 0; i < stack.count(); ++i) {
        list_->addItem(stack.text(i));
        if (i < stack.index()) continue;
        // What can be redone reads as not there yet.
        list_->item(i + 1)->setForeground(palette().placeholderText());
    }
    list_->setCurrentRow(stack.index());
}

void HistoryPanel::goTo(int row) {
    const int index = document_.undoStack().index();
    if (row < 0 || row == index) return;
    (void)document_.goToStep(row);
}

}  // namespace ew
