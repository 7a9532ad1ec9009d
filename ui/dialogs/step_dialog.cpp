// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/step_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/surface/fillet.h"
#include "ui/core_text.h"
#include "ui/number_box.h"
#include "ui/panels/candidate_card.h"
#include "ui/theme/appearance.h"
#include "ui/viewport/solid_picture.h"

namespace ew {

namespace {

constexpr QSize kPicture{84, 64};
constexpr double kScriptFactor = 0.5;  // of an apply that names none
constexpr double kMostRadius = 1e6;    // [mm]
constexpr double kLeastRadius = 1e-3;
constexpr int kMostLevels = 6;
constexpr double kMostSharpness = 10.0;
constexpr int kReadingsHeight = 240;
constexpr const char* kExact = "exact";
constexpr const char* kShown = "shown";

/// A number that nobody changed is what it was, with all of its digits.
double valueOf(const NumberBox& box) {
    const bool same = box.value() == box.property(kShown).toDouble();
    return same ? box.property(kExact).toDouble() : box.value();
}

}  // namespace

bool StepDialog::canShow(const ScriptStep& step) {
    if (const auto* crease = std::get_if<CreaseStep>(&step)) return crease->sharpness.has_value();
    return std::holds_alternative<ApplyStep>(step) || std::holds_alternative<FilletStep>(step) ||
           std::holds_alternative<SubdivideStep>(step);
}

StepDialog::StepDialog(const DocumentFile& file, const TemplateLibrary& library, int place,
                       const RecordedStep& step, Appearance& appearance, QWidget* parent)
    : QDialog(parent),
      file_(file),
      library_(library),
      place_(place),
      step_(step),
      appearance_(appearance),
      form_(new QFormLayout),
      problem_(new QLabel(this)) {
    auto* layout = new QVBoxLayout(this);
    auto* text = new QLabel(tr("What follows is done again. Steps that no longer fit are named, "
                               "and their strokes are kept."),
                            this);
    text->setWordWrap(true);
    problem_->setWordWrap(true);
    problem_->setObjectName(QStringLiteral("stepProblem"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    accept_ = buttons->addButton(tr("&Change"), QDialogButtonBox::AcceptRole);
    accept_->setDefault(true);
    layout->addWidget(text);
    layout->addLayout(form_);
    layout->addWidget(problem_);
    layout->addWidget(buttons);
    problem_->hide();
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    std::visit(
        [this](const auto& s) {
            if constexpr (requires { show(s); }) show(s);
        },
        step_.step);
    constexpr int kWidth = 420;
    setMinimumWidth(kWidth);
}

NumberBox* StepDialog::number(const QString& name, double value, double least, double most,
                              const QString& unit) {
    auto* box = new NumberBox(this);
    constexpr int kDigits = 3;
    box->setDecimals(kDigits);
    box->setRange(least, most);
    box->setValue(value);
    box->setProperty(kExact, value);
    box->setProperty(kShown, box->value());
    box->setSuffix(unit);
    box->setKeyboardTracking(false);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    form_->addRow(name, box);
    return box;
}

void StepDialog::show(const ApplyStep& step) {
    const Thresholds& t = step_.view.thresholds;
    distance_ = number(tr("Distance:"), t.distancePx, kMinDistancePx, kMaxDistancePx, tr(" px"));
    angle_ = number(tr("Angle:"), t.angleDeg, kMinAngleDeg, kMaxAngleDeg, QStringLiteral("\u00b0"));
    factor_ = number(tr("Oblique factor:"), step.obliqueFactor.value_or(kScriptFactor),
                     kMinObliqueFactor, kMaxObliqueFactor, {});
    readings_ = new QListWidget(this);
    readings_->setObjectName(QStringLiteral("stepReadings"));
    readings_->setAccessibleName(tr("Readings"));
    readings_->setIconSize(kPicture);
    readings_->setMinimumHeight(kReadingsHeight);
    form_->addRow(readings_);
    for (NumberBox* box : {distance_, angle_, factor_}) {
        connect(box, &NumberBox::valueChanged, this, &StepDialog::read);
    }
    connect(readings_, &QListWidget::itemDoubleClicked, this, &QDialog::accept);
    read();
}

void StepDialog::show(const FilletStep& step) {
    value_ = number(tr("Radius:"), step.radius, kLeastRadius, kMostRadius, tr(" mm"));
    if (!step.segments) return;
    count_ = new WholeNumberBox(this);
    count_->setRange(1, kMaxFilletSegments);
    count_->setValue(*step.segments);
    form_->addRow(tr("Segments:"), count_);
}

void StepDialog::show(const CreaseStep& step) {
    value_ = number(tr("Sharpness:"), *step.sharpness, 0.0, kMostSharpness, {});
}

void StepDialog::show(const SubdivideStep& step) {
    if (step.tolerance) {
        value_ = number(tr("Tolerance:"), *step.tolerance, kLeastRadius, kMostRadius, tr(" mm"));
        return;
    }
    count_ = new WholeNumberBox(this);
    count_->setRange(0, kMostLevels);
    count_->setValue(step.levels.value_or(0));
    form_->addRow(tr("Levels:"), count_);
}

Thresholds StepDialog::wantedThresholds() const { return {valueOf(*distance_), valueOf(*angle_)}; }

void StepDialog::read() {
    QGuiApplication::setOverrideCursor(Qt::WaitCursor);
    const auto reading =
        readingsOfStep(file_, library_, place_, wantedThresholds(), valueOf(*factor_));
    QGuiApplication::restoreOverrideCursor();
    if (reading) fillReadings(*reading);
    const bool any = reading && !reading->candidates.empty();
    accept_->setEnabled(any);
    problem_->setVisible(!any);
    if (any) return;
    const Error none{Errc::NoMatch, "No template matches this drawing.", {}};
    problem_->setText(
        coreText(reading ? reading->problem.value_or(none).message : reading.error().message));
}

void StepDialog::fillReadings(const Interpretation& reading) {
    readings_->clear();
    for (const Candidate& c : reading.candidates) {
        QString name = coreText(c.templateName);
        const QString operation = operationText(c.operation);
        if (!operation.isEmpty()) name = tr("%1, %2").arg(name, operation);
        const QString how = coreText(c.readingName);
        const QString fit = tr("fit %1 %").arg(qRound(c.score * 100));
        const QString detail = how.isEmpty() ? fit : QStringLiteral("%1 \u00b7 %2").arg(how, fit);
        const QPixmap picture =
            QPixmap::fromImage(solidPicture(c.spec, c.pose, step_.view.camera, kPicture,
                                            devicePixelRatioF(), appearance_.colours()));
        QIcon icon(picture);
        icon.addPixmap(picture, QIcon::Selected);  // else it is tinted
        new QListWidgetItem(icon, name + '\n' + detail, readings_);
    }
    const auto* apply = std::get_if<ApplyStep>(&step_.step);
    const int wanted = apply->candidate.value_or(reading.accepted.value_or(0));
    readings_->setCurrentRow(wanted < readings_->count() ? wanted : 0);
}

StepChange StepDialog::change() const {
    StepChange out{place_, step_.step, std::nullopt};
    if (auto* apply = std::get_if<ApplyStep>(&out.step)) {
        out.thresholds = wantedThresholds();
        apply->candidate = std::max(0, readings_->currentRow());
        apply->obliqueFactor.reset();
        if (valueOf(*factor_) != kScriptFactor) apply->obliqueFactor = valueOf(*factor_);
    } else if (auto* fillet = std::get_if<FilletStep>(&out.step)) {
        fillet->radius = valueOf(*value_);
        if (count_ != nullptr) fillet->segments = count_->value();
    } else if (auto* crease = std::get_if<CreaseStep>(&out.step)) {
        crease->sharpness = valueOf(*value_);
    } else if (auto* surface = std::get_if<SubdivideStep>(&out.step)) {
        if (value_ != nullptr) surface->tolerance = valueOf(*value_);
        if (count_ != nullptr) surface->levels = count_->value();
    }
    return out;
}

}  // namespace ew
