// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/lesson/attempt.h"

#include <QUndoStack>
#include <cmath>
#include <utility>

#include "core/document/lesson/likeness.h"
#include "core/document/replay.h"
#include "core/document/store.h"

namespace ew {
namespace {

/// The steps of the solution that belong to a step of the lesson.
std::pair<std::size_t, std::size_t> rangeOf(const Lesson& lesson, std::size_t step) {
    return {step == 0 ? 0 : lesson.steps[step - 1].end, lesson.steps[step].end};
}

bool setsStage(const ScriptStep& step) {
    return std::holds_alternative<CameraStep>(step) ||
           std::holds_alternative<ThresholdsStep>(step) ||
           std::holds_alternative<DeleteSolidStep>(step);
}

Result<void> runSolution(Document& document, const Lesson& lesson, std::size_t from,
                         std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
        const StepReport report =
            runStep(document, lesson.solution.steps[i], static_cast<int>(i), {});
        if (report.ok) continue;
        Error error = *report.error;
        error.message = "step " + std::to_string(i) + " (" + report.name +
                        ") of the solution fails: " + error.message;
        return fail(std::move(error));
    }
    return {};
}

/// What the strokes that are left are for.
const ScriptStep* lastDeed(const Lesson& lesson, std::size_t step) {
    const auto [begin, end] = taskOf(lesson, step);
    for (std::size_t i = end; i-- > begin;) {
        const ScriptStep& s = lesson.solution.steps[i];
        if (std::holds_alternative<ApplyStep>(s) || std::holds_alternative<MapStrokesStep>(s)) {
            return &s;
        }
    }
    return nullptr;
}

class Judge {
  public:
    Judge(const LessonStage& stage, Document& pupil, double tolerance)
        : stage_(stage), pupil_(pupil), tolerance_(tolerance) {}

    Unlike unlike() const { return stageUnlike(stage_, pupil_, tolerance_); }

    Attempt verdict() const {
        const Unlike how = unlike();
        return {how == Unlike::Nothing, unlikeName(how), unlikeSentence(how), {}};
    }
    static Attempt failed(const Error& error) {
        return {false, std::string(errcName(error.code)), error.message, error.where};
    }

    /// Applies the strokes that are left.
    Attempt apply(const ApplyStep& like) {
        ApplyRequest request;
        request.level = like.level;
        if (pupil_.apply(request)) return verdict();
        const Interpretation reading = pupil_.interpretationFor(request);
        const Error problem =
            reading.problem.value_or(Error{Errc::NoMatch, "No template matches this drawing.", {}});
        if (problem.code != Errc::Ambiguous) return failed(problem);
        const int count = static_cast<int>(reading.candidates.size());
        for (int i = 0; i < count; ++i) {
            request.candidate = i;
            if (!pupil_.apply(request)) continue;
            if (unlike() == Unlike::Nothing) return verdict();
            if (!pupil_.undo()) break;
        }
        return failed(problem);
    }

  private:
    const LessonStage& stage_;
    Document& pupil_;
    double tolerance_;
};

/// Does what a script says, and judges what became of it.
Result<Attempt> judged(Judge& judge, Document& pupil, const Lesson& lesson, std::size_t step,
                       const SketchScript& script) {
    CameraStep window;
    window.viewport = Vec2(script.viewport[0], script.viewport[1]);
    if (const StepReport set = runStep(pupil, window, 0, {}); !set.ok) return fail(*set.error);
    for (std::size_t i = 0; i < script.steps.size(); ++i) {
        const StepReport report = runStep(pupil, script.steps[i], static_cast<int>(i), {});
        if (report.ok) continue;
        // Strokes that cannot be read at all, and an apply that fails, are what the hint is for.
        const auto* apply = std::get_if<ApplyStep>(&script.steps[i]);
        return apply != nullptr ? judge.apply(*apply) : Judge::failed(*report.error);
    }
    const Unlike how = judge.unlike();
    if (how == Unlike::Nothing || pupil.pendingStrokes().empty()) return judge.verdict();
    const ScriptStep* deed = lastDeed(lesson, step);
    if (deed == nullptr) return judge.verdict();
    if (const auto* apply = std::get_if<ApplyStep>(deed)) return judge.apply(*apply);
    if (auto mapped = pupil.mapStrokes(); !mapped) return Judge::failed(mapped.error());
    return judge.verdict();
}

}  // namespace

