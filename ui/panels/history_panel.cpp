// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/history_panel.h"

#include <QContextMenuEvent>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QListView>
#include <QMenu>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QUndoStack>
#include <QVBoxLayout>

#include "core/document/document.h"
#include "core/document/step_names.h"
#include "ui/core_text.h"
#include "ui/dialogs/step_dialog.h"
#include "ui/panels/history_model.h"
#include "ui/theme/appearance.h"

namespace ew {

HistoryPanel::HistoryPanel(Document& document, Appearance& appearance, QWidget* parent)
    : QWidget(parent),
      document_(document),
      appearance_(appearance),
      model_(new HistoryModel(document, appearance, this)),
      list_(new QListView(this)),
      name_(new QPushButton(tr("Name\u2026"), this)),
      change_(new QPushButton(tr("Change\u2026"), this)),
      takeBack_(new QPushButton(tr("Take the change back"), this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::kMargin, metrics::kSpace, metrics::kMargin,
                               metrics::kMargin);
    layout->setSpacing(metrics::kSpace);
    list_->setModel(model_);
    list_->setIconSize(HistoryModel::kPicture);
    list_->setUniformItemSizes(true);
    list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    list_->setAccessibleName(tr("History"));
    list_->setObjectName(QStringLiteral("historyList"));
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    list_->viewport()->installEventFilter(this);
    name_->setToolTip(tr("Gives this state a name (F2)."));
    change_->setToolTip(tr("Changes the step that made this state, and does again what follows."));
    takeBack_->setToolTip(tr("Brings back the history as it was before a step was changed."));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(name_, 1);
    buttons->addWidget(change_, 1);
    layout->addWidget(list_, 1);
    layout->addWidget(takeBack_);
    layout->addLayout(buttons);
    auto* rename = new QAction(this);
    rename->setShortcut(QKeySequence(Qt::Key_F2));
    rename->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    addAction(rename);
    connect(rename, &QAction::triggered, this, [this] { nameState(currentRow()); });
    connect(name_, &QPushButton::clicked, this, [this] { nameState(currentRow()); });
    connect(change_, &QPushButton::clicked, this, [this] { changeStep(currentRow()); });
    connect(takeBack_, &QPushButton::clicked, this, [this] { document_.takeBackHistory(); });
    connect(list_, &QListView::customContextMenuRequested, this, &HistoryPanel::menuAt);
    connect(list_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& now) {
                if (!refreshing_ && now.isValid()) goTo(now.row());
            });
    connect(&document, &Document::changed, this, [this](DocumentChange what) {
        if (what == DocumentChange::History) refresh();
        // Any other change ends what could be taken back.
        if (takeBack_->isVisibleTo(this)) refreshButtons();
    });
    refresh();
}

int HistoryPanel::currentRow() const { return document_.undoStack().index(); }

void HistoryPanel::refresh() {
    refreshing_ = true;
    model_->setPixelRatio(devicePixelRatioF());
    model_->refresh();
    const QModelIndex now = model_->index(currentRow());
    list_->setCurrentIndex(now);
    list_->scrollTo(now);
    refreshing_ = false;
    refreshButtons();
}

void HistoryPanel::refreshButtons() {
    change_->setEnabled(currentRow() > 0);
    takeBack_->setVisible(document_.canTakeBackHistory());
}

void HistoryPanel::goTo(int row) {
    if (row < 0 || row == document_.undoStack().index()) return;
    if (auto done = document_.goToStep(row); !done) emit failed(done.error());
}

bool HistoryPanel::eventFilter(QObject* watched, QEvent* event) {
    // The right button opens the menu of a state and does not go there.
    if (event->type() == QEvent::MouseButtonPress) {
        return static_cast<QMouseEvent*>(event)->button() == Qt::RightButton;
    }
    return QWidget::eventFilter(watched, event);
}

bool HistoryPanel::canChange(int row) const {
    if (row < 1) return false;
    const auto steps = recordedSteps(document_.contents());
    const auto& step = steps[static_cast<std::size_t>(row) - 1];
    return step && StepDialog::canShow(step->step);
}

