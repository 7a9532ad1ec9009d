// SPDX-License-Identifier: GPL-3.0-or-later
// Accuracy of sketching on a solid: draws changes by a model of a hand and counts what is read
// rightly.
//
//   modification [--count N] [--seed S] [--case TEXT] [--level NAME] [--index I] [--style NAME]
//                [--threads T] [--dump DIR] [--reasons] [--list] [--told FILE]
//
// --told writes what calibrate reads. N drawings a case, in turn from the first five cameras from
// which it is legible. Deterministic in the seed; times are not.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

#include "core/reading/interpret.h"
#include "core/solid/visibility.h"
#include "core/tlib/library.h"
#include "tests/bench/recognition_report.h"
#include "tests/bench/thread_time.h"
#include "tests/support/modification_cases.h"
#include "tests/support/sketch_generator.h"

namespace ew::test {
namespace {

struct Options {
    int count = 200;
    std::uint64_t seed = 1;
    std::string only;
    std::string level;
    HandStyle style = handStyles().front();
    int index = -1;
    int threads = 2;
    std::string dump;
    bool reasons = false;
    bool list = false;
    std::string told;  ///< file for the probabilities
};

struct Goal {
    double right, wrong;
};
constexpr std::array<Goal, 4> kGoals{{{1.0, 0.0}, {0.99, 0.005}, {0.96, 0.01}, {0.85, 0.03}}};
/// Of the volume that changed.
constexpr std::array<double, 4> kVolume{1e-6, 0.08, 0.15, 0.30};
/// What coincides within the distance threshold is snapped, which no drawing can tell apart.
constexpr double kSnappingPx = 14.0;

constexpr std::size_t kMostViews = 5;

struct Row {
    std::string name;
    std::vector<ModificationCase> views;  ///< legible ones
};

std::vector<Row> allRows(const Options& options) {
    std::vector<Row> rows;
    std::map<std::string, std::size_t> known;
    const auto add = [&](std::vector<ModificationCase> cases) {
        for (ModificationCase& c : cases) {
            const std::string name = c.scene + ": " + c.name;
            if (name.find(options.only) == std::string::npos) continue;
            const auto [it, added] = known.emplace(name, rows.size());
            if (added) rows.push_back({name, {}});
            auto& views = rows[it->second].views;
            if (views.size() < kMostViews && c.legible()) views.push_back(std::move(c));
        }
    };
    for (int view = 0; view < kModificationViews; ++view) {
        add(boxModifications({}, view));
        add(workedBoxModifications(view));
        add(prismModifications(view));
        add(jointModifications(view));
    }
    return rows;
}

struct Job {
    std::size_t row, level;
    int index;
    Outcome outcome;
};

const ModificationCase& caseOf(const Row& row, int index) {
    return row.views[static_cast<std::size_t>(index) % row.views.size()];
}

std::vector<Stroke> drawingOf(const Options& options, const Row& row, std::size_t level,
                              int index) {
    const auto name = static_cast<std::uint64_t>(std::hash<std::string>{}(row.name));
    Random hand(
        Random::mix(Random::mix(options.seed, name), static_cast<std::uint64_t>(index), level + 1));
    return drawByHand(linesOnPlane(caseOf(row, index)), kLevels[level].hand, hand,
                      options.style.habits);
}

void judge(const ModificationCase& c, const Interpretation& r, std::size_t level, Outcome& out) {
    out.templateId = c.templateId;
    const double before = c.target.solid.volume();
    const double change = std::abs(c.volume - before);
    const double slack =
        level == 0 ? 0.0 : kSnappingPx * c.camera.worldPerPixel * std::pow(change, 2.0 / 3.0) * 0.5;
    const auto right = [&](const Candidate& k) {
        return k.operation == c.operation && k.result &&
               static_cast<int>(k.result->vertices().size()) == c.vertices &&
               static_cast<int>(k.result->edges().size()) == c.edges &&
               static_cast<int>(k.result->faces().size()) == c.faces;
    };
    const auto volumeOff = [&](const Candidate& k) {
        return std::abs(k.result->volume() - c.volume);
    };
    for (const Candidate& k : r.candidates) {
        out.amongCandidates |= right(k) && volumeOff(k) <= kVolume[level] * change + slack;
    }
    if (!r.candidates.empty()) {
        const Candidate& told = r.candidates[static_cast<std::size_t>(r.accepted.value_or(0))];
        out.probability = told.probability;
        out.toldRight = right(told) && volumeOff(told) <= kVolume[level] * change + slack;
    }
    if (!r.accepted) {
        out.detail = r.problem ? std::string(errcName(r.problem->code)) : "no reason given";
        out.detail += out.amongCandidates ? " (offered)" : " (not offered)";
        return;
    }
    const Candidate& k = r.candidates[static_cast<std::size_t>(*r.accepted)];
    out.verdict = Verdict::WrongInSilence;
    if (!right(k)) {
        out.detail = "WRONG " + k.templateId + " " + k.aspect;
        if (k.result) {
            out.detail += " " + std::to_string(k.result->faces().size()) + " faces for " +
                          std::to_string(c.faces);
        }
        return;
    }
    out.volumeError = volumeOff(k) / change;
    if (volumeOff(k) > kVolume[level] * change + slack) {
        out.detail = "VOLUME";
        return;
    }
    out.verdict = Verdict::Right;
}

void printCandidates(const ModificationCase& c, const Interpretation& r) {
    const double before = c.target.solid.volume();
    std::printf("wanted: %+.1f mm^3, %d vertices %d edges %d faces\n", c.volume - before,
                c.vertices, c.edges, c.faces);
    for (const Candidate& k : r.candidates) {
        if (!k.result) continue;
        std::printf("  %-18s %-10s score %.3f, off by %.2f px, %+.1f mm^3, %zu %zu %zu\n",
                    k.templateId.c_str(), k.aspect.c_str(), k.score, k.residualPx,
                    k.result->volume() - before, k.result->vertices().size(),
                    k.result->edges().size(), k.result->faces().size());
    }
    if (r.problem) std::printf("  %s\n", r.problem->message.c_str());
}

void work(const Options& options, const std::vector<Row>& rows, const TemplateLibrary& library,
          std::vector<Job>& jobs) {
    std::atomic<std::size_t> next{0};
    const auto one = [&] {
        for (std::size_t j = next++; j < jobs.size(); j = next++) {
            Job& job = jobs[j];
            const Row& row = rows[job.row];
            const ModificationCase& c = caseOf(row, job.index);
            const auto strokes = drawingOf(options, row, job.level, job.index);
            InterpretOptions o;
            o.camera = c.camera;
            o.bodies = {c.target};
            const double start = threadTimeMs();
            const Interpretation r = interpret(strokes, library, o);
            const double took = threadTimeMs() - start;
            if (options.index >= 0) printCandidates(c, r);
            judge(c, r, job.level, job.outcome);
            job.outcome.index = job.index;
            job.outcome.ms = took;
        }
    };
    std::vector<std::thread> threads;
    for (int t = 1; t < options.threads; ++t) threads.emplace_back(one);
    one();
    for (std::thread& t : threads) t.join();
}

struct Tally {
    int n = 0, right = 0, wrong = 0, offered = 0;
    std::vector<double> ms;
    void add(const Outcome& o) {
        ++n;
        right += o.verdict == Verdict::Right ? 1 : 0;
        wrong += o.verdict == Verdict::WrongInSilence ? 1 : 0;
        offered += o.verdict == Verdict::NotAccepted && o.amongCandidates ? 1 : 0;
        ms.push_back(o.ms);
    }
    double quantile(double q) {
        if (ms.empty()) return 0;
        std::sort(ms.begin(), ms.end());
        return ms[static_cast<std::size_t>(q * static_cast<double>(ms.size() - 1))];
    }
};

void print(const std::vector<Row>& rows, const std::vector<Job>& jobs) {
    std::printf("%-48s", "accepted and right / wrong in silence [%]");
    for (const LevelSpec& l : kLevels) std::printf(" %14s", std::string(l.name).c_str());
    std::printf("\n");
    std::map<std::pair<std::size_t, std::size_t>, Tally> cells;
    std::array<Tally, 4> all;
    for (const Job& j : jobs) {
        cells[{j.row, j.level}].add(j.outcome);
        all[j.level].add(j.outcome);
    }
    const auto cell = [](const Tally& t) {
        if (t.n == 0) {
            std::printf(" %14s", "");
        } else {
            std::printf("  %6.1f /%5.1f", 100.0 * t.right / t.n, 100.0 * t.wrong / t.n);
        }
    };
    for (std::size_t r = 0; r < rows.size(); ++r) {
        std::printf("%-48s", rows[r].name.c_str());
        for (std::size_t l = 0; l < kLevels.size(); ++l) cell(cells[{r, l}]);
        if (rows[r].views.size() < kMostViews) {
            std::printf("  from %zu cameras", rows[r].views.size());
        }
        std::printf("\n");
    }
    std::printf("%-48s", "all");
    for (const Tally& t : all) cell(t);
    std::printf("\n%-48s", "wanted");
    for (const Goal& g : kGoals) std::printf("  %6.1f /%5.1f", 100.0 * g.right, 100.0 * g.wrong);
    std::printf("\n%-48s", "not accepted, right one offered [%]");
    for (const Tally& t : all) {
        std::printf(" %14.1f", t.n > 0 ? 100.0 * t.offered / t.n : 0.0);
    }
    for (const double q : {0.5, 0.9, 0.99}) {
        std::printf("\ntime, %2.0f%% within [ms]%26s", 100 * q, "");
        for (Tally& t : all) std::printf(" %14.1f", t.quantile(q));
    }
    std::printf("\n");
}

/// A picture of a drawing: the model grey, strokes black, the best candidate's template red.
void writePicture(const std::string& path, const ModificationCase& c,
                  const std::vector<Stroke>& strokes, const Interpretation& r) {
    std::ofstream svg(path);
    svg << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='380 140 520 520' width='520' "
           "height='520'><rect x='380' y='140' width='520' height='520' fill='white'/>\n";
    const auto line = [&](const Vec2& a, const Vec2& b, const char* style) {
        svg << "<line x1='" << a.x() << "' y1='" << a.y() << "' x2='" << b.x() << "' y2='" << b.y()
            << "' " << style << "/>\n";
    };
    const auto view = SolidView::make(c.target.solid, c.target.pose, c.camera);
    for (const VisiblePiece& p : view->visiblePieces()) {
        line(p.px[0], p.px[1], "stroke='#aaa' stroke-width='3'");
    }
    for (const Stroke& s : strokes) {
        for (std::size_t i = 0; i + 1 < s.samples.size(); ++i) {
            line(s.samples[i].position, s.samples[i + 1].position,
                 "stroke='black' stroke-width='1.5'");
        }
    }
    if (r.candidates.empty()) {
        svg << "</svg>\n";
        return;
    }
    const Candidate& k = r.candidates[static_cast<std::size_t>(r.accepted.value_or(0))];
    for (const SpecEdge& e : specEdges(k.spec)) {
        line(c.camera.project(k.pose.toWorld(k.spec.vertices[static_cast<std::size_t>(e.ends[0])])),
             c.camera.project(k.pose.toWorld(k.spec.vertices[static_cast<std::size_t>(e.ends[1])])),
             "stroke='red' stroke-width='1'");
    }
    svg << "</svg>\n";
}

void dump(const Options& options, const TemplateLibrary& library, const std::vector<Row>& rows,
          const std::vector<Job>& jobs) {
    if (options.dump.empty()) return;
    std::filesystem::create_directories(options.dump);
    std::ofstream index(options.dump + "/index.tsv");
    for (const Job& j : jobs) {
        if (j.outcome.verdict == Verdict::Right) continue;
        std::string stem = std::string(kLevels[j.level].name) + "-" + rows[j.row].name + "-" +
                           std::to_string(j.index);
        std::replace_if(
            stem.begin(), stem.end(), [](char c) { return c == ' ' || c == ':'; }, '_');
        const ModificationCase& c = caseOf(rows[j.row], j.index);
        const auto strokes = drawingOf(options, rows[j.row], j.level, j.index);
        std::ofstream(options.dump + "/" + stem + ".json")
            << sketchScriptText(stem, c.camera, Thresholds{}, strokes);
        InterpretOptions o;
        o.camera = c.camera;
        o.bodies = {c.target};
        writePicture(options.dump + "/" + stem + ".svg", c, strokes,
                     interpret(strokes, library, o));
        index << stem << ".json\t" << j.outcome.detail << '\n';
    }
}

int run(const Options& options) {
    const auto load = loadLibrary(EDGEWRIGHT_SOURCE_DIR "/resources/templates");
    if (!load) {
        std::fprintf(stderr, "%s\n", load.error().message.c_str());
        return 2;
    }
    std::vector<Row> rows = allRows(options);
    if (options.list) {
        for (const Row& r : rows) {
            for (const ModificationCase& c : r.views) {
                std::printf("%s, view %d: %zu lines, %d vertices %d edges %d faces\n",
                            r.name.c_str(), c.view, c.lines.size(), c.vertices, c.edges, c.faces);
            }
        }
        return 0;
    }
    for (const Row& r : rows) {
        if (r.views.empty()) std::printf("legible from nowhere: %s\n", r.name.c_str());
    }
    std::erase_if(rows, [](const Row& r) { return r.views.empty(); });
    std::vector<Job> jobs;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (std::size_t l = 0; l < kLevels.size(); ++l) {
            if (!options.level.empty() && options.level != kLevels[l].name) continue;
            // An exact drawing differs in its cutting into strokes only.
            const int n =
                l == 0 ? std::min(options.count, static_cast<int>(2 * kMostViews)) : options.count;
            for (int i = 0; i < n; ++i) {
                if (options.index < 0 || options.index == i) jobs.push_back({r, l, i, {}});
            }
        }
    }
    work(options, rows, load->library, jobs);
    std::printf("Modification: %d drawings a case, seed %llu, style %s, default thresholds\n",
                options.count, static_cast<unsigned long long>(options.seed),
                std::string(options.style.name).c_str());
    print(rows, jobs);
    std::vector<Outcome> outcomes;
    for (const Job& j : jobs) outcomes.push_back(j.outcome);
    if (!options.told.empty() && !writeTold(options.told, outcomes)) {
        std::fprintf(stderr, "cannot write %s\n", options.told.c_str());
        return 2;
    }
    if (options.reasons) {
        std::map<std::string, int> reasons;
        for (const Job& j : jobs) {
            if (j.outcome.verdict == Verdict::Right) continue;
            std::string volume;
            if (j.outcome.volumeError) {
                volume =
                    " off by " +
                    std::to_string(static_cast<int>(100 * std::min(*j.outcome.volumeError, 1e6))) +
                    "%";
            }
            ++reasons[std::string(kLevels[j.level].name) + "  " + rows[j.row].name + " view " +
                      std::to_string(caseOf(rows[j.row], j.index).view) + ": " + j.outcome.detail +
                      volume];
        }
        for (const auto& [reason, n] : reasons) std::printf("%4d %s\n", n, reason.c_str());
    }
    dump(options, load->library, rows, jobs);
    return 0;
}

int usage(const std::string& problem) {
    std::fprintf(
        stderr,
        "%s\nmodification [--count N] [--seed S] [--case TEXT] [--level NAME] [--index I]\n"
        "             [--style pen|mouse|designer|vector] [--threads T] [--dump DIR] [--reasons] "
        "[--list] [--told FILE]\n",
        problem.c_str());
    return 2;
}

}  // namespace
}  // namespace ew::test

