// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/template_editor/fault_list.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/theme/colours.h"
#include "ui/theme/themed_icon.h"

namespace ew {

namespace {

constexpr int kIconPx = 16;

bool same(const DraftFault& a, const DraftFault& b) {
    return a.text == b.text && a.weight == b.weight && a.rule == b.rule && a.id == b.id;
}

}  // namespace

FaultList::FaultList(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("faultList"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
}

void FaultList::show(const std::vector<DraftFault>& faults) {
    // A button must not go away under the pointer for nothing.
    if (lines_ != nullptr &&
        std::equal(faults.begin(), faults.end(), faults_.begin(), faults_.end(), same)) {
        return;
    }
    faults_ = faults;
    setVisible(!faults.empty());
    // It may be the button in it that was clicked.
    if (lines_ != nullptr) {
        lines_->hide();
        lines_->deleteLater();
    }
    lines_ = new QWidget(this);
    auto* lines = new QVBoxLayout(lines_);
    lines->setContentsMargins(0, 0, 0, 0);
    lines->setSpacing(metrics::kGap);
    for (const DraftFault& fault : faults_) addLine(lines, fault);
    lines->addStretch(1);
    layout()->addWidget(lines_);
}

void FaultList::addLine(QVBoxLayout* lines, const DraftFault& fault) {
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::kSpace);
    auto* mark = new QLabel(lines_);
    const bool error = fault.weight == DraftFault::Weight::Error;
    mark->setPixmap(themedIcon(error ? QStringLiteral("warning") : QStringLiteral("help"))
                        .pixmap(kIconPx, kIconPx));
    mark->setAccessibleName(error ? tr("Fault") : tr("Hint"));
    auto* text = new QLabel(fault.text, lines_);
    text->setTextFormat(Qt::PlainText);
    text->setWordWrap(true);
    if (error) text->setForegroundRole(QPalette::BrightText);
    row->addWidget(mark);
    row->addWidget(text, 1);
    if (fault.mend != DraftFault::Mend::None) {
        auto* button = new QPushButton(fault.mendText, lines_);
        button->setObjectName(QStringLiteral("mend"));
        connect(button, &QPushButton::clicked, this, [this, fault] { emit mendWanted(fault); });
        row->addWidget(button);
    }
    lines->addLayout(row);
}

}  // namespace ew
