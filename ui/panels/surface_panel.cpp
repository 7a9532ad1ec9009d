// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/surface_panel.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/actions/surface_actions.h"
#include "ui/core_text.h"
#include "ui/number_box.h"
#include "ui/surface_controller.h"
#include "ui/theme/colours.h"
#include "ui/theme/themed_icon.h"
#include "ui/tools/tool_box.h"

namespace ew {

namespace {

constexpr int kSliderSteps = 1000;
constexpr double kSmallestShare = 0.002;  // of the largest radius, at the slider's left end
constexpr double kDefaultRadius = 3.0;
constexpr int kListHeight = 96;

/// A number of mm that is typed as a whole before it counts.
QDoubleSpinBox* millimetres(QWidget* parent, double least, double most, int decimals) {
    auto* box = new NumberBox(parent);
    box->setRange(least, most);
    box->setDecimals(decimals);
    box->setSuffix(SurfacePanel::tr(" mm"));
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    return box;
}

}  // namespace

SurfacePanel::SurfacePanel(Document& document, SurfaceController& controller,
                           SurfaceActions& actions, ToolBox& tools, QWidget* parent)
    : QWidget(parent),
      document_(document),
      controller_(controller),
      actions_(actions),
      tools_(tools),
      groups_(new QVBoxLayout(this)) {
    groups_->setContentsMargins(metrics::kMargin, metrics::kSpace, metrics::kMargin,
                                metrics::kMargin);
    groups_->setSpacing(metrics::kSpace);
    buildFillet();
    buildSurface();
    buildStrokes();
    groups_->addStretch(1);
    keepNarrow();
    connect(&document_, &Document::changed, this, [this](DocumentChange what) {
        if (what == DocumentChange::Shape || what == DocumentChange::Ink) refresh();
    });
    connect(&controller_, &SurfaceController::changed, this, &SurfacePanel::refresh);
    connect(&controller_, &SurfaceController::colorChanged, this, &SurfacePanel::refreshColor);
    connect(&controller_.selection(), &EdgeSelection::changed, this, &SurfacePanel::refreshEdges);
    connect(actions_.filletAction, &QAction::triggered, this, &SurfacePanel::commitFillet);
    refresh();
    refreshColor();
}

void SurfacePanel::keepNarrow() {
    constexpr int kLetters = 9;
    for (QComboBox* box : findChildren<QComboBox*>()) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(kLetters);
    }
    for (QAbstractSpinBox* box : findChildren<QAbstractSpinBox*>()) {
        box->setMinimumWidth(box->fontMetrics().averageCharWidth() * kLetters);
    }
    for (QAbstractButton* button : findChildren<QPushButton*>()) {
        button->setMinimumWidth(0);
        button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    }
}

QFormLayout* SurfacePanel::addGroup(const QString& title) {
    auto* heading = new QLabel(QStringLiteral("<b>%1</b>").arg(title.toHtmlEscaped()), this);
    auto* form = new QFormLayout;
    form->setHorizontalSpacing(metrics::kSpace);
    form->setVerticalSpacing(metrics::kGap);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    groups_->addWidget(heading);
    groups_->addLayout(form);
    return form;
}

// Fillet -----------------------------------------------------------------------------------------

