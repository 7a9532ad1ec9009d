// SPDX-License-Identifier: GPL-3.0-or-later
// The lower half of the surface panel: smooth surface and strokes on it.
#include <QAction>
#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QPainter>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QToolButton>

#include "ui/actions/surface_actions.h"
#include "ui/number_box.h"
#include "ui/panels/surface_panel.h"
#include "ui/surface_controller.h"
#include "ui/theme/themed_icon.h"
#include "ui/tools/tool_box.h"

namespace ew {

namespace {

constexpr double kBytesPerMb = 1024.0 * 1024.0;
constexpr int kDefaultMemoryMb = 1024;
constexpr int kMostMemoryMb = 65536;
constexpr double kDefaultTolerance = 0.05;
constexpr int kSwatchPx = 16;

/// 0 to 10, with "auto" below.
QDoubleSpinBox* sharpnessBox(QWidget* parent, const QString& explanation) {
    auto* box = new NumberBox(parent);
    box->setRange(-0.5, kInfiniteSharpness);
    box->setSingleStep(0.5);
    box->setDecimals(1);
    box->setSpecialValueText(SurfacePanel::tr("auto"));
    box->setValue(-0.5);
    box->setToolTip(explanation);
    return box;
}

}  // namespace

void SurfacePanel::buildSurface() {
    QFormLayout* form = addGroup(tr("Smooth surface"));
    smooth_ = new QCheckBox(tr("Smoo&th surface over the solid"), this);
    smooth_->setObjectName(QStringLiteral("smoothSwitch"));
    scheme_ = new QComboBox(this);
    scheme_->addItems({tr("Catmull-Clark"), tr("Loop")});
    scheme_->setObjectName(QStringLiteral("schemeChoice"));
    scheme_->setToolTip(tr("Catmull-Clark works on the faces as they are, Loop on triangles."));
    detail_ = new QComboBox(this);
    detail_->addItems({tr("levels"), tr("tolerance (adaptive)")});
    detail_->setObjectName(QStringLiteral("detailChoice"));
    detail_->setToolTip(
        tr("Levels split every face alike. A tolerance spends triangles where the "
           "surface is curved."));
    levels_ = new WholeNumberBox(this);
    levels_->setObjectName(QStringLiteral("levelsNumber"));
    levels_->setRange(1, kMaxSubdivisionLevels);
    levels_->setValue(SubdivisionSettings{}.levels);
    tolerance_ = new NumberBox(this);
    tolerance_->setObjectName(QStringLiteral("toleranceNumber"));
    tolerance_->setRange(0.001, 1000.0);
    tolerance_->setDecimals(3);
    tolerance_->setValue(kDefaultTolerance);
    tolerance_->setSuffix(tr(" mm"));
    tolerance_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    tolerance_->setToolTip(tr("No point of the surface is farther than this from its triangles."));
    cage_ = new QCheckBox(tr("Sho&w the cage over it"), this);
    form->addRow(smooth_);
    form->addRow(tr("Scheme"), scheme_);
    form->addRow(tr("Detail"), detail_);
    form->addRow(tr("&Levels"), levels_);
    form->addRow(tr("Tolerance"), tolerance_);
    buildCreases(form);
    form->addRow(cage_);
    memory_ = new WholeNumberBox(this);
    memory_->setObjectName(QStringLiteral("memoryNumber"));
    memory_->setRange(1, kMostMemoryMb);
    memory_->setSuffix(tr(" MB"));
    memory_->setToolTip(tr("A surface that would need more is refused."));
    form->addRow(tr("Memory limit"), memory_);
    connectSurface();
}

void SurfacePanel::buildCreases(QFormLayout* form) {
    otherEdges_ = sharpnessBox(
        this, tr("How sharp edges without a fillet stay: 0 is smooth, 10 is sharp for ever. "
                 "Automatic: sharp where anything is filleted, else smooth."));
    otherEdges_->setObjectName(QStringLiteral("sharpnessNumber"));
    chosenEdges_ = sharpnessBox(this, tr("A sharpness of its own for the edges chosen above."));
    chosenEdges_->setObjectName(QStringLiteral("creaseNumber"));
    // Not a push button: styles make these wider than a short word needs.
    setCrease_ = new QToolButton(this);
    setCrease_->setText(tr("Set"));
    setCrease_->setObjectName(QStringLiteral("creaseButton"));
    setCrease_->setToolTip(chosenEdges_->toolTip());
    corners_ = new QCheckBox(tr("&Keep sharp corners in place"), this);
    corners_->setObjectName(QStringLiteral("cornersSwitch"));
    auto* row = new QHBoxLayout;
    row->addWidget(chosenEdges_, 1);
    row->addWidget(setCrease_);
    form->addRow(tr("Sharp edges"), otherEdges_);
    form->addRow(tr("Chosen edges"), row);
    form->addRow(corners_);
}

void SurfacePanel::connectSurface() {
    connect(smooth_, &QCheckBox::clicked, this, [this](bool on) { controller_.setSmooth(on); });
    const auto commit = [this] {
        if (refreshing_) return;
        SubdivisionSettings settings = subdivision();
        settings.on = true;
        controller_.commitSubdivision(settings);
    };
    connect(scheme_, &QComboBox::activated, this, commit);
    connect(detail_, &QComboBox::activated, this, commit);
    connect(levels_, &QSpinBox::valueChanged, this, commit);
    connect(tolerance_, &QDoubleSpinBox::valueChanged, this, commit);
    connect(otherEdges_, &QDoubleSpinBox::valueChanged, this, commit);
    connect(corners_, &QCheckBox::clicked, this, commit);
    connect(setCrease_, &QPushButton::clicked, this, [this] {
        const double value = chosenEdges_->value();
        controller_.crease(value < 0.0 ? kAutomaticSharpness : value);
    });
    connect(cage_, &QCheckBox::toggled, actions_.cageAction, &QAction::setChecked);
    connect(actions_.cageAction, &QAction::toggled, cage_, &QCheckBox::setChecked);
    connect(memory_, &QSpinBox::valueChanged, this, [this](int megabytes) {
        document_.setSurfaceMemoryLimit(static_cast<std::size_t>(megabytes * kBytesPerMb));
        QSettings().setValue(QStringLiteral("surface/memory"), megabytes);
    });
    const int kept = QSettings().value(QStringLiteral("surface/memory"), kDefaultMemoryMb).toInt();
    memory_->setValue(kept);
}

SubdivisionSettings SurfacePanel::subdivision() const {
    SubdivisionSettings s;
    s.on = smooth_->isChecked();
    s.scheme =
        scheme_->currentIndex() == 1 ? SubdivisionScheme::Loop : SubdivisionScheme::CatmullClark;
    s.levels = levels_->value();
    if (detail_->currentIndex() == 1) s.tolerance = tolerance_->value();
    if (otherEdges_->value() >= 0.0) s.sharpness = otherEdges_->value();
    s.sharpCorners = corners_->isChecked();
    return s;
}

void SurfacePanel::refreshSurface() {
    refreshing_ = true;
    const DocumentState& state = document_.state();
    const bool on = state.surface.subdivision.on;
    const SubdivisionSettings& s = controller_.lastSubdivision();
    const bool solid = !state.bodies.empty();
    smooth_->setEnabled(solid);
    smooth_->setChecked(on);
    if (!controller_.busy()) {
        scheme_->setCurrentIndex(s.scheme == SubdivisionScheme::Loop ? 1 : 0);
        detail_->setCurrentIndex(s.tolerance > 0.0 ? 1 : 0);
        if (s.tolerance > 0.0)
            tolerance_->setValue(s.tolerance);
        else
            levels_->setValue(s.levels);
        otherEdges_->setValue(s.sharpness.value_or(otherEdges_->minimum()));
        corners_->setChecked(s.sharpCorners);
    }
    for (QWidget* w : {static_cast<QWidget*>(scheme_), static_cast<QWidget*>(detail_),
                       static_cast<QWidget*>(otherEdges_), static_cast<QWidget*>(corners_),
                       static_cast<QWidget*>(cage_)}) {
        w->setEnabled(on);
    }
    const bool adaptive = detail_->currentIndex() == 1;
    auto* form = qobject_cast<QFormLayout*>(groups_->itemAt(3)->layout());
    for (QWidget* w : {static_cast<QWidget*>(levels_), static_cast<QWidget*>(tolerance_)}) {
        const bool shown = (w == tolerance_) == adaptive;
        w->setVisible(shown);
        w->setEnabled(on);
        if (form != nullptr) form->labelForField(w)->setVisible(shown);
    }
    refreshing_ = false;
}

// Strokes ----------------------------------------------------------------------------------------

void SurfacePanel::buildStrokes() {
    QFormLayout* form = addGroup(tr("Strokes on the surface"));
    draw_ = new QToolButton(this);
    draw_->setObjectName(QStringLiteral("drawOnSurface"));
    draw_->setIcon(themedIcon(QStringLiteral("surface-pen")));
    draw_->setText(tr("Draw on it"));
    draw_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    draw_->setCheckable(true);
    draw_->setToolTip(tr("Every stroke goes straight onto the surface (B)"));
    color_ = new QPushButton(tr("Colour"), this);
    color_->setObjectName(QStringLiteral("strokeColor"));
    color_->setToolTip(tr("Colour of the next strokes on the surface"));
    auto* row = new QHBoxLayout;
    row->addWidget(draw_);
    row->addWidget(color_);
    form->addRow(row);
    auto* buttons = new QHBoxLayout;
    for (QAction* action : {actions_.mapAction, actions_.unmapAction}) {
        const bool maps = action == actions_.mapAction;
        auto* button = new QPushButton(maps ? tr("Map drawing") : tr("Remove"), this);
        button->setToolTip(action->toolTip());
        button->setEnabled(action->isEnabled());
        connect(button, &QPushButton::clicked, action, &QAction::trigger);
        connect(action, &QAction::enabledChanged, button, &QPushButton::setEnabled);
        buttons->addWidget(button);
    }
    form->addRow(buttons);
    connect(draw_, &QToolButton::clicked, this, [this](bool on) {
        tools_.setActive(on ? ToolBox::Kind::SurfacePen : ToolBox::Kind::Pen);
    });
    connect(&tools_, &ToolBox::activeChanged, this,
            [this](ToolBox::Kind kind) { draw_->setChecked(kind == ToolBox::Kind::SurfacePen); });
    connect(color_, &QPushButton::clicked, this, &SurfacePanel::chooseColor);
}

void SurfacePanel::chooseColor() {
    const StrokeColor& now = controller_.strokeColor();
    const QColor chosen =
        QColorDialog::getColor(QColor(now[0], now[1], now[2]), this, tr("Colour of strokes"));
    if (!chosen.isValid()) return;
    controller_.setStrokeColor({static_cast<std::uint8_t>(chosen.red()),
                                static_cast<std::uint8_t>(chosen.green()),
                                static_cast<std::uint8_t>(chosen.blue())});
}

void SurfacePanel::refreshColor() {
    const StrokeColor& c = controller_.strokeColor();
    QPixmap swatch(kSwatchPx, kSwatchPx);
    swatch.fill(QColor(c[0], c[1], c[2]));
    color_->setIcon(swatch);
    tools_.setStrokeColor(c);
}

}  // namespace ew
