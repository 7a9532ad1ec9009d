// SPDX-License-Identifier: GPL-3.0-or-later
// Whole drawings: solids that no single template shows, drawn by a model of a hand, and what
// becomes of them.
//
//   whole_drawings [--count N] [--seed S] [--kind NAME] [--level NAME] [--index I] [--hidden]
//                  [--guides] [--reasons] [--dump DIR]
//
// N drawings a cell. Right: a solid was taken by itself with the right counts of vertices, edges,
// faces and shells, and its volume is within 1e-6, 12 or 25% by an exact, light or normal hand.
// --hidden: hidden edges are drawn, too. --guides: lines run past both of their ends, by a tenth
// to six tenths of a mean line. Deterministic in the seed; times are not.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "core/reading/interpret.h"
#include "core/tlib/library.h"
#include "tests/bench/reasons.h"
#include "tests/bench/recognition_report.h"
#include "tests/bench/thread_time.h"
#include "tests/support/sketch_generator.h"
#include "tests/support/whole_shapes.h"

namespace ew::test {
namespace {

struct Options {
    int count = 100;
    std::uint64_t seed = 1;
    std::string kind;
    std::string level;
    int index = -1;
    bool hidden = false;
    bool guides = false;
    bool reasons = false;
    std::string dump;
};

constexpr std::array<double, 3> kVolumeError{1e-6, 0.12, 0.25};

struct Result {
    Verdict verdict = Verdict::NotAccepted;
    bool offered = false;
    std::string detail;
    double ms = 0.0;
};

bool sameCounts(const Solid& a, const Solid& b) {
    return a.vertices().size() == b.vertices().size() && a.edges().size() == b.edges().size() &&
           a.faces().size() == b.faces().size() && a.shellCount() == b.shellCount();
}

std::string countsOf(const Solid& s) {
    return std::to_string(s.vertices().size()) + "/" + std::to_string(s.edges().size()) + "/" +
           std::to_string(s.faces().size());
}

/// The solid of a candidate; nothing where it is none.
std::optional<Solid> solidOfCandidate(const Candidate& c) {
    if (c.result) return c.result;
    auto made = Solid::fromSpec(c.spec);
    if (!made) return std::nullopt;
    return *std::move(made);
}

bool isRight(const Solid& solid, const Solid& truth, double volumeError) {
    return sameCounts(solid, truth) &&
           std::abs(solid.volume() / truth.volume() - 1.0) <= volumeError;
}

Result read(const WholeCase& drawn, const std::vector<Stroke>& strokes,
            const TemplateLibrary& library, double volumeError) {
    Result out;
    InterpretOptions options;
    options.camera = drawn.camera;
    const double before = threadTimeMs();
    const Interpretation reading = interpret(strokes, library, options);
    out.ms = threadTimeMs() - before;
    for (const Candidate& c : reading.candidates) {
        const auto solid = solidOfCandidate(c);
        if (solid && isRight(*solid, drawn.solid, volumeError)) out.offered = true;
    }
    if (!reading.accepted) {
        out.detail = reading.problem ? std::string(errcName(reading.problem->code)) : "no reason";
        return out;
    }
    const Candidate& taken = reading.candidates[static_cast<std::size_t>(*reading.accepted)];
    const auto solid = solidOfCandidate(taken);
    if (solid && isRight(*solid, drawn.solid, volumeError)) {
        out.verdict = Verdict::Right;
        return out;
    }
    out.verdict = Verdict::WrongInSilence;
    out.detail = "wrong: " + taken.templateId;
    if (solid && sameCounts(*solid, drawn.solid)) {
        char text[60];
        std::snprintf(text, sizeof(text), ", volume off by %.1g",
                      solid->volume() / drawn.solid.volume() - 1.0);
        out.detail += text;
    } else if (solid) {
        out.detail += " " + countsOf(*solid) + " for " + countsOf(drawn.solid);
    }
    return out;
}

struct Cell {
    int right = 0, wrong = 0, offered = 0;
    std::vector<double> ms;
    Reasons reasons;
};

Cell runCell(const Options& o, const std::string& kind, std::size_t level,
             const TemplateLibrary& library) {
    Cell cell;
    std::mutex lock;
    const auto work = [&](int first) {
        for (int i = first; i < o.count; i += 2) {
            if (o.index >= 0 && i != o.index) continue;
            const auto n = static_cast<std::uint64_t>(i);
            const auto row = static_cast<std::uint64_t>(
                std::find(wholeKinds().begin(), wholeKinds().end(), kind) - wholeKinds().begin());
            Random shape(Random::mix(o.seed, n, row));
            const WholeCase drawn = randomWholeCase(kind, shape);
            Random hand(Random::mix(o.seed, n, 100 + level));
            std::vector<Line2> lines = drawn.lines;
            if (o.hidden) lines.insert(lines.end(), drawn.hidden.begin(), drawn.hidden.end());
            if (o.guides) lines = withGuides(lines, hand);
            const std::vector<Stroke> strokes = drawByHand(lines, kLevels[level].hand, hand);
            if (!o.dump.empty()) {
                const std::string name =
                    kind + "-" + std::string(kLevels[level].name) + "-" + std::to_string(i);
                std::ofstream(o.dump + "/" + name + ".json")
                    << sketchScriptText(name, drawn.camera, {}, strokes);
            }
            const Result r =
                read(drawn, strokes, library, drawn.tellsVolume ? kVolumeError[level] : 10.0);
            const std::scoped_lock guard(lock);
            cell.right += r.verdict == Verdict::Right ? 1 : 0;
            cell.wrong += r.verdict == Verdict::WrongInSilence ? 1 : 0;
            cell.offered += r.offered ? 1 : 0;
            cell.ms.push_back(r.ms);
            if (!r.detail.empty()) cell.reasons[r.detail].push_back(i);
        }
    };
    std::thread other(work, 1);
    work(0);
    other.join();
    return cell;
}

double median(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + k, values.end());
    return values[static_cast<std::size_t>(k)];
}

void run(const Options& o, const TemplateLibrary& library) {
    std::printf("%-11s", "");
    for (const char* name : {"exact", "light", "normal"}) {
        std::printf(" | %6s: right wrong offered  ms med  max", name);
    }
    std::printf("\n");
    for (const std::string& kind : wholeKinds()) {
        if (!o.kind.empty() && kind != o.kind) continue;
        std::printf("%-11s", kind.c_str());
        std::vector<Cell> cells;
        for (std::size_t level = 0; level < 3; ++level) {
            if (!o.level.empty() && kLevels[level].name != o.level) continue;
            cells.push_back(runCell(o, kind, level, library));
            const Cell& c = cells.back();
            std::printf(" | %6s: %5d %5d %7d %7.0f %4.0f", std::string(kLevels[level].name).c_str(),
                        c.right, c.wrong, c.offered, median(c.ms, 0.5), median(c.ms, 1.0));
            std::fflush(stdout);
        }
        std::printf("\n");
        if (!o.reasons) continue;
        for (const Cell& c : cells) printReasons(c.reasons);
    }
}

}  // namespace
}  // namespace ew::test

