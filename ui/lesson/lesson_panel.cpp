// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/lesson_panel.h"

#include <QDir>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QResizeEvent>
#include <QVBoxLayout>

#include "ui/core_text.h"
#include "ui/lesson/class_session.h"
#include "ui/lesson/lesson_guide.h"
#include "ui/theme/appearance.h"

namespace ew {

namespace {

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
    auto* end = new QPushButton(tr("End the lesson"), this);
    end->setObjectName(QStringLiteral("lessonEnd"));
    auto* buttons = new QGridLayout;
    buttons->addWidget(hint_, 0, 0);
    buttons->addWidget(show_, 0, 1);
    buttons->addWidget(again_, 1, 0);
    buttons->addWidget(next_, 1, 1);
    buttons->addWidget(end, 2, 0, 1, 2);
    layout->addWidget(title_);
    layout->addWidget(pupil_);
    layout->addWidget(place_);
    layout->addWidget(progress_);
    layout->addSpacing(metrics::kSpace);
    layout->addWidget(task_);
    layout->addWidget(said_);
    layout->addStretch(1);
    layout->addLayout(buttons);
    connect(hint_, &QPushButton::clicked, this, &LessonPanel::showHint);
    connect(show_, &QPushButton::clicked, &guide_, &LessonGuide::showStrokes);
    connect(again_, &QPushButton::clicked, &guide_, &LessonGuide::again);
    connect(next_, &QPushButton::clicked, &guide_, &LessonGuide::next);
    connect(end, &QPushButton::clicked, this, &LessonPanel::endWanted);
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
        said = tr("Done. %1").arg(starText(guide_.stars(step_)));
        colour = colours.ok;
    } else if (!guide_.remark().empty()) {
        said = coreText(guide_.remark());
        colour = colours.warning;
    }
    const QString hint = inWindowsLanguage(step.hint);
    if (hintShown_ && !hint.isEmpty()) said += (said.isEmpty() ? "" : "\n\n") + hint;
    said_->setText(said);
    QPalette palette = said_->palette();
    palette.setColor(QPalette::WindowText, colour);
    said_->setPalette(palette);
    hint_->setEnabled(!hint.isEmpty() && !guide_.stepDone() && !hintShown_);
    show_->setEnabled(!guide_.stepDone());
    next_->setText(guide_.isLast() ? tr("Finish") : tr("Next"));
    next_->setEnabled(guide_.stepDone());
    next_->setDefault(guide_.stepDone());
    claimHeight();
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
    setMinimumHeight(layout()->totalHeightForWidth(width()));
}

void LessonPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (event->size().width() != event->oldSize().width()) claimHeight();
}

}  // namespace ew