void SurfacePanel::buildFillet() {
    QFormLayout* form = addGroup(tr("Fillet"));
    which_ = new QComboBox(this);
    which_->addItems({tr("all"), tr("convex"), tr("concave"), tr("picked")});
    which_->setObjectName(QStringLiteral("edgeChoice"));
    which_->setToolTip(tr("Which edges are meant. Picked edges are clicked in the drawing."));
    mode_ = new QComboBox(this);
    mode_->addItems({tr("one edge"), tr("a loop of edges"), tr("all edges of a face")});
    mode_->setObjectName(QStringLiteral("pickMode"));
    mode_->setToolTip(tr("What a click picks. Shift adds to what is picked, or takes it out."));
    count_ = new QLabel(this);
    form->addRow(tr("Ed&ges"), which_);
    form->addRow(tr("A &click picks"), mode_);
    form->addRow(QString(), count_);
    buildRadius(form);
    auto* buttons = new QHBoxLayout;
    fillet_ = new QPushButton(themedIcon(QStringLiteral("fillet")), tr("Fillet"), this);
    fillet_->setObjectName(QStringLiteral("filletButton"));
    fillet_->setToolTip(actions_.filletAction->toolTip());
    sharpen_ = new QPushButton(tr("Sharp"), this);
    sharpen_->setObjectName(QStringLiteral("sharpenButton"));
    sharpen_->setToolTip(actions_.sharpenAction->toolTip());
    buttons->addWidget(fillet_);
    buttons->addWidget(sharpen_);
    form->addRow(buttons);
    clamped_ = new QListWidget(this);
    clamped_->setObjectName(QStringLiteral("clampedList"));
    clamped_->setAccessibleName(tr("Edges without room for their radius"));
    clamped_->setToolTip(
        tr("Edges without room for their radius, and what is in the way. A click "
           "marks the edge."));
    clamped_->setMaximumHeight(kListHeight);
    clamped_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    clamped_->setWordWrap(true);
    clamped_->setTextElideMode(Qt::ElideNone);
    // Lines are broken anew when the scroll bar takes its place.
    clamped_->setResizeMode(QListView::Adjust);
    clamped_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    form->addRow(clamped_);
    connect(which_, &QComboBox::activated, this, [this](int index) {
        controller_.selection().setWhich(static_cast<EdgeChoice::Which>(index));
        const bool picks = index == static_cast<int>(EdgeChoice::Which::Picked);
        if (picks)
            tools_.setActive(ToolBox::Kind::PickEdge);
        else if (tools_.active() == ToolBox::Kind::PickEdge)
            tools_.setActive(ToolBox::Kind::Pen);
    });
    connect(mode_, &QComboBox::activated, this, [this](int index) {
        tools_.setPickMode(static_cast<PickMode>(index));
        tools_.setActive(ToolBox::Kind::PickEdge);
    });
    connect(fillet_, &QPushButton::clicked, this, &SurfacePanel::commitFillet);
    connect(sharpen_, &QPushButton::clicked, this, [this] { controller_.sharpen(); });
    connect(clamped_, &QListWidget::itemClicked, this, [this](const QListWidgetItem* item) {
        const QPoint edge = item->data(Qt::UserRole).toPoint();
        controller_.selection().pick({{edge.x(), edge.y()}}, false);
    });
}

void SurfacePanel::buildRadius(QFormLayout* form) {
    radiusSlider_ = new QSlider(Qt::Horizontal, this);
    radiusSlider_->setObjectName(QStringLiteral("radiusSlider"));
    radiusSlider_->setRange(0, kSliderSteps);
    radiusSlider_->setAccessibleName(tr("Radius"));
    radius_ = millimetres(this, 0.001, 1e6, 3);
    radius_->setObjectName(QStringLiteral("radiusNumber"));
    radius_->setValue(kDefaultRadius);
    segments_ = new WholeNumberBox(this);
    segments_->setObjectName(QStringLiteral("segmentsNumber"));
    segments_->setRange(1, kMaxFilletSegments);
    segments_->setToolTip(
        tr("Flat pieces across a fillet: 1 is a chamfer, more are rounder. A smooth surface is "
           "round with one or two."));
    const QString explanation =
        tr("Radius of the fillet. Dragging shows it; letting go makes it a step. Where a radius "
           "does not fit, that edge alone gets a smaller one.");
    radiusSlider_->setToolTip(explanation);
    radius_->setToolTip(explanation);
    form->addRow(tr("&Radius"), radius_);
    form->addRow(radiusSlider_);
    form->addRow(tr("Seg&ments"), segments_);
    connect(radiusSlider_, &QSlider::valueChanged, this, [this](int value) {
        if (refreshing_) return;
        const double share = std::pow(
            kSmallestShare, 1.0 - static_cast<double>(value) / static_cast<double>(kSliderSteps));
        const QSignalBlocker quiet(radius_);
        radius_->setValue(share * largestRadius());
        if (radiusSlider_->isSliderDown())
            controller_.previewFillet(radius_->value(), segments_->value());
        else
            commitFillet();
    });
    connect(radiusSlider_, &QSlider::sliderReleased, this, &SurfacePanel::commitFillet);
    connect(radius_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        if (refreshing_) return;
        setRadius(value);
        commitFillet();
    });
    connect(segments_, &QSpinBox::valueChanged, this, [this] {
        // Without a fillet yet the number waits for one.
        if (!refreshing_ && document_.state().surface.hasFillet()) commitFillet();
    });
}

