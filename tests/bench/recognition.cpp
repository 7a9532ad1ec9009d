// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing accuracy: draws random solids by a model of a hand and counts what is read rightly.
//
//   recognition [--count N] [--seed S] [--template ID] [--level NAME] [--index I] [--style NAME]
//               [--threads T] [--dump DIR] [--reasons] [--corners PX] [--eye WIDTHS]
//               [--told FILE]
//   recognition --drawings DIR     reads the drawings of a folder instead; see drawing_folder.h
//
// --corners: every corner is off by so much, the lines stay straight. --eye: in perspective, from
// so many widths of the drawing away (templates without T junctions). --told: writes what calibrate
// reads. N drawings a row (column of
// the table), the same solids and views on every level. Deterministic in the seed, whatever the
// number of threads; times are not.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "core/reading/interpret.h"
#include "core/tlib/library.h"
#include "tests/bench/drawing_folder.h"
#include "tests/bench/recognition_report.h"
#include "tests/bench/thread_time.h"
#include "tests/support/line_changes.h"
#include "tests/support/sketch_generator.h"

namespace ew::test {
namespace {

struct Options {
    int count = 2000;
    std::uint64_t seed = 1;
    std::string templateId;
    std::string level;
    HandStyle style = handStyles().front();
    int index = -1;
    int threads = 2;
    std::string dump;
    bool reasons = false;
    std::string drawings;    ///< a folder to read instead
    std::string told;        ///< file for the probabilities
    double cornersPx = 0.0;  ///< corners off by this, lines straight
    double eyeWidths = 0.0;  ///< distance of the eye [widths of the drawing], 0: parallel
};

/// One drawing of the benchmark; depends on the seed, the template and the index only.
struct Drawing {
    SketchCase sketch;
    std::vector<Stroke> strokes;
};

Drawing makeDrawing(const Options& options, int index, std::size_t level,
                    ReadabilityCounts* counts) {
    const std::vector<std::string>& ids = sketchTemplates();
    const std::string& id = options.templateId.empty()
                                ? ids[static_cast<std::size_t>(index) % ids.size()]
                                : options.templateId;
    const auto n = static_cast<std::uint64_t>(index);
    Random shape(Random::mix(options.seed, n));
    Drawing drawing{randomSketch(id, shape, counts), {}};
    Random hand(Random::mix(options.seed, n, level + 1));
    std::vector<Line2> lines = options.eyeWidths > 0.0
                                   ? linesInPerspective(drawing.sketch, options.eyeWidths)
                                   : drawing.sketch.drawing.lines();
    if (options.cornersPx > 0.0) lines = withMovedCorners(lines, options.cornersPx, hand);
    drawing.strokes = drawByHand(lines, kLevels[level].hand, hand, options.style.habits);
    return drawing;
}

bool isRight(const Candidate& c, const GroundTruth& truth) {
    return c.templateId == truth.templateId &&
           static_cast<int>(c.spec.vertices.size()) == truth.vertices &&
           static_cast<int>(specEdges(c.spec).size()) == truth.edges &&
           static_cast<int>(c.spec.faces.size()) == truth.faces;
}

std::string describe(const Candidate& c) {
    return c.templateId + " " + c.aspect + " " + c.readingId + ", " +
           std::to_string(c.spec.vertices.size()) + " vertices " +
           std::to_string(c.spec.faces.size()) + " faces, missing " +
           std::to_string(c.missingEdges) + " extra " + std::to_string(c.extraEdges);
}

Outcome judge(const Drawing& drawing, const Interpretation& reading) {
    const GroundTruth& truth = drawing.sketch.truth;
    Outcome out;
    out.templateId = truth.templateId;
    for (const Candidate& c : reading.candidates) out.amongCandidates |= isRight(c, truth);
    if (!reading.candidates.empty()) {
        const auto told = static_cast<std::size_t>(reading.accepted.value_or(0));
        out.probability = reading.candidates[told].probability;
        out.toldRight = isRight(reading.candidates[told], truth);
    }
    if (!reading.accepted) {
        out.verdict = Verdict::NotAccepted;
        out.detail =
            reading.problem ? std::string(errcName(reading.problem->code)) : "no reason given";
        out.detail += out.amongCandidates ? " (offered)" : " (not offered)";
        return out;
    }
    const Candidate& c = reading.candidates[static_cast<std::size_t>(*reading.accepted)];
    if (!isRight(c, truth)) {
        out.verdict = Verdict::WrongInSilence;
        out.detail = "WRONG, accepted " + describe(c);
        return out;
    }
    out.verdict = Verdict::Right;
    const auto& y = truth.yAnglesDeg;
    if (truth.templateId == "cube" && y &&
        *std::min_element(y->begin(), y->end()) >= kReadableCornerDeg) {
        const double error = std::abs(specVolume(c.spec) / truth.volume - 1.0);
        out.volumeError = std::isfinite(error) ? error : HUGE_VAL;
    }
    return out;
}

/// Writes what failed: one sketch script a drawing and index.tsv with the reasons.
class Dump {
  public:
    explicit Dump(std::string folder) : folder_(std::move(folder)) {
        if (folder_.empty()) return;
        std::filesystem::create_directories(folder_);
        index_.open(folder_ + "/index.tsv");
        index_ << "file\tlevel\ttemplate\tindex\tstrokes\treason\n";
    }
    void add(const Options& options, std::size_t level, const Outcome& outcome) {
        if (folder_.empty()) return;
        const bool volumeOff =
            outcome.volumeError && *outcome.volumeError > kLevels[level].allowedVolumeError;
        if (outcome.verdict == Verdict::Right && !volumeOff) return;
        const Drawing drawing = makeDrawing(options, outcome.index, level, nullptr);
        const std::string name(kLevels[level].name);
        const std::string stem =
            name + "-" + outcome.templateId + "-" + std::to_string(outcome.index);
        std::string reason = outcome.detail;
        if (volumeOff)
            reason = "volume off by " + std::to_string(100.0 * *outcome.volumeError) + "%";
        std::ofstream(folder_ + "/" + stem + ".json") << sketchScriptText(
            stem + ": " + reason, drawing.sketch.camera, Thresholds{}, drawing.strokes);
        index_ << stem << ".json\t" << name << '\t' << outcome.templateId << '\t' << outcome.index
               << '\t' << drawing.strokes.size() << '\t' << reason << '\n';
    }

