// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/template_editor/confusion_page.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "ui/core_text.h"
#include "ui/template_editor/confusion_run.h"
#include "ui/theme/colours.h"

namespace ew {

namespace {

constexpr int kLookMs = 100;
constexpr int kWhole = 1000;
enum Column { Drawn, AsItself, Asked, Refused, AsOthers, Columns };

QString percent(int part, int whole) {
    if (whole == 0) return QStringLiteral("\u2013");
    return ConfusionPage::tr("%1 %").arg(qRound(100.0 * part / whole));
}

}  // namespace

ConfusionPage::ConfusionPage(ConfusionRun& run, TemplateChecker& checker, QWidget* parent)
    : QWidget(parent),
      run_(run),
      checker_(checker),
      text_(new QLabel(this)),
      table_(new QTableWidget(0, Columns, this)),
      progress_(new QProgressBar(this)),
      start_(new QPushButton(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::kSpace, metrics::kSpace, metrics::kSpace, metrics::kSpace);
    layout->setSpacing(metrics::kSpace);
    text_->setWordWrap(true);
    text_->setTextFormat(Qt::PlainText);
    text_->setForegroundRole(QPalette::PlaceholderText);
    layout->addWidget(text_);
    table_->setObjectName(QStringLiteral("confusionTable"));
    table_->setAccessibleName(tr("What drawings are read as"));
    table_->setHorizontalHeaderLabels(
        {tr("Drawn"), tr("read as it"), tr("asked about"), tr("not read"), tr("read as another")});
    table_->verticalHeader()->hide();
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionMode(QAbstractItemView::NoSelection);
    table_->setFocusPolicy(Qt::NoFocus);
    table_->setWordWrap(true);
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setStretchLastSection(true);
    layout->addWidget(table_, 1);
    auto* row = new QHBoxLayout;
    progress_->setRange(0, kWhole);
    QSizePolicy keep = progress_->sizePolicy();
    keep.setRetainSizeWhenHidden(true);
    progress_->setSizePolicy(keep);
    row->addWidget(progress_, 1);
    start_->setObjectName(QStringLiteral("confusionStart"));
    row->addWidget(start_);
    layout->addLayout(row);
    connect(start_, &QPushButton::clicked, this, [this] {
        if (run_.isRunning())
            run_.cancel();
        else
            run_.start();
    });
    look_.setInterval(kLookMs);
    connect(&look_, &QTimer::timeout, this,
            [this] { progress_->setValue(static_cast<int>(run_.done() * kWhole)); });
    connect(&run, &ConfusionRun::changed, this, &ConfusionPage::refresh);
    connect(&checker, &TemplateChecker::reportChanged, this, &ConfusionPage::refresh);
    refresh();
}

QString ConfusionPage::nameOf(const std::string& id) const {
    if (id == run_.draftId()) return tr("This template");
    const int place = checker_.others().find(id);
    if (place < 0) return coreText(id);
    return coreText(checker_.others().at(static_cast<std::size_t>(place)).name);
}

void ConfusionPage::fillTable() {
    const auto& rows = run_.rows();
    table_->setRowCount(static_cast<int>(rows.size()));
    for (int r = 0; r < table_->rowCount(); ++r) {
        const ConfusionRow& row = rows[static_cast<std::size_t>(r)];
        QStringList others;
        for (const auto& [id, count] : row.readAs) {
            if (id == row.templateId) continue;
            others << tr("%1: %2").arg(nameOf(id), percent(count, row.drawings));
        }
        const QString cells[Columns] = {
            nameOf(row.templateId), percent(row.right(), row.drawings),
            percent(row.asked, row.drawings), percent(row.refused, row.drawings),
            others.isEmpty() ? QStringLiteral("\u2013") : others.join(QStringLiteral(", "))};
        for (int c = 0; c < Columns; ++c) {
            table_->setItem(r, c, new QTableWidgetItem(cells[c]));
            if (c != Drawn && c != AsOthers) table_->item(r, c)->setTextAlignment(Qt::AlignCenter);
        }
    }
    table_->resizeRowsToContents();
}

void ConfusionPage::refresh() {
    const bool running = run_.isRunning();
    progress_->setVisible(running);
    if (running)
        look_.start();
    else
        look_.stop();
    start_->setText(running ? tr("Sto&p") : tr("Dra&w them"));
    start_->setEnabled(running || checker_.report().openFreedoms >= 0);
    if (running) {
        text_->setText(tr("Drawings are made and read\u2026"));
    } else if (run_.rows().empty()) {
        text_->setText(tr("A model of a light hand draws this template, and those that look the "
                          "same from somewhere, %1 times each from random sides, and all are "
                          "read.")
                           .arg(ConfusionRun::kDrawings));
    } else if (run_.isOld()) {
        text_->setText(tr("The template was changed since these were drawn."));
    } else {
        text_->setText(tr("Of %1 drawings of each.").arg(run_.rows().front().drawings));
    }
    fillTable();
}

}  // namespace ew
