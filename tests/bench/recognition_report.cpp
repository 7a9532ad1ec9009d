// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/recognition_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <map>

namespace ew::test {
namespace {

struct Column {
    int count = 0, right = 0, wrong = 0, offered = 0;
    std::vector<double> volume;
    std::vector<double> ms;
};

Column collect(const std::vector<Outcome>& outcomes, const std::string& only) {
    Column c;
    for (const Outcome& o : outcomes) {
        if (!only.empty() && o.templateId != only) continue;
        ++c.count;
        c.right += o.verdict == Verdict::Right ? 1 : 0;
        c.wrong += o.verdict == Verdict::WrongInSilence ? 1 : 0;
        c.offered += o.amongCandidates ? 1 : 0;
        if (o.volumeError) c.volume.push_back(*o.volumeError);
        c.ms.push_back(o.ms);
    }
    std::sort(c.volume.begin(), c.volume.end());
    std::sort(c.ms.begin(), c.ms.end());
    return c;
}

/// Nearest rank: the smallest value that at least this share of the values do not exceed.
double percentile(const std::vector<double>& sorted, double share) {
    if (sorted.empty()) return 0.0;
    const auto n = static_cast<double>(sorted.size());
    const auto rank = static_cast<std::size_t>(std::max(0.0, std::ceil(share * n) - 1.0));
    return sorted[std::min(rank, sorted.size() - 1)];
}

std::string percent(double share) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f%%", 100.0 * share);
    return text;
}

std::string relative(const std::vector<double>& sorted, double share) {
    if (sorted.empty()) return "-";
    const double value = percentile(sorted, share);
    char text[32];
    if (value < 1e-4) {
        std::snprintf(text, sizeof text, "%.1e", value);
        return text;
    }
    return percent(value);
}

std::string milliseconds(const std::vector<double>& sorted, double share) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f ms", percentile(sorted, share));
    return text;
}

}  // namespace

void printTable(const std::array<std::vector<Outcome>, kLevels.size()>& outcomes,
                const std::string& only) {
    std::vector<Column> columns;
    std::vector<const LevelSpec*> levels;
    for (std::size_t i = 0; i < kLevels.size(); ++i) {
        if (outcomes[i].empty()) continue;
        columns.push_back(collect(outcomes[i], only));
        levels.push_back(&kLevels[i]);
    }
    const auto row = [&](const char* label, const std::function<std::string(std::size_t)>& cell) {
        std::printf("%-42s", label);
        for (std::size_t i = 0; i < columns.size(); ++i) std::printf("%12s", cell(i).c_str());
        std::printf("\n");
    };
    const auto share = [&](std::size_t i, int count) {
        return percent(columns[i].count == 0 ? 0.0 : 1.0 * count / columns[i].count);
    };
    row(only.empty() ? "all templates" : only.c_str(),
        [&](std::size_t i) { return std::string(levels[i]->name); });
    row("  drawings", [&](std::size_t i) { return std::to_string(columns[i].count); });
    row("  right template and topology, accepted",
        [&](std::size_t i) { return share(i, columns[i].right); });
    row("    wanted, at least", [&](std::size_t i) { return percent(levels[i]->wantedRight); });
    row("  wrong solid accepted in silence",
        [&](std::size_t i) { return share(i, columns[i].wrong); });
    row("    allowed, at most", [&](std::size_t i) { return percent(levels[i]->allowedWrong); });
    row("  right one among the candidates",
        [&](std::size_t i) { return share(i, columns[i].offered); });
    if (only.empty() || only == "cube") {
        row("  cubes with readable corner, accepted",
            [&](std::size_t i) { return std::to_string(columns[i].volume.size()); });
        row("  their volume is off by: max",
            [&](std::size_t i) { return relative(columns[i].volume, 1.0); });
        row("    99th percentile",
            [&](std::size_t i) { return relative(columns[i].volume, 0.99); });
        row("    median", [&](std::size_t i) { return relative(columns[i].volume, 0.5); });
        row("    allowed, at most",
            [&](std::size_t i) { return relative({levels[i]->allowedVolumeError}, 1.0); });
    }
    row("  time: median", [&](std::size_t i) { return milliseconds(columns[i].ms, 0.5); });
    row("    99th percentile", [&](std::size_t i) { return milliseconds(columns[i].ms, 0.99); });
    row("    max", [&](std::size_t i) { return milliseconds(columns[i].ms, 1.0); });
    std::printf("\n");
}

void printReasons(const LevelSpec& level, const std::vector<Outcome>& outcomes) {
    std::map<std::string, int> reasons;
    for (const Outcome& o : outcomes) {
        if (o.verdict != Verdict::Right) ++reasons[o.templateId + ": " + o.detail];
    }
    if (reasons.empty()) return;
    std::vector<std::pair<int, std::string>> sorted;
    for (const auto& [reason, count] : reasons) sorted.emplace_back(count, reason);
    std::sort(sorted.rbegin(), sorted.rend());
    std::printf("%s, what was not right:\n", std::string(level.name).c_str());
    constexpr std::size_t kMostReasons = 25;
    for (std::size_t i = 0; i < std::min(kMostReasons, sorted.size()); ++i) {
        std::printf("  %6d  %s\n", sorted[i].first, sorted[i].second.c_str());
    }
    std::printf("\n");
}

bool writeTold(const std::string& path, const std::vector<Outcome>& outcomes) {
    std::ofstream out(path);
    for (const Outcome& o : outcomes) {
        if (!o.probability) continue;
        out << *o.probability << ' ' << (o.toldRight ? 1 : 0) << ' '
            << (o.verdict == Verdict::NotAccepted ? 0 : 1) << '\n';
    }
    return static_cast<bool>(out.flush());
}

}  // namespace ew::test
