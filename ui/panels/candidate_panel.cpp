// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/candidate_panel.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/apply_controller.h"
#include "ui/live_reading.h"
#include "ui/panels/candidate_card.h"
#include "ui/theme/appearance.h"

namespace ew {

namespace {
constexpr double kDepthStep = 0.05;
// While someone draws, pictures of candidates need not follow every frame [ms].
constexpr int kDrawingPauseMs = 150;
}  // namespace

CandidatePanel::CandidatePanel(Document& document, LiveReading& reading, ApplyController& apply,
                               Appearance& appearance, QWidget* parent)
    : QWidget(parent),
      document_(document),
      reading_(reading),
      apply_(apply),
      appearance_(appearance),
      heading_(new QLabel(this)),
      list_(new QWidget),
      automatic_(new QCheckBox(tr("Apply &by itself when clear"), this)),
      applyButton_(new QPushButton(tr("&Apply"), this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::kMargin, metrics::kGap, metrics::kMargin, metrics::kMargin);
    layout->setSpacing(metrics::kSpace);
    heading_->setWordWrap(true);
    heading_->setForegroundRole(QPalette::PlaceholderText);
    layout->addWidget(heading_);
    cardsLayout_ = new QVBoxLayout(list_);
    cardsLayout_->setContentsMargins(0, 0, 0, 0);
    cardsLayout_->setSpacing(6);
    cardsLayout_->addStretch(1);
    auto* scroll = new QScrollArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(list_);
    scroll->viewport()->setAutoFillBackground(false);
    list_->setAutoFillBackground(false);
    layout->addWidget(scroll, 1);
    buildDepthRow();
    layout->addWidget(depthRow_);
    auto* bottom = new QHBoxLayout;
    automatic_->setToolTip(
        tr("When one reading is clearly the best, it becomes a solid about a second "
           "after the pen is lifted."));
    automatic_->setObjectName(QStringLiteral("automatic"));
    automatic_->setChecked(apply.automatic());
    applyButton_->setToolTip(tr("Make a solid of the chosen reading (Enter)"));
    applyButton_->setObjectName(QStringLiteral("applyButton"));
    bottom->addWidget(automatic_, 1);
    bottom->addWidget(applyButton_);
    layout->addLayout(bottom);
    throttle_.setSingleShot(true);
    connect(&throttle_, &QTimer::timeout, this, &CandidatePanel::refresh);
    connect(&apply, &ApplyController::changed, this, [this] {
        if (throttle_.isActive()) return;
        throttle_.start(reading_.strokeUnderWay() ? kDrawingPauseMs : 0);
    });
    connect(automatic_, &QCheckBox::toggled, &apply, &ApplyController::setAutomatic);
    connect(&apply, &ApplyController::automaticChanged, automatic_, &QCheckBox::setChecked);
    connect(applyButton_, &QPushButton::clicked, &apply, &ApplyController::apply);
    refresh();
}

void CandidatePanel::buildDepthRow() {
    depthRow_ = new QWidget(this);
    auto* row = new QHBoxLayout(depthRow_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kSpace);
    auto* label = new QLabel(tr("&Depth"), depthRow_);
    depth_ = new QSlider(Qt::Horizontal, depthRow_);
    depthNumber_ = new QLabel(depthRow_);
    label->setBuddy(depth_);
    const QString explanation =
        tr("The front is taken as drawn. Depth is this many times the length "
           "of the slanted lines.");
    depth_->setRange(static_cast<int>(0.1 / kDepthStep), static_cast<int>(2.0 / kDepthStep));
    depth_->setToolTip(explanation);
    label->setToolTip(explanation);
    depth_->setAccessibleName(tr("Depth of the oblique reading"));
    depthNumber_->setMinimumWidth(depthNumber_->fontMetrics().horizontalAdvance("0.00 x"));
    depthNumber_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row->addWidget(label);
    row->addWidget(depth_, 1);
    row->addWidget(depthNumber_);
    connect(depth_, &QSlider::valueChanged, this, [this](int value) {
        depthNumber_->setText(tr("%1 \u00d7").arg(QLocale().toString(value * kDepthStep, 'f', 2)));
        apply_.setObliqueFactor(value * kDepthStep, !depth_->isSliderDown());
    });
    connect(depth_, &QSlider::sliderReleased, this,
            [this] { apply_.setObliqueFactor(depth_->value() * kDepthStep, true); });
}

void CandidatePanel::refresh() {
    refreshCards();
    refreshDepth();
    const Interpretation& shown = apply_.shown();
    const int count = static_cast<int>(shown.candidates.size());
    applyButton_->setEnabled(!apply_.showsApplied() && count > 0);
    if (count == 0) {
        heading_->setText(tr("What the drawing can mean appears here. Keys 1 to 9 choose."));
    } else if (apply_.showsApplied()) {
        heading_->setText(count > 1 ? tr("Done. Another reading is one key away.") : tr("Done."));
    } else {
        heading_->setText(tr("%n reading(s)", nullptr, count));
    }
}

void CandidatePanel::refreshCards() {
    const Interpretation& shown = apply_.shown();
    const std::size_t count = shown.candidates.size();
    while (cards_.size() < count) {
        const int index = static_cast<int>(cards_.size());
        auto* card = new CandidateCard(index, appearance_, list_);
        card->setObjectName(QStringLiteral("candidate%1").arg(index + 1));
        connect(card, &CandidateCard::clicked, this, [this, index] { apply_.pick(index); });
        connect(card, &CandidateCard::doubleClicked, this, [this, index] {
            apply_.pick(index);
            apply_.apply();
        });
        cardsLayout_->insertWidget(index, card);
        cards_.push_back(card);
    }
    const OrthographicCamera& camera = reading_.sketchCamera();
    for (std::size_t i = 0; i < cards_.size(); ++i) {
        cards_[i]->setVisible(i < count);
        if (i >= count) continue;
        cards_[i]->show(shown.candidates[i], camera, shown.accepted == static_cast<int>(i));
    }
    const int current = apply_.shownCurrent();
    if (current >= 0 && static_cast<std::size_t>(current) < cards_.size()) {
        cards_[static_cast<std::size_t>(current)]->setChecked(true);
    }
}

void CandidatePanel::refreshDepth() {
    const auto& candidates = apply_.shown().candidates;
    const bool oblique = std::any_of(candidates.begin(), candidates.end(), [](const Candidate& c) {
        return c.depth == DepthRule::Oblique;
    });
    depthRow_->setVisible(oblique);
    if (depth_->isSliderDown()) return;
    const QSignalBlocker quiet(depth_);
    depth_->setValue(static_cast<int>(std::lround(document_.obliqueFactor() / kDepthStep)));
    depthNumber_->setText(
        tr("%1 \u00d7").arg(QLocale().toString(document_.obliqueFactor(), 'f', 2)));
}

}  // namespace ew
