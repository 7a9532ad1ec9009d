// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/lesson/lesson.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

#include "core/document/file_bytes.h"
#include "core/document/json_text.h"
#include "core/document/replay.h"
#include "core/document/zip_file.h"

namespace ew {

using nlohmann::json;

namespace {

constexpr const char* kLessonFile = "lesson.json";
constexpr std::string_view kFormat = "edgewright-lesson";
constexpr std::size_t kLongestText = 2'000;
constexpr int kLongestMinutes = 600;
constexpr double kMostTolerance = 2.0;

/// Gives the content of a file of the lesson by its name.
using Files = std::function<Result<std::string>(const std::string& name)>;

bool isLanguage(const std::string& code) {
    const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const std::size_t under = code.find('_');
    const std::string language = code.substr(0, under);
    const std::string country = under == std::string::npos ? "" : code.substr(under + 1);
    const auto ofLetters = [&](const std::string& s) {
        return std::all_of(s.begin(), s.end(), isLetter);
    };
    return language.size() >= 2 && language.size() <= 3 && ofLetters(language) &&
           (under == std::string::npos || (country.size() == 2 && ofLetters(country)));
}

/// Reads lesson.json; places are "FILE: /json/path".
class LessonReader {
  public:
    LessonReader(std::string source, Files files)
        : source_(std::move(source)), files_(std::move(files)) {}

    Lesson read(const std::string& text) {
        auto tree = parseJson(text, {});
        if (!tree) throwRead(tree.error().code, source_ + ": " + tree.error().message);
        const ObjectReader in(*tree, source_ + ": /");
        in.allowOnly({"format", "version", "id", "languages", "title", "summary", "minutes",
                      "tools", "solution", "steps", "picture"});
        readHead(in);
        readSolution(in.require("solution"));
        readSteps(in.require("steps"));
        if (const json* picture = in.find("picture")) {
            auto bytes = files_(readString(*picture, at("/picture")));
            if (!bytes)
                throwRead(bytes.error().code, at("/picture") + ": " + bytes.error().message);
            lesson_.picture = *std::move(bytes);
        }
        return std::move(lesson_);
    }

  private:
    std::string at(const std::string& path) const { return source_ + ": " + path; }

    void readHead(const ObjectReader& in) {
        if (readString(in.require("format"), at("/format")) != kFormat) {
            throwRead(Errc::WrongFormat, at("/format") + ": this is no lesson");
        }
        if (in.require("version") != 1) {
            throwRead(Errc::WrongVersion, at("/version") + ": this program reads version 1");
        }
        lesson_.id = readString(in.require("id"), at("/id"));
        const bool plain = std::all_of(lesson_.id.begin(), lesson_.id.end(), [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
        });
        constexpr std::size_t kLongestId = 64;
        if (!plain || lesson_.id.empty() || lesson_.id.size() > kLongestId) {
            throwRead(Errc::BadValue, at("/id") + ": an id has 1 to 64 of a-z, 0-9 and -");
        }
        readLanguages(in.require("languages"));
        lesson_.title = readText(in.require("title"), "/title");
        if (const json* summary = in.find("summary")) {
            lesson_.summary = readText(*summary, "/summary");
        }
        if (const json* minutes = in.find("minutes")) {
            lesson_.minutes = readInt(*minutes, at("/minutes"), 1, kLongestMinutes);
        }
        if (const json* tools = in.find("tools")) {
            for (const json& tool : readArray(*tools, at("/tools"))) {
                lesson_.tools.push_back(readString(tool, at("/tools")));
            }
        }
    }

    void readLanguages(const json& value) {
        for (const json& item : readArray(value, at("/languages"))) {
            const std::string& code = readString(item, at("/languages"));
            const auto& known = lesson_.languages;
            if (!isLanguage(code) || std::find(known.begin(), known.end(), code) != known.end()) {
                throwRead(Errc::BadValue, at("/languages") + ": " + nameQuoted(code) +
                                              " is no language code, or comes twice");
            }
            lesson_.languages.push_back(code);
        }
        if (lesson_.languages.empty()) {
            throwRead(Errc::BadValue, at("/languages") + ": a lesson has at least one language");
        }
    }

    LessonText readText(const json& value, const std::string& path) const {
        if (!value.is_object()) {
            throwRead(Errc::WrongType, at(path) + ": texts are an object, by language");
        }
        LessonText out;
        for (const auto& [language, text] : value.items()) {
            const std::string place = at(path + "/" + language);
            const std::string& words = readString(text, place);
            if (words.size() > kLongestText) {
                throwRead(Errc::BadValue, place + ": a text has at most " +
                                              std::to_string(kLongestText) + " bytes");
            }
            out[language] = words;
        }
        return out;
    }

