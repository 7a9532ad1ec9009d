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
    "  --json      print JSON\n"
    "  --help, --version\n"
    "FILE is a lesson: a folder with lesson.json, this file, or an .edgewright-lesson.\n"
    "Exit status: 0 all is well, 1 there are faults (one line each: FILE: /json/path: sentence), "
    "files\n"
    "of the class that cannot be read, or the step is not done, 2 the arguments or a file cannot "
    "be used.\n";

struct Arguments : ew::ToolWords {
    QString out, step, strokes, classFolder, pupil, csv, html;
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

ew::Result<Arguments> readArguments(const QStringList& words) {
    Arguments out;
    auto said = ew::readToolWords(words,
                                  {QStringLiteral("check"), QStringLiteral("try"),
                                   QStringLiteral("pack"), QStringLiteral("overview")},
                                  {{"--out", &out.out},
                                   {"--step", &out.step},
                                   {"--strokes", &out.strokes},
                                   {"--class", &out.classFolder},
                                   {"--pupil", &out.pupil},
                                   {"--csv", &out.csv},
                                   {"--html", &out.html}});
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
    return arguments.command == QStringLiteral("check") ? check(arguments, templates->library)
                                                        : tryStrokes(arguments, templates->library);
}