void HistoryPanel::menuAt(const QPoint& place) {
    const QModelIndex index = list_->indexAt(place);
    const int row = index.isValid() ? index.row() : currentRow();
    QMenu menu;
    menu.addAction(tr("&Go there"), this, [this, row] { goTo(row); })
        ->setEnabled(row != currentRow());
    menu.addAction(tr("Name\u2026"), this, [this, row] { nameState(row); });
    menu.addAction(tr("&Change the step\u2026"), this, [this, row] { changeStep(row); })
        ->setEnabled(canChange(row));
    menu.addSeparator();
    menu.addAction(tr("Co&mpact the history\u2026"), this, &HistoryPanel::compact)
        ->setEnabled(document_.undoStack().count() > 1);
    menu.exec(list_->viewport()->mapToGlobal(place));
}

void HistoryPanel::nameState(int row) {
    bool ok = false;
    const QString name = QInputDialog::getText(
        this, tr("Name of the state"),
        tr("Name of the state after \u201c%1\u201d; empty: none.").arg(model_->stepText(row)),
        QLineEdit::Normal, QString::fromStdString(document_.stateName(row)), &ok);
    if (!ok) return;
    const auto named = document_.nameState(row, name.trimmed().toStdString());
    if (!named) emit failed(named.error());
}

void HistoryPanel::changeStep(int row) {
    if (row < 1) return;
    const DocumentFile file = document_.contents();
    const auto steps = recordedSteps(file);
    const auto& step = steps[static_cast<std::size_t>(row) - 1];
    if (!step || !StepDialog::canShow(step->step)) {
        emit noticed(tr("This step has nothing that could be changed."));
        return;
    }
    StepDialog dialog(file, document_.state().library, row - 1, *step, appearance_, this);
    dialog.setWindowTitle(tr("Change \u201c%1\u201d").arg(model_->stepText(row)));
    if (dialog.exec() == QDialog::Accepted) carryOut(dialog.change());
}

void HistoryPanel::carryOut(const StepChange& change) {
    const int all = document_.undoStack().count() - change.place;
    QProgressDialog progress(tr("Doing again what follows\u2026"), tr("Cancel"), 0, all, this);
    progress.setWindowModality(Qt::WindowModal);
    constexpr int kPatienceMs = 500;
    progress.setMinimumDuration(kPatienceMs);
    auto changed =
        ew::changeStep(document_.contents(), document_.state().library, change, [&](int done, int) {
            progress.setValue(done);
            return !progress.wasCanceled();
        });
    progress.reset();
    if (!changed) {
        if (changed.error().code != Errc::Cancelled) emit failed(changed.error());
        return;
    }
    const HistoryChange told{{}, changed->redone, changed->misfits};
    document_.replaceHistory(*std::move(changed));
    tell(told, change.place);
}

void HistoryPanel::tell(const HistoryChange& change, int place) {
    if (change.misfits.empty()) {
        emit noticed(
            tr("Step %1 was changed, and %n step(s) after it done again.", "", change.redone)
                .arg(place + 1));
        return;
    }
    QStringList lines;
    for (const MisfitStep& misfit : change.misfits) {
        lines << tr("%1. %2: %3")
                     .arg(misfit.place + 1)
                     .arg(shownStepName(QString::fromStdString(misfit.name)),
                          coreText(misfit.error.message));
    }
    QMessageBox box(QMessageBox::Information, tr("Some steps no longer fit"),
                    tr("Step %1 was changed. %n step(s) after it no longer fit and were left out; "
                       "the strokes that they had used are kept.",
                       "", static_cast<int>(change.misfits.size()))
                        .arg(place + 1),
                    QMessageBox::NoButton, this);
    constexpr qsizetype kMostLines = 8;
    box.setInformativeText(lines.mid(0, kMostLines).join('\n'));
    if (lines.size() > kMostLines) box.setDetailedText(lines.join('\n'));
    auto* keep = box.addButton(tr("&Keep"), QMessageBox::AcceptRole);
    const auto* back = box.addButton(tr("Take the change back"), QMessageBox::RejectRole);
    box.setDefaultButton(keep);
    box.exec();
    if (box.clickedButton() == back) document_.takeBackHistory();
}

void HistoryPanel::compact() {
    QMessageBox box(QMessageBox::Question, tr("Compact the history"),
                    tr("Merge the steps between named states?"), QMessageBox::Cancel, this);
    box.setInformativeText(
        tr("Only named states and the one of now stay to go back to; steps that "
           "were undone go. The drawing stays as it is, and the file gets "
           "smaller."));
    const auto* yes = box.addButton(tr("&Compact"), QMessageBox::AcceptRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    if (box.clickedButton() != yes) return;
    const auto done = document_.compactHistory();
    if (!done) emit failed(done.error());
}

}  // namespace ew