int main(int argc, char** argv) {
    ew::test::Options o;
    for (int i = 1; i < argc; ++i) {
        const std::string arg = argv[i];
        const char* value = i + 1 < argc ? argv[i + 1] : "";
        if (arg == "--hidden") {
            o.hidden = true;
            continue;
        }
        if (arg == "--guides") {
            o.guides = true;
            continue;
        }
        if (arg == "--reasons") {
            o.reasons = true;
            continue;
        }
        ++i;
        if (arg == "--count") o.count = std::atoi(value);
        if (arg == "--seed") o.seed = std::strtoull(value, nullptr, 10);
        if (arg == "--kind") o.kind = value;
        if (arg == "--level") o.level = value;
        if (arg == "--index") o.index = std::atoi(value);
        if (arg == "--dump") o.dump = value;
        constexpr std::array<std::string_view, 6> kKnown{"--count", "--seed",  "--kind",
                                                         "--level", "--index", "--dump"};
        if (std::find(kKnown.begin(), kKnown.end(), arg) == kKnown.end()) {
            std::fprintf(stderr, "whole_drawings: no option \"%s\"; see the head of its source\n",
                         arg.c_str());
            return 2;
        }
    }
    const auto library = ew::loadLibrary(EDGEWRIGHT_SOURCE_DIR "/resources/templates");
    if (!library) {
        std::fprintf(stderr, "%s\n", library.error().message.c_str());
        return 2;
    }
    ew::test::run(o, library->library);
    return 0;
}
