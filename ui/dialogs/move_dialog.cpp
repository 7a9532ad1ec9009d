// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/move_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/number_box.h"
#include "ui/theme/colours.h"

namespace ew {

namespace {

constexpr double kMostMm = 1e6;
constexpr double kMostDegrees = 3600.0;
constexpr double kMostPercent = 100'000.0;
constexpr double kLeastPercent = 0.01;
constexpr int kDecimals = 3;
constexpr int kHundred = 100;
constexpr std::array<char, 3> kAxes{'X', 'Y', 'Z'};

}  // namespace

MoveDialog::MoveDialog(const QString& name, const Vec3& middle, QWidget* parent)
    : QDialog(parent),
      middle_(middle),
      axis_(new QComboBox(this)),
      degrees_(number(0.0, -kMostDegrees, kMostDegrees, tr("\u00b0"), tr("Angle"))),
      percent_(number(kHundred, kLeastPercent, kMostPercent, tr(" %"), tr("Size"))),
      mirror_(new QComboBox(this)),
      copy_(new QCheckBox(tr("Keep the solid and move a &copy"), this)) {
    setWindowTitle(tr("Move \u201c%1\u201d").arg(name));
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(metrics::kSpace);
    auto* form = new QFormLayout;
    form->setSpacing(metrics::kGap);
    for (std::size_t k = 0; k < 3; ++k) {
        const QString axis = QChar::fromLatin1(kAxes[k]);
        by_[k] = number(0.0, -kMostMm, kMostMm, tr(" mm"), tr("Along %1").arg(axis));
        by_[k]->setObjectName(QStringLiteral("moveBy") + axis);
        form->addRow(tr("Along &%1").arg(axis), by_[k]);
        axis_->addItem(tr("about %1").arg(axis));
        mirror_->addItem(tr("across %1").arg(axis));
    }
    mirror_->insertItem(0, tr("not"));
    mirror_->setCurrentIndex(0);
    axis_->setCurrentIndex(2);
    auto* turn = new QHBoxLayout;
    turn->addWidget(degrees_, 1);
    turn->addWidget(axis_);
    degrees_->setObjectName(QStringLiteral("moveDegrees"));
    percent_->setObjectName(QStringLiteral("movePercent"));
    auto* turnLabel = new QLabel(tr("&Turn"), this);
    turnLabel->setBuddy(degrees_);
    form->addRow(turnLabel, turn);
    form->addRow(tr("&Scale to"), percent_);
    form->addRow(tr("&Mirror"), mirror_);
    layout->addLayout(form);
    layout->addWidget(copy_);
    auto* hint =
        new QLabel(tr("It is scaled, turned and mirrored about its middle, then moved."), this);
    hint->setWordWrap(true);
    hint->setForegroundRole(QPalette::PlaceholderText);
    layout->addWidget(hint);
    layout->addStretch(1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    buttons->addButton(tr("M&ove"), QDialogButtonBox::AcceptRole)->setDefault(true);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    by_[0]->setFocus();
    by_[0]->selectAll();
}

NumberBox* MoveDialog::number(double value, double least, double most, const QString& unit,
                              const QString& name) {
    auto* box = new NumberBox(this);
    box->setRange(least, most);
    box->setDecimals(kDecimals);
    box->setValue(value);
    box->setSuffix(unit);
    box->setAlignment(Qt::AlignRight);
    box->setAccessibleName(name);
    return box;
}

BodyMove MoveDialog::move() const {
    BodyMove out;
    out.scale = Vec3::Constant(percent_->value() / kHundred);
    out.axis = Vec3::Unit(axis_->currentIndex());
    out.degrees = degrees_->value();
    if (mirror_->currentIndex() > 0) {
        out.mirror = BodyMove::Mirror{middle_, Vec3::Unit(mirror_->currentIndex() - 1)};
    }
    out.translate = Vec3(by_[0]->value(), by_[1]->value(), by_[2]->value());
    out.copy = copy_->isChecked();
    return out;
}

}  // namespace ew
