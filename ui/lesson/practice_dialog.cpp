// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/practice_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QRandomGenerator>
#include <QSpinBox>
#include <QVBoxLayout>

#include "core/document/practice/practice_shape.h"
#include "ui/lesson/practice_curve.h"
#include "ui/theme/appearance.h"

namespace ew {

namespace {

constexpr int kMostSeed = 9'999;

QString levelText(int level) {
    switch (level) {
        case 1:
            return PracticeDialog::tr("Boxes");
        case 2:
            return PracticeDialog::tr("Prisms, pyramids, frusta");
        case 3:
            return PracticeDialog::tr("Houses, angles, columns");
        case 4:
            return PracticeDialog::tr("Stairs, channels, T-beams");
        default:
            return PracticeDialog::tr("Boxes on boxes");
    }
}

}  // namespace

PracticeDialog::PracticeDialog(Appearance& appearance, const std::vector<PracticeResult>& results,
                               const Choice& choice, QWidget* parent)
    : QDialog(parent), level_(new QSpinBox(this)), seed_(new QSpinBox(this)) {
    setWindowTitle(tr("Practice"));
    auto* layout = new QVBoxLayout(this);
    auto* about = new QLabel(tr("Draw a solid that is shown as it is to be drawn, or from three "
                                "sides. A number is the same solid for everybody in a class."),
                             this);
    about->setWordWrap(true);
    layout->addWidget(about);
    auto* curve = new PracticeCurve(appearance, this);
    curve->setResults(results);
    layout->addSpacing(metrics::kSpace);
    layout->addWidget(curve);
    layout->addSpacing(metrics::kSpace);
    auto* form = new QFormLayout;
    auto* levelRow = new QHBoxLayout;
    auto* kind = new QLabel(levelText(choice.level), this);
    level_->setObjectName(QStringLiteral("practiceLevel"));
    level_->setRange(1, kPracticeLevels);
    level_->setValue(choice.level);
    connect(level_, &QSpinBox::valueChanged, kind,
            [kind](int level) { kind->setText(levelText(level)); });
    levelRow->addWidget(level_);
    levelRow->addWidget(kind, 1);
    auto* seedRow = new QHBoxLayout;
    seed_->setObjectName(QStringLiteral("practiceSeed"));
    seed_->setRange(1, kMostSeed);
    seed_->setValue(static_cast<int>(choice.seed));
    auto* any = new QPushButton(tr("&Any number"), this);
    any->setAutoDefault(false);
    connect(any, &QPushButton::clicked, this,
            [this] { seed_->setValue(QRandomGenerator::global()->bounded(1, kMostSeed + 1)); });
    seedRow->addWidget(seed_);
    seedRow->addWidget(any);
    seedRow->addStretch(1);
    auto* levelLabel = new QLabel(tr("&Level:"), this);
    levelLabel->setBuddy(level_);
    auto* seedLabel = new QLabel(tr("&Number:"), this);
    seedLabel->setBuddy(seed_);
    form->addRow(levelLabel, levelRow);
    form->addRow(seedLabel, seedRow);
    layout->addLayout(form);
    auto* buttons = new QDialogButtonBox(this);
    auto* begin = buttons->addButton(tr("&Begin"), QDialogButtonBox::AcceptRole);
    begin->setObjectName(QStringLiteral("practiceBegin"));
    begin->setDefault(true);
    buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    begin->setFocus();
}

PracticeDialog::Choice PracticeDialog::choice() const {
    return {level_->value(), static_cast<std::uint32_t>(seed_->value())};
}

}  // namespace ew