    void readSolution(const json& value) {
        std::string text;
        std::string place = at("/solution");
        if (value.is_string()) {
            const std::string& name = value.get_ref<const std::string&>();
            auto bytes = files_(name);
            if (!bytes) throwRead(bytes.error().code, place + ": " + bytes.error().message);
            text = *std::move(bytes);
            place = name;
        } else {
            text = value.dump();
        }
        auto script = readSketchScript(text);
        if (!script) throwRead(script.error().code, place + ": " + script.error().message);
        for (std::size_t i = 0; i < script->steps.size(); ++i) {
            if (!fileOfStep(script->steps[i])) continue;
            throwRead(Errc::BadValue, place + ": /steps/" + std::to_string(i) +
                                          ": a lesson has no step " +
                                          std::string(stepName(script->steps[i])));
        }
        lesson_.solution = *std::move(script);
    }

    void readSteps(const json& value) {
        const json::array_t& list = readArray(value, at("/steps"));
        if (list.empty()) throwRead(Errc::BadValue, at("/steps") + ": a lesson has steps");
        if (list.size() > kMaxLessonSteps) {
            throwRead(Errc::TooLarge, at("/steps") + ": a lesson has at most " +
                                          std::to_string(kMaxLessonSteps) + " steps");
        }
        for (std::size_t i = 0; i < list.size(); ++i) readStep(list[i], i);
        if (lesson_.steps.back().end != lesson_.solution.steps.size()) {
            throwRead(Errc::BadValue, at("/steps/" + std::to_string(list.size() - 1) + "/end") +
                                          ": the last step ends where the solution does, at " +
                                          std::to_string(lesson_.solution.steps.size()));
        }
    }

    void readStep(const json& value, std::size_t number) {
        const std::string path = "/steps/" + std::to_string(number);
        const ObjectReader in(value, at(path));
        in.allowOnly({"text", "hint", "end", "tolerance"});
        LessonStep step;
        step.text = readText(in.require("text"), path + "/text");
        if (const json* hint = in.find("hint")) step.hint = readText(*hint, path + "/hint");
        step.tolerance = kLessonTolerance;
        if (const json* tolerance = in.find("tolerance")) {
            step.tolerance = readNumber(*tolerance, at(path + "/tolerance"));
            if (!(step.tolerance > 0.0 && step.tolerance <= kMostTolerance)) {
                throwRead(Errc::BadValue, at(path + "/tolerance") + ": over 0, at most 2");
            }
        }
        const int least = lesson_.steps.empty() ? 0 : static_cast<int>(lesson_.steps.back().end);
        const int most = static_cast<int>(lesson_.solution.steps.size());
        step.end = static_cast<std::size_t>(
            readInt(in.require("end"), at(path + "/end"), least + 1, most));
        lesson_.steps.push_back(std::move(step));
    }

    std::string source_;
    Files files_;
    Lesson lesson_;
};

/// The files of a folder; none outside of it, not by a link either.
Files filesOf(const QString& folder) {
    return [folder](const std::string& name) -> Result<std::string> {
        const auto path = pathInside(folder, QString::fromStdString(name));
        if (!path) return fail(path.error());
        return readFileBytes(*path, kMaxLessonBytes);
    };
}

Result<Lesson> readWith(const std::string& text, const std::string& source, Files files) {
    try {
        return LessonReader(source, std::move(files)).read(text);
    } catch (ReadError& e) {
        return fail(std::move(e.error));
    }
}

Result<Lesson> readPacked(const std::string& bytes, const std::string& source) {
    ZipLimits limits;
    limits.bytesOfOne = kMaxLessonBytes;
    auto entries = readZip(bytes, limits);
    if (!entries) return fail(entries.error().code, source + ": " + entries.error().message);
    const auto files = [&entries](const std::string& name) -> Result<std::string> {
        for (const ZipEntry& e : *entries) {
            if (e.name == name) return e.content;
        }
        return fail(Errc::FileNotFound, "The lesson holds no file " + nameQuoted(name) + ".");
    };
    const auto text = files(kLessonFile);
    if (!text) return fail(text.error().code, source + ": " + text.error().message);
    return readWith(*text, source + ": " + kLessonFile, files);
}

}  // namespace

std::string textIn(const LessonText& text, const std::string& language) {
    for (const std::string& wanted :
         {language, language.substr(0, language.find('_')), std::string("en")}) {
        const auto found = text.find(wanted);
        if (found != text.end()) return found->second;
    }
    return text.empty() ? std::string() : text.begin()->second;
}

Result<Lesson> readLesson(const QString& path) {
    const QFileInfo info(path);
    const QString file = info.isDir() ? QDir(path).filePath(kLessonFile) : path;
    const auto bytes = readFileBytes(file, kMaxLessonBytes);
    if (!bytes) return fail(bytes.error());
    const std::string source = file.toStdString();
    if (bytes->starts_with("PK")) return readPacked(*bytes, source);
    return readWith(*bytes, source, filesOf(QFileInfo(file).absolutePath()));
}

Result<std::string> packLesson(const QString& folder) {
    if (auto lesson = readLesson(folder); !lesson) return fail(lesson.error());
    std::vector<ZipEntry> entries;
    const auto files = filesOf(folder);
    for (const QString& name : QDir(folder).entryList(QDir::Files | QDir::NoSymLinks, QDir::Name)) {
        auto bytes = files(name.toStdString());
        if (!bytes) return fail(bytes.error());
        entries.push_back({name.toStdString(), *std::move(bytes)});
    }
    return zipBytes(entries);
}

}  // namespace ew
