// SPDX-License-Identifier: GPL-3.0-or-later
// Spoilt drawings: what the program says to drawings that are wrong in one way.
//
//   spoilt_drawings [--count N] [--seed S] [--kind NAME] [--level NAME] [--index I] [--reasons]
//                   [--dump DIR]
//
// N drawings a row. Read: the solid that was meant is taken all the same. Named: the error code is
// that of the fault and one of its places lies at it. Code: the code alone. Offered: refused for
// another reason, the solid that was meant is among the candidates. Wrong: another solid is taken
// in silence. Deterministic in the seed; times are not.
#include "tests/support/spoilt_drawings.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "core/reading/interpret.h"
#include "core/tlib/library.h"
#include "tests/bench/reasons.h"
#include "tests/bench/recognition_report.h"
#include "tests/bench/thread_time.h"

namespace ew::test {
namespace {

struct Options {
    int count = 20;
    std::uint64_t seed = 1;
    std::string kind;
    std::string level = "light";
    int index = -1;
    bool reasons = false;
    std::string dump;
};

struct Row {
    int read = 0, named = 0, code = 0, offered = 0, other = 0, wrong = 0;
    double longestMs = 0.0;
    Reasons reasons;
};

bool isMeant(const Candidate& c, const SpoiltDrawing& drawn) {
    const GroundTruth& truth = drawn.meant.truth;
    const auto solid = Solid::fromSpec(c.spec);
    return solid && static_cast<int>(solid->vertices().size()) == truth.vertices &&
           static_cast<int>(solid->edges().size()) == truth.edges &&
           static_cast<int>(solid->faces().size()) == truth.faces;
}

bool isNamed(const Error& error, const SpoiltDrawing& drawn) {
    return std::find(drawn.codes.begin(), drawn.codes.end(), errcName(error.code)) !=
           drawn.codes.end();
}

/// A place counts that is within 25 px of the fault, or nearer to it than a fifth of the drawing.
bool isAtItsPlace(const Error& error, const SpoiltDrawing& drawn) {
    if (drawn.places.empty()) return true;
    for (const Vec2& told : error.where) {
        for (const Vec2& at : drawn.places) {
            if ((told - at).norm() <= 25.0) return true;
        }
    }
    return false;
}

void judge(const SpoiltDrawing& drawn, const Interpretation& reading, int index, Row& row) {
    if (reading.accepted) {
        const Candidate& taken = reading.candidates[static_cast<std::size_t>(*reading.accepted)];
        const bool two = taken.result && taken.result->shellCount() > 1;
        const bool right = drawn.mayBeRead && (isMeant(taken, drawn) || two ||
                                               drawn.codes.front() == "separate-drawings");
        ++(right ? row.read : row.wrong);
        if (!right) {
            row.reasons["WRONG " + taken.templateId + " for " + drawn.meant.truth.templateId]
                .push_back(index);
        }
        return;
    }
    const Error& error = *reading.problem;
    if (isNamed(error, drawn)) {
        const bool placed = isAtItsPlace(error, drawn);
        ++(placed ? row.named : row.code);
        if (!placed) row.reasons["elsewhere: " + error.message].push_back(index);
        return;
    }
    const bool offered = std::any_of(reading.candidates.begin(), reading.candidates.end(),
                                     [&](const Candidate& c) { return isMeant(c, drawn); });
    ++(offered ? row.offered : row.other);
    row.reasons[std::string(errcName(error.code)) + (offered ? " (offered): " : ": ") +
                error.message]
        .push_back(index);
}

Row runRow(const Options& o, const SpoilingName& kind, const HandLevel& hand,
           const TemplateLibrary& library) {
    Row row;
    for (int i = 0; i < o.count; ++i) {
        if (o.index >= 0 && i != o.index) continue;
        Random random(Random::mix(o.seed, static_cast<std::uint64_t>(i),
                                  static_cast<std::uint64_t>(kind.kind) + 1));
        const SpoiltDrawing drawn = spoiltDrawing(kind.kind, hand, random);
        if (!o.dump.empty()) {
            const std::string name = std::string(kind.name) + "-" + std::to_string(i);
            std::ofstream(o.dump + "/" + name + ".json")
                << sketchScriptText(name, drawn.meant.camera, {}, drawn.strokes);
        }
        InterpretOptions options;
        options.camera = drawn.meant.camera;
        const double before = threadTimeMs();
        const Interpretation reading = interpret(drawn.strokes, library, options);
        row.longestMs = std::max(row.longestMs, threadTimeMs() - before);
        judge(drawn, reading, i, row);
    }
    return row;
}

void run(const Options& o, const TemplateLibrary& library) {
    HandLevel hand = kLightHand;
    for (const LevelSpec& level : kLevels) {
        if (level.name == o.level) hand = level.hand;
    }
    std::printf("%-18s  read named  code offered other wrong  longest ms\n", o.level.c_str());
    Row sum;
    for (const SpoilingName& kind : spoilings()) {
        if (!o.kind.empty() && kind.name != o.kind) continue;
        const Row row = runRow(o, kind, hand, library);
        std::printf("%-18s %5d %5d %5d %7d %5d %5d %11.0f\n", std::string(kind.name).c_str(),
                    row.read, row.named, row.code, row.offered, row.other, row.wrong,
                    row.longestMs);
        if (o.reasons) printReasons(row.reasons);
        std::fflush(stdout);
        sum.read += row.read;
        sum.named += row.named;
        sum.code += row.code;
        sum.offered += row.offered;
        sum.other += row.other;
        sum.wrong += row.wrong;
        sum.longestMs = std::max(sum.longestMs, row.longestMs);
    }
    std::printf("%-18s %5d %5d %5d %7d %5d %5d %11.0f\n", "all", sum.read, sum.named, sum.code,
                sum.offered, sum.other, sum.wrong, sum.longestMs);
}

}  // namespace
}  // namespace ew::test

int main(int argc, char** argv) {
    ew::test::Options o;
    for (int i = 1; i < argc; ++i) {
        const std::string arg = argv[i];
        if (arg == "--reasons") {
            o.reasons = true;
            continue;
        }
        const char* value = i + 1 < argc ? argv[i + 1] : "";
        ++i;
        if (arg == "--count") o.count = std::atoi(value);
        if (arg == "--seed") o.seed = std::strtoull(value, nullptr, 10);
        if (arg == "--kind") o.kind = value;
        if (arg == "--level") o.level = value;
        if (arg == "--index") o.index = std::atoi(value);
        if (arg == "--dump") o.dump = value;
    }
    const auto library = ew::loadLibrary(EDGEWRIGHT_SOURCE_DIR "/resources/templates");
    if (!library) {
        std::fprintf(stderr, "%s\n", library.error().message.c_str());
        return 2;
    }
    ew::test::run(o, library->library);
    return 0;
}
