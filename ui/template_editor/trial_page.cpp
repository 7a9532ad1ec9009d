// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/template_editor/trial_page.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/core_text.h"
#include "ui/input/input_arbiter.h"
#include "ui/panels/candidate_card.h"
#include "ui/template_editor/template_model.h"
#include "ui/template_editor/trial_reading.h"
#include "ui/theme/appearance.h"
#include "ui/viewport/sketch_plane.h"

namespace ew {

namespace {

// A stroke that stays this near to where it began is a click [px].
constexpr double kClickPx = 3.0;
constexpr double kEraseReachPx = 12.0;
constexpr std::size_t kMostCards = 2;

void drawStroke(QPainter& painter, const Stroke& stroke) {
    if (stroke.samples.empty()) return;
    QPainterPath path(toPoint(stroke.samples.front().position));
    for (const PenSample& s : stroke.samples) path.lineTo(toPoint(s.position));
    painter.drawPath(path);
}

bool isClick(const Stroke& stroke) {
    const Vec2& start = stroke.samples.front().position;
    return std::all_of(stroke.samples.begin(), stroke.samples.end(),
                       [&](const PenSample& s) { return (s.position - start).norm() <= kClickPx; });
}

}  // namespace

// TrialCanvas -------------------------------------------------------------------------------------

TrialCanvas::TrialCanvas(TemplateModel& model, TrialReading& reading, Appearance& appearance,
                         QWidget* parent)
    : QWidget(parent), model_(model), reading_(reading), appearance_(appearance) {
    setObjectName(QStringLiteral("trialCanvas"));
    setAccessibleName(tr("Sheet to try the template on"));
    setFocusPolicy(Qt::ClickFocus);
    setCursor(Qt::CrossCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    input_ = std::make_unique<InputArbiter>(
        this, InputArbiter::Sink{[this](const PenEvent& event) { point(event); },
                                 [](const Vec2&, double) {}, [](const Vec2&) {}});
    connect(&model, &TemplateModel::changed, this, qOverload<>(&QWidget::update));
    connect(&reading, &TrialReading::changed, this, qOverload<>(&QWidget::update));
    connect(&appearance, &Appearance::changed, this, qOverload<>(&QWidget::update));
}

TrialCanvas::~TrialCanvas() = default;

void TrialCanvas::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    reading_.setCanvasSize(size());
}

/// Escape gives up the stroke under way; else it is the window's.
void TrialCanvas::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && input_->gestureUnderWay()) {
        input_->cancel();
    } else {
        QWidget::keyPressEvent(event);
    }
}

void TrialCanvas::point(const PenEvent& event) {
    if (event.phase == PenPhase::Hover || event.phase == PenPhase::Leave) return;
    if (event.phase == PenPhase::Cancel) {
        wet_.samples.clear();
        update();
        return;
    }
    if (event.intent == PenIntent::Erase && event.phase != PenPhase::End) {
        model_.eraseTrial(event.position, kEraseReachPx);
    }
    if (event.intent != PenIntent::Tool) return;
    if (event.phase == PenPhase::Begin) {
        wet_.samples.clear();
        startMs_ = event.timeMs;
    } else if (wet_.samples.empty()) {
        return;
    }
    PenSample sample;
    sample.position = event.position;
    sample.pressure = event.pressure;
    const double before = wet_.samples.empty() ? 0.0 : wet_.samples.back().timeMs;
    sample.timeMs = std::max(before, event.timeMs - startMs_);
    if (wet_.samples.size() < kMaxSamplesPerStroke) wet_.samples.push_back(sample);
    if (event.phase == PenPhase::End) endStroke();
    update();
}

void TrialCanvas::endStroke() {
    Stroke done = std::move(wet_);
    wet_ = {};
    const bool room = model_.draft().trial.size() < kMaxPendingStrokes;
    if (!isClick(done) && room && validateStroke(done)) model_.addTrial(std::move(done));
}

