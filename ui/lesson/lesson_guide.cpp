// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/lesson_guide.h"

#include <QDateTime>
#include <QSettings>
#include <QUndoStack>
#include <algorithm>
#include <variant>

#include "core/document/store.h"
#include "ui/apply_controller.h"
#include "ui/viewport/viewport_widget.h"

namespace ew {

namespace {

constexpr int kPenPeriodMs = 30;
constexpr double kPenMs = 4'000.0;  // for all strokes of a step
constexpr double kFirstOpacity = 0.55;
constexpr double kFade = 0.12;  // from step to step
constexpr double kLeastOpacity = 0.15;

QString settingOf(const std::string& lessonId) {
    return QStringLiteral("lessons/") + QString::fromStdString(lessonId);
}

}  // namespace

LessonGuide::LessonGuide(const WindowContext& context, QObject* parent)
    : QObject(parent), context_(context) {
    connect(&context_.document, &Document::changed, this, &LessonGuide::documentChanged);
    pen_.setInterval(kPenPeriodMs);
    connect(&pen_, &QTimer::timeout, this, [this] {
        drawn_ += kPenPeriodMs / kPenMs;
        if (drawn_ >= 1.0) pen_.stop();
        showGhost(std::min(drawn_, 1.0));
    });
    connect(&context_.apply, &ApplyController::failed, this, [this](const Error& error) {
        if (running() && !done_) emit stepFailed(std::string(errcName(error.code)));
    });
}

Result<void> LessonGuide::start(const QString& path,
                                const std::function<std::size_t(const Lesson&)>& step) {
    auto lesson = readLesson(path);
    if (!lesson) return fail(lesson.error());
    // A lesson is about the templates that the window has.
    TemplateLibrary library = context_.document.stateAt(0)->library;
    const std::size_t at = step ? step(*lesson) : 0;
    auto first = stageOf(*lesson, at, library);
    if (!first) return fail(first.error());
    if (running()) emit stopping();
    practice_.reset();
    lesson_ = *std::move(lesson);
    shipped_ = std::move(library);
    stars_.assign(lesson_->steps.size(), 0);
    enter(at, *std::move(first));
    return {};
}

Result<void> LessonGuide::startPractice(PracticeTask task) {
    TemplateLibrary library = context_.document.stateAt(0)->library;
    auto first = stageOf(task.lesson, 0, library);
    if (!first) return fail(first.error());
    if (running()) emit stopping();
    practice_ = std::move(task);
    lesson_ = practice_->lesson;
    shipped_ = std::move(library);
    stars_.assign(1, 0);
    enter(0, *std::move(first));
    return {};
}

void LessonGuide::stop() {
    if (!running()) return;
    emit stopping();
    lesson_.reset();
    practice_.reset();
    pen_.stop();
    context_.viewport.setGhost(std::nullopt);
    emit changed();
}

void LessonGuide::begin(std::size_t step) {
    auto stage = stageOf(*lesson_, step, shipped_);
    if (stage)
        enter(step, *std::move(stage));
    else
        emit failed(stage.error());
}

void LessonGuide::enter(std::size_t step, LessonStage stage) {
    stage_ = std::move(stage);
    step_ = step;
    done_ = false;
    remark_.clear();
    drawnStrokes_ = 0;
    strokes_.clear();
    result_.reset();
    drawn_ = 0.0;
    pending_ = 0;
    beginning_ = true;
    context_.document.restore(stage_.begin->contents(), {});
    beginning_ = false;
    pen_.stop();
    ghost_ = {};
    ghost_.camera = stage_.begin->camera();
    ghost_.opacity = std::max(kLeastOpacity, kFirstOpacity - kFade * static_cast<double>(step_));
    const auto [from, to] = taskOf(*lesson_, step_);
    for (std::size_t i = from; i < to; ++i) {
        const auto* stroke = std::get_if<StrokeStep>(&lesson_->solution.steps[i]);
        if (stroke != nullptr) ghost_.strokes.push_back(stroke->stroke);
    }
    showGhost(0.0);
    judgedIndex_ = context_.document.undoStack().index();
    emit stepBegun();
    emit changed();
}

void LessonGuide::next() {
    if (!running() || !done_) return;
    if (isLast()) {
        const bool again = practice_.has_value();
        stop();
        if (again) emit anotherWanted();
        return;
    }
    begin(step_ + 1);
}

void LessonGuide::again() {
    if (running()) begin(step_);
}

void LessonGuide::showStrokes() {
    if (!running()) return;
    drawn_ = 0.0;
    pen_.start();
}

void LessonGuide::showGhost(double drawn) {
    ghost_.drawn = drawn;
    // An exercise shows its lines only to who asks for them.
    const bool hidden = practice_ && !pen_.isActive() && drawn == 0.0;
    showsGhost_ = !done_ && !hidden && !ghost_.strokes.empty();
    context_.viewport.setGhost(showsGhost_ ? std::optional(ghost_) : std::nullopt);
}

void LessonGuide::documentChanged(DocumentChange what) {
    if (!running() || beginning_) return;
    if (what == DocumentChange::Ink) {
        const std::size_t now = context_.document.pendingStrokes().size();
        if (now > pending_) drawnStrokes_ += static_cast<int>(now - pending_);
        pending_ = now;
        if (practice_ && now > 0) {
            strokes_.clear();
            for (const PendingStroke& s : context_.document.pendingStrokes()) {
                strokes_.push_back(s.stroke);
            }
        }
        return;
    }
    const bool matters = what == DocumentChange::Shape || what == DocumentChange::Thresholds ||
                         what == DocumentChange::Library || what == DocumentChange::Bodies;
    if (!matters || judgeSoon_) return;
    judgeSoon_ = true;
    // One change is told in several signals.
    QMetaObject::invokeMethod(this, &LessonGuide::judge, Qt::QueuedConnection);
}

void LessonGuide::judge() {
    judgeSoon_ = false;
    if (!running()) return;
    const Unlike how = stageUnlike(stage_, context_.document, lesson_->steps[step_].tolerance);
    remark_ = how == Unlike::NotYet ? std::string() : unlikeSentence(how);
    const int index = context_.document.undoStack().index();
    const bool isNew = index > judgedIndex_;
    judgedIndex_ = index;
    if (how == Unlike::Nothing && !done_) {
        finish();
    } else if (!remark_.empty() && isNew && !done_) {
        emit stepFailed(unlikeName(how));
    }
    emit changed();
}

void LessonGuide::finish() {
    done_ = true;
    stars_[step_] = starsFor(drawnStrokes_, static_cast<int>(ghost_.strokes.size()));
    pen_.stop();
    showGhost(0.0);
    if (practice_) {
        measure();
        emit practiceDone();
        return;
    }
    remember();
    emit stepFinished(stars_[step_], drawnStrokes_);
}

void LessonGuide::measure() {
    const StrokeMeasure hand = measureStrokes(strokes_);
    result_ = PracticeResult{QDateTime::currentSecsSinceEpoch(),
                             practice_->level,
                             practice_->seed,
                             practiceAccuracy(*stage_.wanted, context_.document.state()),
                             hand.seconds,
                             hand.wobblePx,
                             hand.strokes};
}

void LessonGuide::remember() const {
    std::vector<int> best = rememberedStars(lesson_->id);
    best.resize(stars_.size());
    QStringList words;
    for (std::size_t i = 0; i < stars_.size(); ++i) {
        words << QString::number(std::max(best[i], stars_[i]));
    }
    QSettings().setValue(settingOf(lesson_->id), words.join(QLatin1Char(' ')));
}

std::vector<int> rememberedStars(const std::string& lessonId) {
    std::vector<int> out;
    const QString text = QSettings().value(settingOf(lessonId)).toString();
    for (const QString& word : text.split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
        constexpr int kMost = 3;
        out.push_back(std::clamp(word.toInt(), 0, kMost));
    }
    return out;
}

}  // namespace ew
