// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/lesson_panel.h"

#include <QDir>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QProgressBar>
#include <QPushButton>
#include <QResizeEvent>
#include <QSvgRenderer>
#include <QVBoxLayout>
#include <algorithm>

#include "core/document/practice/practice_picture.h"
#include "ui/core_text.h"
#include "ui/lesson/class_session.h"
#include "ui/lesson/lesson_guide.h"
#include "ui/lesson/practice_curve.h"
#include "ui/theme/appearance.h"

namespace ew {

namespace {

constexpr int kLeastPicture = 120;
constexpr int kMostPicture = 300;

QLabel* textLabel(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

QString inWindowsLanguage(const LessonText& text) {
    return QString::fromStdString(textIn(text, QLocale().name().toStdString()));
}

QString starText(int stars) {
    constexpr int kMost = 3;
    return QString(stars, QChar(0x2605)) + QString(kMost - stars, QChar(0x2606));
}

}  // namespace

LessonPanel::LessonPanel(LessonGuide& guide, ClassSession& session, Appearance& appearance,
                         QWidget* parent)
    : QWidget(parent), guide_(guide), session_(session), appearance_(appearance) {
    setObjectName(QStringLiteral("lessonPanel"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::kMargin, metrics::kSpace, metrics::kMargin,
                               metrics::kMargin);
    title_ = textLabel(this);
    QFont bold = font();
    bold.setBold(true);
    title_->setFont(bold);
    place_ = textLabel(this);
    pupil_ = textLabel(this);
    pupil_->setObjectName(QStringLiteral("lessonPupil"));
    progress_ = new QProgressBar(this);
    progress_->setTextVisible(false);
    progress_->setMaximumHeight(6);
    task_ = textLabel(this);
    task_->setObjectName(QStringLiteral("lessonTask"));
    picture_ = new QLabel(this);
    picture_->setObjectName(QStringLiteral("practicePicture"));
    picture_->setAlignment(Qt::AlignCenter);
    said_ = textLabel(this);
    said_->setObjectName(QStringLiteral("lessonSaid"));
    hint_ = new QPushButton(tr("Hint"), this);
    hint_->setObjectName(QStringLiteral("lessonHint"));
    show_ = new QPushButton(tr("Show me"), this);
    show_->setObjectName(QStringLiteral("lessonShow"));
    show_->setToolTip(tr("A pen draws the lines for you to follow."));
    again_ = new QPushButton(tr("Start over"), this);
    again_->setObjectName(QStringLiteral("lessonAgain"));
    again_->setToolTip(tr("Begins this step again."));
    next_ = new QPushButton(this);
    next_->setObjectName(QStringLiteral("lessonNext"));
    end_ = new QPushButton(this);
    end_->setObjectName(QStringLiteral("lessonEnd"));
    buttons_ = new QGridLayout;
    buttons_->addWidget(hint_, 0, 0);
    buttons_->addWidget(show_, 0, 1);
    buttons_->addWidget(again_, 1, 0);
    buttons_->addWidget(next_, 1, 1);
    buttons_->addWidget(end_, 2, 0, 1, 2);
    layout->addWidget(title_);
    layout->addWidget(pupil_);
    layout->addWidget(place_);
    layout->addWidget(progress_);
    layout->addSpacing(metrics::kSpace);
    layout->addWidget(task_);
    layout->addWidget(picture_);
    layout->addWidget(said_);
    layout->addStretch(1);
    layout->addLayout(buttons_);
    connect(hint_, &QPushButton::clicked, this, &LessonPanel::showHint);
    connect(show_, &QPushButton::clicked, &guide_, &LessonGuide::showStrokes);
    connect(again_, &QPushButton::clicked, &guide_, &LessonGuide::again);
    connect(next_, &QPushButton::clicked, &guide_, &LessonGuide::next);
    connect(end_, &QPushButton::clicked, this, &LessonPanel::endWanted);
    connect(&guide_, &LessonGuide::changed, this, &LessonPanel::refresh);
    connect(&session_, &ClassSession::changed, this, &LessonPanel::refresh);
    connect(&appearance, &Appearance::changed, this, &LessonPanel::refresh);
    refresh();
}

void LessonPanel::showHint() {
    hintShown_ = true;
    refresh();
}

void LessonPanel::refresh() {
    setEnabled(guide_.running());
    if (!guide_.running()) return;
    const Lesson& lesson = guide_.lesson();
    if (guide_.step() != step_ || guide_.stepDone()) hintShown_ = false;
    step_ = guide_.step();
    const LessonStep& step = lesson.steps[step_];
    const int count = static_cast<int>(lesson.steps.size());
    const int number = static_cast<int>(step_) + 1;
    title_->setText(inWindowsLanguage(lesson.title));
    showPupil();
    place_->setText(tr("Step %1 of %2").arg(number).arg(count));
    progress_->setRange(0, count);
    progress_->setValue(guide_.stepDone() ? number : number - 1);
    task_->setText(inWindowsLanguage(step.text));
    const ThemeColours& colours = appearance_.colours();
    QString said;
    QColor colour = colours.mutedText;
    if (guide_.stepDone()) {
        said = doneText();
        colour = colours.ok;
    } else if (!guide_.remark().empty()) {
        said = coreText(guide_.remark());
        colour = colours.warning;
    }
    arrange(guide_.practice() != nullptr);
    const QString hint = inWindowsLanguage(step.hint);
    if (hintShown_ && !hint.isEmpty()) said += (said.isEmpty() ? "" : "\n\n") + hint;
    said_->setText(said);
    QPalette palette = said_->palette();
    palette.setColor(QPalette::WindowText, colour);
    said_->setPalette(palette);
    hint_->setEnabled(!hint.isEmpty() && !guide_.stepDone() && !hintShown_);
    show_->setEnabled(!guide_.stepDone());
    const bool goesOn = !guide_.isLast() || guide_.practice() != nullptr;
    next_->setText(goesOn ? tr("Next") : tr("Finish"));
    next_->setEnabled(guide_.stepDone());
    next_->setDefault(guide_.stepDone());
    claimHeight();
}

QString LessonPanel::doneText() const {
    if (const auto& result = guide_.result())
        return tr("Done. %1").arg(PracticeCurve::words(*result));
    return tr("Done. %1").arg(starText(guide_.stars(step_)));
}

/// An exercise has a picture, and neither steps nor a hint of its own.
void LessonPanel::arrange(bool isPractice) {
    place_->setVisible(!isPractice);
    progress_->setVisible(!isPractice);
    hint_->setVisible(!isPractice);
    buttons_->addWidget(show_, 0, isPractice ? 0 : 1, 1, isPractice ? 2 : 1);
    end_->setText(isPractice ? tr("End the exercise") : tr("End the lesson"));
    showPicture();
}

/// What an exercise has to go by.
void LessonPanel::showPicture() {
    const PracticeTask* task = guide_.practice();
    picture_->setVisible(task != nullptr);
    if (task == nullptr) return;
    const ThemeColours& colours = appearance_.colours();
    PracticePaint paint;
    paint.line = colours.text.name().toStdString();
    paint.hidden = colours.mutedText.name().toStdString();
    paint.names = {tr("Front").toStdString(), tr("Right").toStdString(), tr("Top").toStdString()};
    QSvgRenderer svg(QByteArray::fromStdString(practiceSvg(*task, paint)));
    const int room = std::max(kLeastPicture, width() - 2 * metrics::kMargin);
    const QSize size =
        svg.defaultSize().scaled(std::min(room, kMostPicture), kMostPicture, Qt::KeepAspectRatio);
    const double ratio = devicePixelRatioF();
    QPixmap pixmap(size * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    svg.render(&painter, QRectF(QPointF(), size));
    painter.end();
    picture_->setPixmap(pixmap);
}

/// Who works here, so that nobody goes on in the name of who sat here before.
void LessonPanel::showPupil() {
    pupil_->setVisible(session_.joined());
    const QString name = QDir(session_.classFolder()).dirName();
    const QString who = tr("%1 in %2").arg(session_.pupil(), name);
    pupil_->setText(session_.isKept() ? who : tr("%1: not kept in the class folder yet").arg(who));
    const ThemeColours& colours = appearance_.colours();
    QPalette palette = pupil_->palette();
    palette.setColor(QPalette::WindowText, session_.isKept() ? colours.mutedText : colours.warning);
    pupil_->setPalette(palette);
}

/// Layouts do not pass on what height wrapped texts need, so the column would take it from them.
void LessonPanel::claimHeight() {
    layout()->activate();
    setMinimumHeight(std::max(0, layout()->totalHeightForWidth(width())));
}

void LessonPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (event->size().width() == event->oldSize().width()) return;
    if (guide_.running()) showPicture();
    claimHeight();
}

}  // namespace ew
