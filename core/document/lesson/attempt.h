// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/document/document.h"
#include "core/document/lesson/lesson.h"
#include "core/document/lesson/likeness.h"

namespace ew {

/// What becomes of a pupil's attempt at a step of a lesson.
struct Attempt {
    bool done = false;
    std::string hint;         ///< empty where it is done; else the code of an error or of an Unlike
    std::string message;      ///< a sentence for it
    std::vector<Vec2> where;  ///< what the hint speaks of [Sketch Plane px]
};

/// Where a step of a lesson begins and what it wants.
struct LessonStage {
    std::shared_ptr<Document> begin;  ///< with the view and thresholds that the step is drawn with
    std::shared_ptr<const DocumentState> wanted;
    std::optional<Thresholds> thresholds;  ///< where they are the task
};

/// What keeps a document from being what the stage wants: likeness(), and the thresholds within a
/// quarter where these are the task.
Unlike stageUnlike(const LessonStage& stage, const Document& pupil, double tolerance);

/// The steps of the solution that a pupil has to do in a step of the lesson, from the first of the
/// returned to before the second. What stands before its strokes (the view, the thresholds, that an
/// earlier solid goes) sets the stage and is done for the pupil; without strokes it is the task.
std::pair<std::size_t, std::size_t> taskOf(const Lesson& lesson, std::size_t step);

/// 1 to 3 for a step that was done: three for no more strokes than the solution has, two for half
/// as many again.
int starsFor(int drawnStrokes, int wantedStrokes);
/// How many strokes the solution has in a step.
int wantedStrokes(const Lesson& lesson, std::size_t step);

/// Replays the solution up to a step, and through it.
/// \param step  from 0. Errors: BadValue for a step that is not there; those of a step of the
///     solution that fails.
Result<LessonStage> stageOf(const Lesson& lesson, std::size_t step, const TemplateLibrary& shipped);

/// Judges what a pupil did from where a step begins, by what the program understands of it: the
/// strokes of the script are drawn (in any order, by any hand, from any side), its other steps are
/// done, and strokes that are left are applied as the step's solution does it. Where the program
/// asks which of several readings is meant, the wanted one is. Errors: those of stageOf(); BadValue
/// for a script with steps that are not for lessons.
/// \param made  what became of it; null where nobody asks.
Result<Attempt> tryStep(const Lesson& lesson, std::size_t step, const SketchScript& script,
                        const TemplateLibrary& shipped,
                        std::shared_ptr<const DocumentState>* made = nullptr);

}  // namespace ew
