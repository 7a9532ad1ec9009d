// SPDX-License-Identifier: GPL-3.0-or-later
// edgewright-lesson: checks and packs lessons without a window, tries what a pupil drew, and tells
// how a class gets on.
#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>
#include <QStringList>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/document/classroom/class_overview.h"
#include "core/document/classroom/overview_text.h"
#include "core/document/classroom/pupil_files.h"
#include "core/document/file_bytes.h"
#include "core/document/file_fault.h"
#include "core/document/lesson/attempt.h"
#include "core/document/lesson/lesson.h"
#include "core/document/lesson/lesson_check.h"
#include "core/document/practice/practice_picture.h"
#include "core/document/practice/practice_task.h"
#include "core/document/resources.h"
#include "core/document/tool_words.h"

namespace {

using Json = nlohmann::ordered_json;

constexpr int kDone = 0;
constexpr int kFaults = 1;
constexpr int kUnusable = 2;

constexpr const char* kHelp =
    "edgewright-lesson check FILE...          is each a lesson whose solution passes, with all of "
    "its texts?\n"
    "edgewright-lesson try FILE --step N --strokes SCRIPT\n"
    "                                         what the lesson says to strokes at its step N, "
    "counted from 0\n"
    "       [--class FOLDER --pupil NAME]     and keeps it as that pupil's work in a class folder\n"
    "edgewright-lesson pack FOLDER --out FILE one file to pass on (.edgewright-lesson)\n"
    "edgewright-lesson overview FOLDER [--csv FILE] [--html FILE]\n"
    "                                         how the pupils of a class folder get on, and who is "
    "stuck\n"
    "edgewright-lesson practice --level L --seed N [--svg FILE] [--solution FILE]\n"
    "                                         an exercise, the same on every machine\n"
    "edgewright-lesson practice --level L --seed N --answer SCRIPT\n"
    "                                         how well a drawing does it\n"
    "  --json      print JSON\n"
    "  --help, --version\n"
    "FILE is a lesson: a folder with lesson.json, this file, or an .edgewright-lesson.\n"
    "Exit status: 0 all is well, 1 there are faults (one line each: FILE: /json/path: sentence), "
    "files\n"
    "of the class that cannot be read, or the step is not done, 2 the arguments or a file cannot "
    "be used.\n";

struct Arguments : ew::ToolWords {
    QString out, step, strokes, classFolder, pupil, csv, html, level, seed, answer, svg, solution;
};

int unusable(const std::string& message) {
    std::fprintf(stderr, "edgewright-lesson: %s\n", message.c_str());
    return kUnusable;
}

void print(const Json& json) {
    std::printf("%s\n", json.dump(1, ' ', false, Json::error_handler_t::replace).c_str());
}

int check(const Arguments& arguments, const ew::TemplateLibrary& library) {
    Json faults = Json::array();
    Json lessons = Json::array();
    for (const QString& file : arguments.files) {
        const std::string name = file.toStdString();
        std::vector<ew::FileFault> found;
        const auto lesson = ew::readLesson(file);
        if (!lesson) {
            if (!QFileInfo::exists(file)) return unusable(lesson.error().message);
            found.push_back(ew::fileFault(name, lesson.error()));
        } else {
            lessons.push_back({{"file", name},
                               {"id", lesson->id},
                               {"steps", lesson->steps.size()},
                               {"languages", lesson->languages}});
            for (const ew::LessonFault& f : ew::checkLesson(*lesson, library)) {
                found.push_back({name, f.path, f.error.message, f.error.code});
            }
        }
        for (const ew::FileFault& f : found) {
            faults.push_back({{"file", f.file},
                              {"path", f.path},
                              {"code", ew::errcName(f.code)},
                              {"message", f.message}});
            if (!arguments.json) std::printf("%s\n", f.line().c_str());
        }
    }
    if (arguments.json) {
        print({{"format", "edgewright-lesson-check"},
               {"version", 1},
               {"lessons", lessons},
               {"faults", faults}});
    }
    return faults.empty() ? kDone : kFaults;
}

/// Keeps an attempt as a pupil's work in a class folder.
ew::Result<void> keepAttempt(const Arguments& arguments, const ew::Lesson& lesson,
                             const ew::SketchScript& script, const ew::Attempt& attempt) {
    auto files =
        ew::PupilFiles::join(arguments.classFolder, arguments.pupil, ew::ClassWriter::here());
    if (!files) return ew::fail(files.error());
    const auto step = static_cast<std::size_t>(arguments.step.toInt());
    const ew::ClassTime now = QDateTime::currentSecsSinceEpoch();
    ew::PupilProgress progress = files->progress();
    const auto known = progress.lessons.find(lesson.id);
    const bool goesOn = known != progress.lessons.end() && known->second.step == step &&
                        known->second.steps.size() == lesson.steps.size();
    if (!goesOn) ew::beginStep(progress, lesson.id, lesson.steps.size(), step, now);
    if (attempt.done) {
        const auto strokes = static_cast<int>(std::count_if(
            script.steps.begin(), script.steps.end(),
            [](const ew::ScriptStep& s) { return std::holds_alternative<ew::StrokeStep>(s); }));
        const int stars = ew::starsFor(strokes, ew::wantedStrokes(lesson, step));
        ew::finishStep(progress, lesson.id, stars, strokes, now);
    } else {
        ew::failStep(progress, lesson.id, attempt.hint, now);
    }
    if (auto ok = files->write(progress); !ok) return ok;
    if (const auto notice = files->takeNotice()) {
        std::fprintf(stderr, "edgewright-lesson: %s\n", notice->message.c_str());
    }
    return {};
}

int tryStrokes(const Arguments& arguments, const ew::TemplateLibrary& library) {
    bool isNumber = false;
    const int step = arguments.step.toInt(&isNumber);
    if (!isNumber || step < 0 || arguments.strokes.isEmpty() || arguments.files.size() != 1) {
        return unusable("try needs one lesson, --step N and --strokes SCRIPT");
    }
    if (arguments.classFolder.isEmpty() != arguments.pupil.isEmpty()) {
        return unusable("--class and --pupil belong together");
    }
    const auto lesson = ew::readLesson(arguments.files.front());
    if (!lesson) return unusable(lesson.error().message);
    const auto text = ew::readFileBytes(arguments.strokes, ew::kMaxScriptBytes);
    if (!text) return unusable(text.error().message);
    const auto script = ew::readSketchScript(*text);
    if (!script) return unusable(arguments.strokes.toStdString() + ": " + script.error().message);
    const auto tried = ew::tryStep(*lesson, static_cast<std::size_t>(step), *script, library);
    if (!tried) return unusable(tried.error().message);
    if (!arguments.classFolder.isEmpty()) {
        const auto kept = keepAttempt(arguments, *lesson, *script, *tried);
        if (!kept) return unusable(kept.error().message);
    }
    if (arguments.json) {
        Json where = Json::array();
        for (const ew::Vec2& p : tried->where) where.push_back({p.x(), p.y()});
        print({{"done", tried->done},
               {"hint", tried->done ? Json() : Json(tried->hint)},
               {"message", tried->message},
               {"where", where}});
    } else if (tried->done) {
        std::printf("done\n");
    } else {
        std::printf("%s: %s\n", tried->hint.c_str(), tried->message.c_str());
    }
    return tried->done ? kDone : kFaults;
}

int pack(const Arguments& arguments) {
    if (arguments.out.isEmpty() || arguments.files.size() != 1) {
        return unusable("pack needs one folder and --out");
    }
    const auto bytes = ew::packLesson(arguments.files.front());
    if (!bytes) return unusable(bytes.error().message);
    QString path = arguments.out;
    const QString ending = QStringLiteral(".edgewright-lesson");
    if (!path.endsWith(ending)) path += ending;
    if (auto ok = ew::writeFileBytes(path, *bytes); !ok) return unusable(ok.error().message);
    return kDone;
}

/// A line for each pupil.
void printPupils(const ew::ClassOverview& found) {
    for (const ew::ClassPupil& pupil : found.pupils) {
        std::string line = pupil.progress.name + ": steps " +
                           ew::starsText(pupil.done(), found.steps()) + ", stars " +
                           ew::starsText(pupil.stars(), ew::kMostStars * found.steps()) + ", " +
                           ew::durationText(pupil.seconds());
        if (pupil.stuck) line += "; stuck: " + ew::stuckText(found, *pupil.stuck);
        std::printf("%s\n", line.c_str());
    }
}

int overview(const Arguments& arguments) {
    if (arguments.files.size() != 1) return unusable("overview needs one class folder");
    const auto resources = ew::resourcesFolder();
    const QString shipped = resources ? *resources + QStringLiteral("/lessons") : QString();
    const auto found = ew::readClass(arguments.files.front(), shipped);
    if (!found) return unusable(found.error().message);
    if (!arguments.csv.isEmpty()) {
        const auto ok = ew::writeFileBytes(arguments.csv, ew::overviewCsv(*found));
        if (!ok) return unusable(ok.error().message);
    }
    if (!arguments.html.isEmpty()) {
        const auto ok = ew::writeFileBytes(arguments.html, ew::overviewHtml(*found));
        if (!ok) return unusable(ok.error().message);
    }
    if (arguments.json) {
        std::printf("%s\n", ew::overviewJson(*found).c_str());
    } else {
        printPupils(*found);
        for (const ew::FileFault& f : found->problems) std::printf("%s\n", f.line().c_str());
    }
    return found->problems.empty() ? kDone : kFaults;
}

int printGrade(const ew::PracticeGrade& grade, bool json) {
    const ew::Attempt& attempt = grade.attempt;
    if (json) {
        print({{"done", attempt.done},
               {"hint", attempt.done ? Json() : Json(attempt.hint)},
               {"message", attempt.message},
               {"accuracy", grade.accuracy},
               {"strokes", grade.hand.strokes},
               {"seconds", grade.hand.seconds},
               {"wobble_px", grade.hand.wobblePx}});
    } else if (attempt.done) {
        std::printf("done: accuracy %.0f %%, %d strokes, %.1f s, off straight by %.1f px\n",
                    100.0 * grade.accuracy, grade.hand.strokes, grade.hand.seconds,
                    grade.hand.wobblePx);
    } else {
        std::printf("%s: %s\n", attempt.hint.c_str(), attempt.message.c_str());
    }
    return attempt.done ? kDone : kFaults;
}

int gradeAnswer(const Arguments& arguments, const ew::PracticeTask& task,
                const ew::TemplateLibrary& library) {
    const auto text = ew::readFileBytes(arguments.answer, ew::kMaxScriptBytes);
    if (!text) return unusable(text.error().message);
    const auto script = ew::readSketchScript(*text);
    if (!script) return unusable(arguments.answer.toStdString() + ": " + script.error().message);
    const auto grade = ew::gradePractice(task, *script, library);
    if (!grade) return unusable(grade.error().message);
    return printGrade(*grade, arguments.json);
}

int practice(const Arguments& arguments, const ew::TemplateLibrary& library) {
    bool isLevel = false;
    bool isSeed = false;
    const int level = arguments.level.toInt(&isLevel);
    const std::uint32_t seed = arguments.seed.toUInt(&isSeed);
    if (!isLevel || !isSeed || !arguments.files.isEmpty()) {
        return unusable("practice needs --level L and --seed N, and no other file");
    }
    const auto task = ew::practiceTask(level, seed, library);
    if (!task) return unusable(task.error().message);
    const auto write = [](const QString& path, const std::string& bytes) -> ew::Result<void> {
        return path.isEmpty() ? ew::Result<void>() : ew::writeFileBytes(path, bytes);
    };
    auto written = write(arguments.svg, ew::practiceSvg(*task));
    if (written) {
        written = write(arguments.solution, ew::writeSketchScript(task->lesson.solution));
    }
    if (!written) return unusable(written.error().message);
    if (!arguments.answer.isEmpty()) return gradeAnswer(arguments, *task, library);
    const std::string text = ew::textIn(task->lesson.steps.front().text, "en");
    if (arguments.json) {
        print({{"format", "edgewright-practice"},
               {"version", 1},
               {"level", level},
               {"seed", seed},
               {"kind", ew::practiceKindName(task->kind)},
               {"text", text},
               {"svg", ew::practiceSvg(*task)}});
    } else {
        std::printf("%s\n%s\n", ew::practiceKindName(task->kind).c_str(), text.c_str());
    }
    return kDone;
}

ew::Result<Arguments> readArguments(const QStringList& words) {
    Arguments out;
    auto said =
        ew::readToolWords(words,
                          {QStringLiteral("check"), QStringLiteral("try"), QStringLiteral("pack"),
                           QStringLiteral("overview"), QStringLiteral("practice")},
                          {{"--out", &out.out},
                           {"--step", &out.step},
                           {"--strokes", &out.strokes},
                           {"--class", &out.classFolder},
                           {"--pupil", &out.pupil},
                           {"--csv", &out.csv},
                           {"--html", &out.html},
                           {"--level", &out.level},
                           {"--seed", &out.seed},
                           {"--answer", &out.answer},
                           {"--svg", &out.svg},
                           {"--solution", &out.solution}},
                          {QStringLiteral("practice")});
    if (!said) return ew::fail(said.error());
    static_cast<ew::ToolWords&>(out) = *std::move(said);
    return out;
}

}  // namespace

int main(int argc, char** argv) {
    const QCoreApplication app(argc, argv);
    const QStringList words = QCoreApplication::arguments().mid(1);
    if (words.contains(QStringLiteral("--help"))) {
        std::printf("%s", kHelp);
        return kDone;
    }
    if (words.contains(QStringLiteral("--version"))) {
        std::printf("edgewright-lesson %s\n", EDGEWRIGHT_VERSION);
        return kDone;
    }
    const auto read = readArguments(words);
    if (!read) {
        std::fprintf(stderr, "edgewright-lesson: %s\n%s", read.error().message.c_str(), kHelp);
        return kUnusable;
    }
    const Arguments& arguments = *read;
    if (arguments.command == QStringLiteral("pack")) return pack(arguments);
    if (arguments.command == QStringLiteral("overview")) return overview(arguments);
    const auto templates = ew::loadTemplates();
    if (!templates) return unusable(templates.error().message);
    if (arguments.command == QStringLiteral("practice")) {
        return practice(arguments, templates->library);
    }
    return arguments.command == QStringLiteral("check") ? check(arguments, templates->library)
                                                        : tryStrokes(arguments, templates->library);
}
