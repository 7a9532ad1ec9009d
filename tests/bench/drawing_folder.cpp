// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/drawing_folder.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/document/document.h"
#include "core/document/replay.h"
#include "core/document/store.h"
#include "core/tlib/library.h"
#include "core/tlib/library_index.h"

namespace ew::test {
namespace {

enum class Answer { Right, OfferedFirst, Offered, Refused, Wrong };
constexpr std::array<const char*, 5> kAnswerNames{"right", "offered first", "offered", "refused",
                                                  "WRONG IN SILENCE"};
/// What a drawing shows: one template, nothing at all, or more than one template can.
enum class Kind { Template, Nothing, More };

struct Expected {
    Kind kind = Kind::More;
    std::string templateId;
    std::string text;
};

struct Row {
    std::string name;
    Expected expected;
    Answer answer = Answer::Refused;
    std::string detail;
};

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

Expected expectedFrom(const std::string& text, const TemplateLibrary& library) {
    Expected e{Kind::More, "", text};
    std::string shape = lower(text.substr(0, text.find(';')));
    shape = shape.substr(0, shape.find(" with details"));
    if (shape.rfind("nothing", 0) == 0) e.kind = Kind::Nothing;
    for (const auto& entry : library.index().entries) {
        const std::string name = lower(entry->tmpl.name);
        const bool box = shape == "box" && entry->tmpl.id == "cube";
        if (!box && shape != name && shape != entry->tmpl.id) continue;
        e.kind = Kind::Template;
        e.templateId = entry->tmpl.id;
    }
    return e;
}

std::string describe(const Interpretation& reading) {
    std::string out;
    if (reading.accepted) {
        out = reading.candidates[static_cast<std::size_t>(*reading.accepted)].templateId;
    } else if (reading.problem) {
        out = std::string(errcName(reading.problem->code)) + ": " + reading.problem->message;
    }
    if (reading.candidates.size() > 1 || !reading.accepted) {
        out += " [";
        for (const Candidate& c : reading.candidates) out += " " + c.templateId;
        out += " ]";
    }
    return out;
}

Answer judge(const Interpretation& reading, const Expected& expected) {
    const auto fits = [&](const Candidate& c) {
        return expected.kind == Kind::Template && c.templateId == expected.templateId;
    };
    if (reading.accepted) {
        const Candidate& c = reading.candidates[static_cast<std::size_t>(*reading.accepted)];
        return fits(c) ? Answer::Right : Answer::Wrong;
    }
    if (expected.kind != Kind::Template) return Answer::Refused;
    if (!reading.candidates.empty() && fits(reading.candidates.front())) {
        return Answer::OfferedFirst;
    }
    const bool among = std::any_of(reading.candidates.begin(), reading.candidates.end(), fits);
    return among ? Answer::Offered : Answer::Refused;
}

Row readDrawing(const std::string& folder, const std::string& name, const Expected& expected,
                const TemplateLibrary& library) {
    Row row{name, expected, Answer::Refused, ""};
    const auto text =
        readFileBytes(QString::fromStdString(folder + "/" + name + ".json"), kMaxScriptBytes);
    const auto script = text ? readSketchScript(*text) : Result<SketchScript>(fail(text.error()));
    if (!script) {
        row.detail = script.error().message;
        return row;
    }
    Document document(library);
    ReplayOptions options;
    const ReplayReport report = replay(document, *script, options);
    for (const StepReport& step : report.steps) {
        if (!step.interpretation) continue;
        row.answer = judge(*step.interpretation, expected);
        row.detail = describe(*step.interpretation);
        char time[32];
        std::snprintf(time, sizeof time, " (%.0f ms)", step.ms);
        row.detail += time;
    }
    return row;
}

void printTable(const std::vector<Row>& rows) {
    std::map<Kind, std::array<int, kAnswerNames.size()>> counts;
    for (const Row& row : rows) {
        std::printf("%-26s %-30s %-17s %s\n", row.name.c_str(), row.expected.text.c_str(),
                    kAnswerNames[static_cast<std::size_t>(row.answer)], row.detail.c_str());
        ++counts[row.expected.kind][static_cast<std::size_t>(row.answer)];
    }
    std::printf("\n%-22s", "");
    for (const char* name : kAnswerNames) std::printf("%18s", name);
    std::printf("\n");
    for (const auto& [kind, count] : counts) {
        const char* title = kind == Kind::Template  ? "one template"
                            : kind == Kind::Nothing ? "flat drawings"
                                                    : "more than a template";
        std::printf("%-22s", title);
        for (const int n : count) std::printf("%18d", n);
        std::printf("\n");
    }
}

}  // namespace

int runDrawingFolder(const std::string& folder) {
    const auto load = loadLibrary(EDGEWRIGHT_SOURCE_DIR "/resources/templates");
    if (!load) {
        std::fprintf(stderr, "%s\n", load.error().message.c_str());
        return 2;
    }
    std::ifstream in(folder + "/expect.json");
    const auto expect = nlohmann::json::parse(in, nullptr, false);
    if (!expect.is_object()) {
        std::fprintf(stderr, "%s/expect.json is not there or no JSON object\n", folder.c_str());
        return 2;
    }
    std::vector<Row> rows;
    for (const auto& [name, value] : expect.items()) {
        const std::string text = value.value("expect", "");
        rows.push_back(readDrawing(folder, name, expectedFrom(text, load->library), load->library));
    }
    printTable(rows);
    return 0;
}

}  // namespace ew::test