void TrialCanvas::paintEvent(QPaintEvent*) {
    const ThemeColours& c = appearance_.colours();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(c.border, 1.0));
    painter.setBrush(c.background);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), metrics::kRadius,
                            metrics::kRadius);
    painter.setBrush(Qt::NoBrush);
    const auto& strokes = model_.draft().trial;
    if (strokes.empty() && wet_.samples.empty()) {
        painter.setPen(c.mutedText);
        painter.drawText(rect().adjusted(metrics::kMargin, 0, -metrics::kMargin, 0),
                         Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Draw the shape here from any side, with pen or mouse, and see what it "
                            "is read as."));
        return;
    }
    painter.setPen(QPen(c.ink, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    for (const Stroke& stroke : strokes) drawStroke(painter, stroke);
    drawStroke(painter, wet_);
    painter.setPen(QPen(c.warning, 1.6));
    for (const Culprit& culprit : reading_.reading().culprits) {
        painter.drawEllipse(toPoint(culprit.at), 8.0, 8.0);
    }
}

// TrialPage ---------------------------------------------------------------------------------------

TrialPage::TrialPage(TemplateModel& model, TrialReading& reading, Appearance& appearance,
                     QWidget* parent)
    : QWidget(parent),
      model_(model),
      reading_(reading),
      appearance_(appearance),
      canvas_(new TrialCanvas(model, reading, appearance, this)),
      verdict_(new QLabel(this)),
      evidence_(new QLabel(this)),
      clear_(new QPushButton(tr("Clear the s&heet"), this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::kSpace, metrics::kSpace, metrics::kSpace, metrics::kSpace);
    layout->setSpacing(metrics::kSpace);
    layout->addWidget(canvas_, 1);
    auto* row = new QHBoxLayout;
    verdict_->setObjectName(QStringLiteral("trialVerdict"));
    verdict_->setWordWrap(true);
    verdict_->setTextFormat(Qt::PlainText);
    QFont bold = font();
    bold.setBold(true);
    verdict_->setFont(bold);
    // Room for two lines, so that a sentence never moves the drawing.
    verdict_->setMinimumHeight(2 * QFontMetrics(bold).lineSpacing());
    row->addWidget(verdict_, 1);
    row->addWidget(clear_);
    layout->addLayout(row);
    evidence_->setWordWrap(true);
    evidence_->setTextFormat(Qt::PlainText);
    evidence_->setForegroundRole(QPalette::PlaceholderText);
    evidence_->setMinimumHeight(evidence_->fontMetrics().lineSpacing());
    layout->addWidget(evidence_);
    auto* cards = new QHBoxLayout;
    cards->setSpacing(metrics::kSpace);
    for (std::size_t i = 0; i < kMostCards; ++i) {
        auto* card = new CandidateCard(static_cast<int>(i), appearance, this);
        card->setCheckable(false);
        card->setFocusPolicy(Qt::NoFocus);
        QSizePolicy keep = card->sizePolicy();
        keep.setRetainSizeWhenHidden(true);
        card->setSizePolicy(keep);
        cards->addWidget(card);
        cards_.push_back(card);
    }
    layout->addLayout(cards);
    connect(clear_, &QPushButton::clicked, &model, &TemplateModel::clearTrial);
    connect(&reading, &TrialReading::changed, this, &TrialPage::refresh);
    connect(&model, &TemplateModel::changed, this, [this](DraftChange what) {
        if (what.trial) clear_->setEnabled(!model_.draft().trial.empty());
    });
    clear_->setEnabled(!model.draft().trial.empty());
    refresh();
}

QString TrialPage::verdict() const { return verdict_->text(); }

void TrialPage::refresh() {
    const Interpretation& reading = reading_.reading();
    verdict_->setText(reading_.sentence());
    verdict_->setForegroundRole(reading_.isAccepted() ? QPalette::WindowText
                                                      : QPalette::BrightText);
    const int own = reading_.candidate();
    QStringList lines;
    if (own >= 0) {
        const Candidate& c = reading.candidates[static_cast<std::size_t>(own)];
        QString evidence = evidenceText(c);
        evidence.front() = evidence.front().toUpper();
        lines << evidence + '.';
        if (!c.notes.empty()) lines << coreText(c.notes.front());
    }
    evidence_->setText(lines.join(' '));
    for (std::size_t i = 0; i < cards_.size(); ++i) {
        const bool there = i < reading.candidates.size();
        cards_[i]->setVisible(there);
        if (!there) continue;
        cards_[i]->show(reading.candidates[i], reading_.camera(),
                        reading.accepted == static_cast<int>(i));
    }
}

}  // namespace ew
