// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/lesson/lesson_check.h"

#include <utility>

#include "core/document/json_text.h"
#include "core/document/lesson/attempt.h"

namespace ew {
namespace {

void checkText(const Lesson& lesson, const LessonText& text, const std::string& path,
               std::vector<LessonFault>& out) {
    for (const std::string& language : lesson.languages) {
        const auto found = text.find(language);
        if (found != text.end() && !found->second.empty()) continue;
        out.push_back({path, {Errc::MissingKey, "there is no text in " + language, {}}});
    }
    for (const auto& [language, words] : text) {
        bool claimed = false;
        for (const std::string& known : lesson.languages) claimed = claimed || known == language;
        if (claimed) continue;
        out.push_back({path + "/" + language,
                       {Errc::UnknownKey, nameQuoted(language) + " is not among /languages", {}}});
    }
}

/// What the solution does in a step, as a pupil's script.
SketchScript solutionOf(const Lesson& lesson, std::size_t step) {
    SketchScript out = lesson.solution;
    const auto [begin, end] = taskOf(lesson, step);
    const auto first = lesson.solution.steps.begin();
    out.steps.assign(first + static_cast<std::ptrdiff_t>(begin),
                     first + static_cast<std::ptrdiff_t>(end));
    return out;
}

}  // namespace

std::vector<LessonFault> checkLesson(const Lesson& lesson, const TemplateLibrary& shipped) {
    std::vector<LessonFault> out;
    checkText(lesson, lesson.title, "/title", out);
    if (!lesson.summary.empty()) checkText(lesson, lesson.summary, "/summary", out);
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const std::string path = "/steps/" + std::to_string(i);
        checkText(lesson, lesson.steps[i].text, path + "/text", out);
        if (!lesson.steps[i].hint.empty())
            checkText(lesson, lesson.steps[i].hint, path + "/hint", out);
        const auto tried = tryStep(lesson, i, solutionOf(lesson, i), shipped);
        if (!tried) {
            out.push_back({path, tried.error()});
            break;  // what follows stands on it
        }
        if (!tried->done) {
            out.push_back(
                {path,
                 {Errc::NoSolution,
                  "its own solution does not pass (" + tried->hint + "): " + tried->message,
                  tried->where}});
        }
    }
    return out;
}

}  // namespace ew
