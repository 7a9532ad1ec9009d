// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/practice/practice_task.h"

#include <QUndoStack>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/document/lesson/likeness.h"
#include "core/document/replay.h"
#include "core/solid/visibility.h"
#include "core/stroke/segmenting.h"

namespace ew {
namespace {

constexpr int kTries = 40;
constexpr double kLikeDrawn = 0.25;  // how far what is read of the solution may be off
constexpr double kShortestLinePx = 30.0;
constexpr double kNearestCornersPx = 22.0;

/// Its visible lines, or nothing where a person could not tell what they are.
std::vector<std::array<Vec2, 2>> linesOf(const PracticeShape& shape) {
    const auto view = SolidView::make(shape.solid, {}, shape.camera);
    if (!view) return {};
    std::vector<std::array<Vec2, 2>> lines;
    for (const VisiblePiece& piece : view->visiblePieces()) {
        if (piece.point) return {};
        if ((piece.px[1] - piece.px[0]).norm() < kShortestLinePx) return {};
        lines.push_back(piece.px);
    }
    const std::vector<Vec2>& points = view->points();
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if ((points[i] - points[k]).norm() < kNearestCornersPx) return {};
        }
    }
    return lines;
}

DocumentState stateOf(const Solid& solid, const TemplateLibrary& library) {
    DocumentState state;
    state.library = library;
    state.bodies.push_back({solid, {}});
    return state;
}

/// How the drawing of the solution is applied to make the solid.
std::optional<ApplyStep> applyFor(const SketchScript& solution, const Solid& solid,
                                  const TemplateLibrary& shipped) {
    Document document(shipped);
    if (!beginReplay(document, solution)) return std::nullopt;
    for (std::size_t i = 0; i < solution.steps.size(); ++i) {
        if (!runStep(document, solution.steps[i], static_cast<int>(i), {}).ok) return std::nullopt;
    }
    const DocumentState wanted = stateOf(solid, shipped);
    const DocumentState before = document.state();
    const auto isIt = [&] {
        return likeness(before, wanted, document.state(), kLikeDrawn) == Unlike::Nothing;
    };
    if (document.apply()) {
        return isIt() ? std::optional(ApplyStep{}) : std::nullopt;
    }
    const int count = static_cast<int>(document.interpretation().candidates.size());
    for (int i = 0; i < count; ++i) {
        ApplyRequest request;
        request.candidate = i;
        if (!document.apply(request)) continue;
        if (isIt()) {
            ApplyStep step;
            step.candidate = i;
            return step;
        }
        if (!document.undo()) break;
    }
    return std::nullopt;
}

SketchScript drawingOf(const PracticeShape& shape, const std::vector<std::array<Vec2, 2>>& lines) {
    SketchScript script;
    script.viewport = {shape.camera.width, shape.camera.height};
    CameraStep camera;
    camera.direction = shape.camera.direction;
    camera.up = shape.camera.up;
    camera.center = shape.camera.center;
    camera.worldPerPixel = shape.camera.worldPerPixel;
    script.steps.emplace_back(camera);
    for (const auto& line : lines) {
        script.steps.emplace_back(StrokeStep{straightStroke(line[0], line[1]), false});
    }
    return script;
}

LessonText textFor(PracticeKind kind) {
    if (kind == PracticeKind::View) {
        return {{"en", "Draw this solid, as large as you like. Only edges that you can see."},
                {"de", "Zeichne diesen Körper, so groß du willst. Nur Kanten, die man sieht."}};
    }
    return {{"en",
             "This is a solid from the front, from the right and from above; what cannot be seen "
             "from there is dashed. Draw it so that three sides are seen."},
            {"de",
             "Das ist ein Körper von vorn, von rechts und von oben; was man von dort nicht sieht, "
             "ist gestrichelt. Zeichne ihn so, dass man drei Seiten sieht."}};
}

