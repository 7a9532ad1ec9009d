// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/score/probability.h"

#include <algorithm>
#include <cmath>

namespace ew {
namespace {

constexpr double kMostMargin = 30.0;  ///< more says no more
// Log odds, fitted by tests/bench/calibrate to the drawings of recognition (600 a row) and
// modification (20 a case) that were accepted.
constexpr double kBase = 2.997;
constexpr double kPerMargin = 0.0774;
constexpr double kPerFit = 0.1355;
/// ... and how many of the first readings that were asked about were right, for those told so.
constexpr double kOfQuestion = 0.45;
/// How fast the shares of what is dearer fall.
constexpr double kPerCost = 0.1;

bool isSameResult(const Candidate& a, const Candidate& b) {
    return a.templateId == b.templateId && a.operation == b.operation && a.body == b.body &&
           a.spec.vertices.size() == b.spec.vertices.size() &&
           a.spec.faces.size() == b.spec.faces.size();
}

}  // namespace

void tellProbabilities(std::vector<Candidate>& candidates, std::size_t lines, double other) {
    if (candidates.empty()) return;
    const Candidate& best = candidates.front();
    const double cost = best.evidence.cost();
    double next = other;
    for (const Candidate& c : candidates) {
        if (!isSameResult(best, c)) next = std::min(next, c.evidence.cost());
    }
    const double margin = std::clamp(next - cost, -kMostMargin, kMostMargin);
    const double misfit = (best.evidence.fit + best.evidence.stray + best.evidence.bare) /
                          static_cast<double>(std::max<std::size_t>(1, lines));
    const double likely = 1.0 / (1.0 + std::exp(-(kBase + kPerMargin * margin - kPerFit * misfit)));
    const auto weight = [&](const Candidate& c) {
        return std::exp(-kPerCost * std::max(0.0, c.evidence.cost() - cost));
    };
    double all = std::isfinite(other) ? std::exp(-kPerCost * std::max(0.0, other - cost)) : 0.0;
    for (std::size_t i = 1; i < candidates.size(); ++i) all += weight(candidates[i]);
    // Something else that nobody thought of has its share, too.
    constexpr double kUnknown = 0.2;
    all += kUnknown;
    for (Candidate& c : candidates) c.probability = (1.0 - likely) * weight(c) / all;
    candidates.front().probability = likely;
}

void tellProbabilitiesOfQuestion(std::vector<Candidate>& candidates) {
    if (candidates.empty()) return;
    const double likely = candidates.front().probability;
    const double now = kOfQuestion * likely;
    const double others = likely < 1.0 ? (1.0 - now) / (1.0 - likely) : 0.0;
    for (Candidate& c : candidates) c.probability = std::min(1.0, c.probability * others);
    candidates.front().probability = now;
}

}  // namespace ew
