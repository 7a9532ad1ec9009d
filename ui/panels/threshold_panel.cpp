// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/threshold_panel.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>

#include "core/document/document.h"
#include "ui/number_box.h"
#include "ui/theme/colours.h"
#include "ui/theme/themed_icon.h"

namespace ew {

namespace {
// Sliders count in steps of half a unit.
constexpr double kStep = 0.5;
constexpr double kLargestDistancePx = 60.0;  // of the slider; the number goes to 100
constexpr double kLargestAngleDeg = 45.0;

int toSlider(double value) { return static_cast<int>(std::lround(value / kStep)); }
}  // namespace

ThresholdPanel::ThresholdPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      automatic_(new QCheckBox(tr("Distance from the drawing"), this)),
      reset_(new QPushButton(tr("Reset"), this)) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(metrics::kMargin, metrics::kGap, metrics::kMargin, metrics::kMargin);
    grid->setHorizontalSpacing(metrics::kSpace);
    grid->setVerticalSpacing(metrics::kGap);
    grid->setColumnStretch(1, 1);
    distance_ = addRow(0, tr("D&istance"), tr(" px"),
                       tr("How far apart two stroke ends may be and still meet in one corner, and "
                          "how far the eraser reaches. It is the ring round the pen tip."));
    angle_ = addRow(1, tr("A&ngle"), tr("\u00b0"),
                    tr("How much two lines may differ in direction and still count as parallel."));
    distance_.slider->setRange(toSlider(1.0), toSlider(kLargestDistancePx));
    distance_.number->setRange(1.0, 100.0);
    angle_.slider->setRange(toSlider(0.5), toSlider(kLargestAngleDeg));
    angle_.number->setRange(0.5, kLargestAngleDeg);
    distance_.slider->setObjectName(QStringLiteral("distanceSlider"));
    angle_.slider->setObjectName(QStringLiteral("angleSlider"));
    distance_.number->setObjectName(QStringLiteral("distanceNumber"));
    angle_.number->setObjectName(QStringLiteral("angleNumber"));
    automatic_->setObjectName(QStringLiteral("automaticDistance"));
    automatic_->setToolTip(
        tr("The distance grows with a large drawing whose lines leave wide gaps. Setting it by "
           "hand ends this; a tick here brings it back."));
    grid->addWidget(automatic_, 2, 0, 1, 2);
    reset_->setObjectName(QStringLiteral("resetThresholds"));
    reset_->setIcon(themedIcon(QStringLiteral("reset")));
    reset_->setToolTip(
        tr("Distance from the drawing, angle back to %1\u00b0").arg(Thresholds{}.angleDeg));
    reset_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    grid->addWidget(reset_, 2, 2, Qt::AlignRight);
    grid->setRowMinimumHeight(2, reset_->sizeHint().height() + metrics::kGap);
    connect(automatic_, &QCheckBox::toggled, this, [this](bool on) {
        if (!refreshing_) document_.setAutomaticDistance(on);
    });
    connect(reset_, &QPushButton::clicked, this, [this] {
        (void)document_.setThresholds({document_.thresholds().distancePx, Thresholds{}.angleDeg});
        document_.setAutomaticDistance(true);
    });
    connect(&document_, &Document::changed, this, [this](DocumentChange what) {
        if (what == DocumentChange::Thresholds) refresh();
    });
    refresh();
}

ThresholdPanel::Row ThresholdPanel::addRow(int row, const QString& name, const QString& unit,
                                           const QString& explanation) {
    Row made{new QSlider(Qt::Horizontal, this), new NumberBox(this)};
    auto* label = new QLabel(name, this);
    label->setBuddy(made.slider);
    label->setToolTip(explanation);
    QString plain = name;
    plain.remove(QLatin1Char('&'));
    for (QWidget* w : {static_cast<QWidget*>(made.slider), static_cast<QWidget*>(made.number)}) {
        w->setToolTip(explanation);
        w->setAccessibleName(tr("%1 threshold").arg(plain));
        w->setAccessibleDescription(explanation);
    }
    made.slider->setPageStep(4);
    made.number->setDecimals(1);
    made.number->setSingleStep(kStep);
    made.number->setSuffix(unit);
    made.number->setAlignment(Qt::AlignRight);
    auto* grid = static_cast<QGridLayout*>(layout());
    grid->addWidget(label, row, 0);
    grid->addWidget(made.slider, row, 1);
    grid->addWidget(made.number, row, 2);
    connect(made.slider, &QSlider::valueChanged, this, [this, made](int value) {
        if (refreshing_) return;
        const QSignalBlocker quiet(made.number);
        made.number->setValue(value * kStep);
        write();
    });
    connect(made.number, &QDoubleSpinBox::valueChanged, this, [this] {
        if (!refreshing_) write();
    });
    return made;
}

void ThresholdPanel::write() {
    (void)document_.setThresholds({distance_.number->value(), angle_.number->value()});
    refresh();
}

void ThresholdPanel::refresh() {
    refreshing_ = true;
    const Thresholds& t = document_.thresholds();
    distance_.number->setValue(t.distancePx);
    distance_.slider->setValue(toSlider(t.distancePx));
    angle_.number->setValue(t.angleDeg);
    angle_.slider->setValue(toSlider(t.angleDeg));
    automatic_->setChecked(document_.automaticDistance());
    reset_->setEnabled(!document_.automaticDistance() || t.angleDeg != Thresholds{}.angleDeg);
    refreshing_ = false;
}

}  // namespace ew