Lesson lessonOf(const PracticeTask& task, SketchScript solution) {
    // From three views the lengths are measured by eye.
    constexpr double kByEye = 0.6;
    const std::string level = std::to_string(task.level);
    const std::string seed = std::to_string(task.seed);
    Lesson lesson;
    lesson.id = "practice-" + level + "-" + seed;
    lesson.languages = {"en", "de"};
    lesson.title = {{"en", "Practice, level " + level + ", number " + seed},
                    {"de", "Übung, Stufe " + level + ", Nummer " + seed}};
    lesson.minutes = 2;
    LessonStep step;
    step.text = textFor(task.kind);
    step.end = solution.steps.size();
    step.tolerance = task.kind == PracticeKind::View ? kLessonTolerance : kByEye;
    lesson.steps.push_back(std::move(step));
    lesson.solution = std::move(solution);
    return lesson;
}

}  // namespace

std::string practiceKindName(PracticeKind kind) {
    return kind == PracticeKind::View ? "view" : "three-views";
}

Result<PracticeTask> practiceTask(int level, std::uint32_t seed, const TemplateLibrary& shipped) {
    if (level < 1 || level > kPracticeLevels) {
        return fail(Errc::BadValue,
                    "A level is from 1 to " + std::to_string(kPracticeLevels) + ".");
    }
    constexpr std::uint32_t kLevelStride = 2'654'435'761U;  // so that levels share no solids
    PracticeRandom random(seed + static_cast<std::uint32_t>(level) * kLevelStride);
    const PracticeKind kind = random.index(2) == 0 ? PracticeKind::View : PracticeKind::ThreeViews;
    for (int i = 0; i < kTries; ++i) {
        auto shape = practiceShape(level, random);
        if (!shape) continue;
        const auto lines = linesOf(*shape);
        if (lines.empty()) continue;
        SketchScript solution = drawingOf(*shape, lines);
        const auto apply = applyFor(solution, shape->solid, shipped);
        if (!apply) continue;
        solution.steps.emplace_back(*apply);
        PracticeTask task{level, seed, kind, *std::move(shape), {}};
        task.lesson = lessonOf(task, std::move(solution));
        return task;
    }
    return fail(Errc::NoSolution, "No exercise was found for this number; try another one.");
}

StrokeMeasure measureStrokes(const std::vector<Stroke>& strokes) {
    constexpr double kScalePx = 14.0;
    constexpr double kUsualWobblePx = 1.5;
    StrokeMeasure out;
    double ink = 0.0;
    double squares = 0.0;
    for (const Stroke& stroke : strokes) {
        ++out.strokes;
        out.seconds += stroke.samples.empty() ? 0.0 : stroke.samples.back().timeMs / 1000.0;
        for (const Segment& s : readStroke(stroke, 0, kScalePx, kUsualWobblePx).segments) {
            ink += s.inkPx;
            squares += s.inkPx * s.rmsPx * s.rmsPx;
        }
    }
    if (ink > 0.0) out.wobblePx = std::sqrt(squares / ink);
    return out;
}

double practiceAccuracy(const DocumentState& wanted, const DocumentState& made) {
    return std::clamp(1.0 - proportionsOff(wanted, made), 0.0, 1.0);
}

Result<PracticeGrade> gradePractice(const PracticeTask& task, const SketchScript& answer,
                                    const TemplateLibrary& shipped) {
    const auto stage = stageOf(task.lesson, 0, shipped);
    if (!stage) return fail(stage.error());
    std::shared_ptr<const DocumentState> made;
    auto tried = tryStep(task.lesson, 0, answer, shipped, &made);
    if (!tried) return fail(tried.error());
    PracticeGrade out;
    out.attempt = *std::move(tried);
    std::vector<Stroke> strokes;
    for (const ScriptStep& step : answer.steps) {
        if (const auto* drawn = std::get_if<StrokeStep>(&step)) strokes.push_back(drawn->stroke);
    }
    out.hand = measureStrokes(strokes);
    if (out.attempt.done) out.accuracy = practiceAccuracy(*stage->wanted, *made);
    return out;
}

}  // namespace ew
