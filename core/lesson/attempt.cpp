// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/attempt.h"

#include <algorithm>
#include <utility>

#include "core/document/replay.h"
#include "core/document/store.h"
#include "core/lesson/likeness.h"

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

std::string sentence(Unlike unlike) {
    switch (unlike) {
        case Unlike::Nothing:
            return {};
        case Unlike::NotYet:
            return "Nothing was made or changed yet.";
        case Unlike::Bodies:
            return "More solids were made than are wanted; draw one at a time.";
        case Unlike::Side:
            return "It was done to the wrong side: what was to be added was cut, or the other way "
                   "round.";
        case Unlike::Shape:
            return "It became another kind of shape.";
        case Unlike::Place:
            return "The shape is right, but it is in the wrong place.";
        case Unlike::Proportions:
            return "The shape is right, but its proportions are far from the wanted ones.";
        case Unlike::Settings:
            return "It was done with other edges, another size or another kind of surface.";
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
        : before_(stage.begin->state()),
          wanted_(*stage.wanted),
          pupil_(pupil),
          tolerance_(tolerance) {}

    Unlike unlike() const { return likeness(before_, wanted_, pupil_.state(), tolerance_); }

    Attempt verdict() const {
        const Unlike how = unlike();
        return {how == Unlike::Nothing, unlikeName(how), sentence(how), {}};
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
    const DocumentState& before_;
    const DocumentState& wanted_;
    Document& pupil_;
    double tolerance_;
};

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
    const int steps = static_cast<int>(solution.contents().commands.size());
    out.wanted = solution.stateAt(std::min(steps, solution.contents().index));
    return out;
}

Result<Attempt> tryStep(const Lesson& lesson, std::size_t step, const SketchScript& script,
                        const TemplateLibrary& shipped) {
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

}  // namespace ew
