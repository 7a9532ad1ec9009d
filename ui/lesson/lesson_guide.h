// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <functional>
#include <optional>
#include <vector>

#include "core/document/lesson/attempt.h"
#include "core/document/practice/practice_log.h"
#include "core/document/practice/practice_task.h"
#include "ui/viewport/ghost_overlay.h"
#include "ui/window_context.h"

namespace ew {

/// Leads through a lesson in a window: brings the document to where each step begins, shows the
/// strokes to trace (fainter from step to step), and notices when a step is done by what the
/// document has become.
class LessonGuide : public QObject {
    Q_OBJECT

  public:
    explicit LessonGuide(const WindowContext& context, QObject* parent = nullptr);

    /// Begins a lesson in place of the document. On error nothing changes. Errors: those of
    /// readLesson() and stageOf().
    /// \param step  to begin at, by the lesson; empty: at the first.
    Result<void> start(const QString& path,
                       const std::function<std::size_t(const Lesson&)>& step = {});
    /// Begins an exercise, as a lesson of one step without ghosts. Errors: those of stageOf().
    Result<void> startPractice(PracticeTask task);
    /// Null where what runs is a lesson.
    const PracticeTask* practice() const { return practice_ ? &*practice_ : nullptr; }
    /// Of the exercise, once it is done.
    const std::optional<PracticeResult>& result() const { return result_; }
    /// Ends it; the document stays as it is.
    void stop();
    bool running() const { return lesson_.has_value(); }
    /// \pre running()
    const Lesson& lesson() const { return *lesson_; }
    std::size_t step() const { return step_; }
    bool stepDone() const { return done_; }
    bool isLast() const { return step_ + 1 == lesson_->steps.size(); }
    /// 1 to 3 for a step that is done, 0 for one that is not: three for no more strokes than the
    /// solution has, two for half as many again.
    int stars(std::size_t step) const { return stars_[step]; }
    /// What is to be said about what was made; empty while there is nothing to say. In English.
    const std::string& remark() const { return remark_; }

    void next();
    /// From the beginning of the step.
    void again();
    /// A pen draws the strokes.
    void showStrokes();
    /// Are the strokes to trace seen?
    bool showsGhost() const { return showsGhost_; }

  signals:
    /// Everything that the functions above tell.
    void changed();
    void failed(const ew::Error& error);
    void stepBegun();
    /// What was made, or tried, is not what is wanted; the code of the hint.
    void stepFailed(const std::string& hint);
    void stepFinished(int stars, int strokes);
    /// The lesson ends; it is still running.
    void stopping();
    /// The exercise is done: result() tells how.
    void practiceDone();
    /// The exercise was left as one that is done.
    void anotherWanted();

  private:
    void begin(std::size_t step);
    void enter(std::size_t step, LessonStage stage);
    void documentChanged(DocumentChange what);
    void judge();
    void finish();
    void measure();
    void showGhost(double drawn);
    void remember() const;

    WindowContext context_;
    std::optional<Lesson> lesson_;
    TemplateLibrary shipped_;
    LessonStage stage_;
    Ghost ghost_;  ///< of the step
    std::size_t step_ = 0;
    bool done_ = false;
    bool beginning_ = false;  ///< the document is being brought to where the step begins
    bool judgeSoon_ = false;
    int drawnStrokes_ = 0;
    std::size_t pending_ = 0;
    int judgedIndex_ = 0;  ///< of the undo stack: each result is counted once
    std::optional<PracticeTask> practice_;
    std::vector<Stroke> strokes_;  ///< of the exercise, as they were when there were any last
    std::optional<PracticeResult> result_;
    std::vector<int> stars_;
    std::string remark_;
    QTimer pen_;
    double drawn_ = 0.0;
    bool showsGhost_ = false;
};

/// The best stars of a lesson's steps, as an earlier run left them; empty where there was none.
std::vector<int> rememberedStars(const std::string& lessonId);

}  // namespace ew
