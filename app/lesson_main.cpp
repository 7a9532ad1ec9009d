// SPDX-License-Identifier: GPL-3.0-or-later
// edgewright-lesson: checks and packs lessons without a window, and tries what a pupil drew.
#include <QCoreApplication>
#include <QFileInfo>
#include <QStringList>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

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
    "edgewright-lesson pack FOLDER --out FILE one file to pass on (.edgewright-lesson)\n"
    "  --json      print JSON\n"
    "  --help, --version\n"
    "FILE is a lesson: a folder with lesson.json, this file, or an .edgewright-lesson.\n"
    "Exit status: 0 all is well, 1 there are faults (one line each: FILE: /json/path: sentence) "
    "or\n"
    "the step is not done, 2 the arguments or a file cannot be used.\n";

struct Arguments : ew::ToolWords {
    QString out, step, strokes;
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

int tryStrokes(const Arguments& arguments, const ew::TemplateLibrary& library) {
    bool isNumber = false;
    const int step = arguments.step.toInt(&isNumber);
    if (!isNumber || step < 0 || arguments.strokes.isEmpty() || arguments.files.size() != 1) {
        return unusable("try needs one lesson, --step N and --strokes SCRIPT");
    }
    const auto lesson = ew::readLesson(arguments.files.front());
    if (!lesson) return unusable(lesson.error().message);
    const auto text = ew::readFileBytes(arguments.strokes, ew::kMaxScriptBytes);
    if (!text) return unusable(text.error().message);
    const auto script = ew::readSketchScript(*text);
    if (!script) return unusable(arguments.strokes.toStdString() + ": " + script.error().message);
    const auto tried = ew::tryStep(*lesson, static_cast<std::size_t>(step), *script, library);
    if (!tried) return unusable(tried.error().message);
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

ew::Result<Arguments> readArguments(const QStringList& words) {
    Arguments out;
    auto said = ew::readToolWords(
        words, {QStringLiteral("check"), QStringLiteral("try"), QStringLiteral("pack")},
        {{"--out", &out.out}, {"--step", &out.step}, {"--strokes", &out.strokes}});
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
    const auto templates = ew::loadTemplates();
    if (!templates) return unusable(templates.error().message);
    return arguments.command == QStringLiteral("check") ? check(arguments, templates->library)
                                                        : tryStrokes(arguments, templates->library);
}