int main(int argc, char** argv) {
    using namespace ew::test;
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string key = argv[i];
        if (key == "--reasons" || key == "--list") {
            (key == "--list" ? options.list : options.reasons) = true;
            continue;
        }
        if (key == "--help") {
            usage("Accuracy of sketching on a solid.");
            return 0;
        }
        if (i + 1 >= argc) return usage("unknown option or missing value: " + key);
        const std::string value = argv[++i];
        if (key == "--count")
            options.count = std::max(1, std::atoi(value.c_str()));
        else if (key == "--seed")
            options.seed = std::strtoull(value.c_str(), nullptr, 10);
        else if (key == "--case")
            options.only = value;
        else if (key == "--level")
            options.level = value;
        else if (key == "--style") {
            const auto& styles = handStyles();
            const auto it = std::find_if(styles.begin(), styles.end(),
                                         [&](const HandStyle& s) { return s.name == value; });
            if (it == styles.end()) return usage("unknown style: " + value);
            options.style = *it;
        } else if (key == "--index")
            options.index = std::max(0, std::atoi(value.c_str()));
        else if (key == "--threads")
            options.threads = std::max(1, std::atoi(value.c_str()));
        else if (key == "--dump")
            options.dump = value;
        else if (key == "--told")
            options.told = value;
        else
            return usage("unknown option: " + key);
    }
    return run(options);
}