  private:
    std::string folder_;
    std::ofstream index_;
};

std::vector<Outcome> runLevel(const Options& options, std::size_t level,
                              const TemplateLibrary& library, ReadabilityCounts& counts) {
    const int first = options.index >= 0 ? options.index : 0;
    const int last = options.index >= 0 ? options.index + 1 : options.count;
    std::vector<Outcome> outcomes(static_cast<std::size_t>(last - first));
    std::atomic<int> next{first};
    std::mutex mutex;
    const auto work = [&] {
        ReadabilityCounts mine;
        for (int i = next++; i < last; i = next++) {
            const Drawing drawing = makeDrawing(options, i, level, &mine);
            InterpretOptions interpretOptions;
            interpretOptions.camera = drawing.sketch.camera;
            const double start = threadTimeMs();
            const Interpretation reading = interpret(drawing.strokes, library, interpretOptions);
            const double took = threadTimeMs() - start;
            Outcome outcome = judge(drawing, reading);
            outcome.index = i;
            outcome.ms = took;
            outcomes[static_cast<std::size_t>(i - first)] = std::move(outcome);
        }
        const std::lock_guard lock(mutex);
        counts.add(mine);
    };
    std::vector<std::thread> threads;
    for (int t = 1; t < options.threads; ++t) threads.emplace_back(work);
    work();
    for (std::thread& t : threads) t.join();
    return outcomes;
}

void printSingle(const std::array<std::vector<Outcome>, kLevels.size()>& outcomes) {
    for (std::size_t level = 0; level < kLevels.size(); ++level) {
        for (const Outcome& o : outcomes[level]) {
            const char* verdict = o.verdict == Verdict::Right            ? "right"
                                  : o.verdict == Verdict::WrongInSilence ? "wrong"
                                                                         : "not accepted";
            std::printf("%-7s %s #%d: %s %s", std::string(kLevels[level].name).c_str(),
                        o.templateId.c_str(), o.index, verdict, o.detail.c_str());
            if (o.volumeError) std::printf(" volume off by %.3g%%", 100.0 * *o.volumeError);
            std::printf(" (%.2f ms)\n", o.ms);
        }
    }
}

void printRejections(const ReadabilityCounts& counts) {
    std::printf("Views tried %d, not readable by anyone %.1f%%:", counts.tried,
                100.0 * counts.rejectedTotal() / std::max(1, counts.tried));
    for (const auto& [rule, count] : counts.rejected) {
        std::printf("  %s %.1f%%", rule.c_str(), 100.0 * count / std::max(1, counts.tried));
    }
    std::printf("\n\n");
}

int run(const Options& options) {
    const auto load = loadLibrary(EDGEWRIGHT_SOURCE_DIR "/resources/templates");
    if (!load) {
        std::fprintf(stderr, "%s\n", load.error().message.c_str());
        return 2;
    }
    for (const Error& problem : load->problems) {
        std::fprintf(stderr, "template left out: %s\n", problem.message.c_str());
    }
    std::array<std::vector<Outcome>, kLevels.size()> outcomes;
    ReadabilityCounts counts;
    for (std::size_t level = 0; level < kLevels.size(); ++level) {
        if (!options.level.empty() && options.level != kLevels[level].name) continue;
        ReadabilityCounts again;  // every level draws the same views
        outcomes[level] = runLevel(options, level, load->library, again);
        counts = again;
    }
    std::vector<Outcome> all;
    for (const auto& level : outcomes) all.insert(all.end(), level.begin(), level.end());
    if (!options.told.empty() && !writeTold(options.told, all)) {
        std::fprintf(stderr, "cannot write %s\n", options.told.c_str());
        return 2;
    }
    Dump dump(options.dump);
    for (std::size_t level = 0; level < kLevels.size(); ++level) {
        for (const Outcome& o : outcomes[level]) dump.add(options, level, o);
    }
    if (options.index >= 0) {
        printSingle(outcomes);
        return 0;
    }
    std::printf(
        "Recognition: %d drawings a row, seed %llu, style %s, default thresholds, %zu templates\n",
        options.count, static_cast<unsigned long long>(options.seed),
        std::string(options.style.name).c_str(), load->library.size());
    printRejections(counts);
    printTable(outcomes, options.templateId);
    if (options.templateId.empty()) {
        for (const std::string& id : sketchTemplates()) printTable(outcomes, id);
    }
    if (options.reasons) {
        for (std::size_t i = 0; i < kLevels.size(); ++i) printReasons(kLevels[i], outcomes[i]);
    }
    return 0;
}

int usage(const char* problem) {
    std::fprintf(
        stderr,
        "%s\nrecognition [--count N] [--seed S] [--template ID] [--level NAME] [--index I]\n"
        "            [--style pen|mouse|designer|vector] [--threads T] [--dump DIR] [--reasons]\n"
        "            [--corners PX] [--eye WIDTHS] [--told FILE]\n"
        "recognition --drawings DIR\n",
        problem);
    return 2;
}

}  // namespace
}  // namespace ew::test