void SurfacePanel::commitFillet() {
    controller_.commitFillet(radius_->value(), segments_->value());
}

double SurfacePanel::largestRadius() const {
    double size = 0.0;
    for (const Body& body : document_.state().bodies) {
        const auto box = body.solid.bounds();
        size = std::max(size, (box[1] - box[0]).maxCoeff());
    }
    return size > 0.0 ? 0.5 * size : 50.0;
}

void SurfacePanel::setRadius(double radius) {
    const QSignalBlocker quietSlider(radiusSlider_);
    const QSignalBlocker quietNumber(radius_);
    radius_->setValue(radius);
    const double share = std::clamp(radius / largestRadius(), kSmallestShare, 1.0);
    const double t = 1.0 - std::log(share) / std::log(kSmallestShare);
    radiusSlider_->setValue(static_cast<int>(std::lround(t * kSliderSteps)));
}

// Refreshing -------------------------------------------------------------------------------------

void SurfacePanel::refresh() {
    refreshEdges();
    refreshClamped();
    refreshSurface();
}

void SurfacePanel::refreshEdges() {
    refreshing_ = true;
    const EdgeSelection& selection = controller_.selection();
    which_->setCurrentIndex(static_cast<int>(selection.choice().which));
    const std::vector<EdgeRef> edges = selection.edges();
    const bool picked = selection.choice().which == EdgeChoice::Which::Picked;
    count_->setText(edges.empty()       ? (picked ? tr("click an edge in the drawing") : tr("none"))
                    : edges.size() == 1 ? tr("1 edge")
                                        : tr("%1 edges").arg(edges.size()));
    const SurfaceSettings& surface = document_.state().surface;
    double radius = 0.0;  // of all of them where they have one in common
    bool filleted = false;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const double r = surface.radius(edges[i]);
        filleted = filleted || r > 0.0;
        radius = i == 0 || r == radius ? r : -1.0;
        if (radius < 0.0) break;
    }
    if (!radiusSlider_->isSliderDown() && !controller_.busy()) {
        setRadius(radius > 0.0 ? radius : radius_->value());
        if (surface.hasFillet()) segments_->setValue(surface.segments);
    }
    for (QWidget* w : {static_cast<QWidget*>(fillet_), static_cast<QWidget*>(radius_),
                       static_cast<QWidget*>(radiusSlider_)}) {
        w->setEnabled(!edges.empty());
    }
    sharpen_->setEnabled(filleted || radius < 0.0);
    setCrease_->setEnabled(!edges.empty());
    refreshing_ = false;
}

void SurfacePanel::refreshClamped() {
    const auto& clamped = controller_.clamped();
    clamped_->clear();
    clamped_->setVisible(!clamped.empty());
    const auto& bodies = document_.state().bodies;
    for (const ClampedEdge& c : clamped) {
        const auto body = static_cast<std::size_t>(c.edge.body);
        if (body >= bodies.size() ||
            static_cast<std::size_t>(c.edge.edge) >= bodies[body].solid.edges().size()) {
            continue;
        }
        auto* item = new QListWidgetItem(coreText(clampText(bodies, c)), clamped_);
        item->setData(Qt::UserRole, QPoint(c.edge.body, c.edge.edge));
    }
}

}  // namespace ew