std::pair<std::size_t, std::size_t> taskOf(const Lesson& lesson, std::size_t step) {
    const auto [from, to] = rangeOf(lesson, step);
    const auto& steps = lesson.solution.steps;
    const auto isStroke = [&](std::size_t i) {
        return std::holds_alternative<StrokeStep>(steps[i]);
    };
    std::size_t begin = from;
    while (begin < to && setsStage(steps[begin])) ++begin;
    return {begin < to && isStroke(begin) ? begin : from, to};
}

int starsFor(int drawnStrokes, int wantedStrokes) {
    constexpr int kThree = 3;
    if (drawnStrokes <= wantedStrokes) return kThree;
    return 2 * drawnStrokes <= 3 * wantedStrokes ? 2 : 1;
}

int wantedStrokes(const Lesson& lesson, std::size_t step) {
    const auto [from, to] = taskOf(lesson, step);
    int count = 0;
    for (std::size_t i = from; i < to; ++i) {
        if (std::holds_alternative<StrokeStep>(lesson.solution.steps[i])) ++count;
    }
    return count;
}

Unlike stageUnlike(const LessonStage& stage, const Document& pupil, double tolerance) {
    const Unlike how = likeness(stage.begin->state(), *stage.wanted, pupil.state(), tolerance);
    if (how != Unlike::Nothing || !stage.thresholds) return how;
    const Thresholds& is = pupil.thresholds();
    const Thresholds& wish = *stage.thresholds;
    if (is == stage.begin->thresholds()) return Unlike::NotYet;
    constexpr double kNear = 0.25;
    const bool near = std::abs(is.distancePx - wish.distancePx) <= kNear * wish.distancePx &&
                      std::abs(is.angleDeg - wish.angleDeg) <= kNear * wish.angleDeg;
    return near ? Unlike::Nothing : Unlike::Settings;
}

Result<LessonStage> stageOf(const Lesson& lesson, std::size_t step,
                            const TemplateLibrary& shipped) {
    if (step >= lesson.steps.size()) {
        return fail(Errc::BadValue,
                    "The lesson has " + std::to_string(lesson.steps.size()) + " steps.");
    }
    const auto [begin, end] = taskOf(lesson, step);
    Document solution(shipped);
    if (auto ok = beginReplay(solution, lesson.solution); !ok) return fail(ok.error());
    if (auto ok = runSolution(solution, lesson, 0, begin); !ok) return fail(ok.error());
    LessonStage out;
    out.begin = std::make_shared<Document>(shipped);
    out.begin->restore(solution.contents(), {});
    if (auto ok = runSolution(solution, lesson, begin, end); !ok) return fail(ok.error());
    out.wanted = solution.stateAt(solution.undoStack().index());
    if (solution.thresholds() != out.begin->thresholds()) out.thresholds = solution.thresholds();
    return out;
}

Result<Attempt> tryStep(const Lesson& lesson, std::size_t step, const SketchScript& script,
                        const TemplateLibrary& shipped,
                        std::shared_ptr<const DocumentState>* made) {
    for (const ScriptStep& s : script.steps) {
        if (fileOfStep(s)) {
            return fail(Errc::BadValue, "A lesson has no step " + std::string(stepName(s)) + ".");
        }
    }
    const auto stage = stageOf(lesson, step, shipped);
    if (!stage) return fail(stage.error());
    Document pupil(shipped);
    pupil.restore(stage->begin->contents(), {});
    Judge judge(*stage, pupil, lesson.steps[step].tolerance);
    auto tried = judged(judge, pupil, lesson, step, script);
    if (made != nullptr) *made = pupil.stateAt(pupil.undoStack().index());
    return tried;
}

}  // namespace ew