int main(int argc, char** argv) {
    using namespace ew::test;
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string key = argv[i];
        if (key == "--reasons") {
            options.reasons = true;
            continue;
        }
        if (key == "--help") {
            usage("Drawing accuracy on random hand-drawn sketches.");
            return 0;
        }
        if (i + 1 >= argc) return usage(("unknown option or missing value: " + key).c_str());
        const std::string value = argv[++i];
        if (key == "--count")
            options.count = std::max(1, std::atoi(value.c_str()));
        else if (key == "--seed")
            options.seed = std::strtoull(value.c_str(), nullptr, 10);
        else if (key == "--template")
            options.templateId = value;
        else if (key == "--level")
            options.level = value;
        else if (key == "--style") {
            const auto& styles = handStyles();
            const auto it = std::find_if(styles.begin(), styles.end(),
                                         [&](const HandStyle& s) { return s.name == value; });
            if (it == styles.end()) return usage(("unknown style: " + value).c_str());
            options.style = *it;
        } else if (key == "--index")
            options.index = std::max(0, std::atoi(value.c_str()));
        else if (key == "--threads")
            options.threads = std::max(1, std::atoi(value.c_str()));
        else if (key == "--dump")
            options.dump = value;
        else if (key == "--corners")
            options.cornersPx = std::atof(value.c_str());
        else if (key == "--eye")
            options.eyeWidths = std::atof(value.c_str());
        else if (key == "--drawings")
            options.drawings = value;
        else if (key == "--told")
            options.told = value;
        else
            return usage(("unknown option: " + key).c_str());
    }
    if (!options.drawings.empty()) return runDrawingFolder(options.drawings);
    const auto& ids = sketchTemplates();
    if (!options.templateId.empty() &&
        std::find(ids.begin(), ids.end(), options.templateId) == ids.end()) {
        return usage(("unknown template: " + options.templateId).c_str());
    }
    const auto known = [&](const LevelSpec& l) { return l.name == options.level; };
    if (!options.level.empty() && std::none_of(kLevels.begin(), kLevels.end(), known)) {
        return usage(("unknown level: " + options.level).c_str());
    }
    return run(options);
}
