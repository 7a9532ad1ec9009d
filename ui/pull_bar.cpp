// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pull_bar.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>

#include "ui/number_box.h"
#include "ui/pull_controller.h"
#include "ui/theme/colours.h"

namespace ew {

namespace {
constexpr double kMostMm = 1e6;
constexpr int kDecimals = 3;
constexpr int kNumberWidth = 130;
}  // namespace

PullBar::PullBar(PullController& pull, QWidget* parent)
    : QWidget(parent),
      pull_(pull),
      hint_(new QLabel(this)),
      distance_(new NumberBox(this)),
      straight_(new QCheckBox(tr("Straight walls"), this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(metrics::kSpace, metrics::kGap, metrics::kSpace, metrics::kGap);
    layout->setSpacing(metrics::kSpace);
    auto* label = new QLabel(tr("Pull by"), this);
    distance_->setObjectName(QStringLiteral("pullDistance"));
    distance_->setRange(-kMostMm, kMostMm);
    distance_->setDecimals(kDecimals);
    distance_->setSuffix(tr(" mm"));
    distance_->setMinimumWidth(kNumberWidth);
    distance_->setAlignment(Qt::AlignRight);
    distance_->setKeyboardTracking(false);
    distance_->setAccessibleName(tr("Distance to pull the face by"));
    straight_->setToolTip(
        tr("The face keeps its outline, and new walls join it to the solid. "
           "Without it, the faces beside it go on as they slant."));
    layout->addWidget(label);
    layout->addWidget(distance_);
    layout->addWidget(straight_);
    layout->addWidget(hint_, 1);
    hint_->setForegroundRole(QPalette::PlaceholderText);
    connect(distance_, &NumberBox::valueChanged, this, [this](double value) {
        if (!refreshing_ && pull_.hasFace()) pull_.pullBy(value);
    });
    connect(straight_, &QCheckBox::toggled, this,
            [this](bool on) { pull_.setWalls(on ? PullWalls::Straight : PullWalls::Follow); });
    connect(&pull, &PullController::changed, this, &PullBar::refresh);
    refresh();
}

void PullBar::refresh() {
    refreshing_ = true;
    distance_->setEnabled(pull_.hasFace());
    distance_->setValue(pull_.distance());
    hint_->setText(pull_.hasFace()
                       ? tr("Type another distance and press Enter; negative goes inwards.")
                       : tr("Drag a face, or click one and type a distance."));
    refreshing_ = false;
}

}  // namespace ew
