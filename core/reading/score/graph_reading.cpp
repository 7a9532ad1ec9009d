// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/score/graph_reading.h"

#include <limits>
#include <string>

#include "core/reading/score/rivals.h"
#include "core/reading/types/reading_params.h"

namespace ew {
namespace {

double inkOf(const EdgeGraph& graph) {
    double sum = 0.0;
    for (const GraphEdge& e : graph.edges) sum += e.inkPx;
    return sum;
}

}  // namespace

void judge(GraphReading& r) {
    if (r.candidates.empty()) return;
    const RatedCandidate& best = r.candidates.front();
    r.cost = best.cost;
    for (const RatedCandidate& other : r.candidates) {
        r.ambiguous = r.ambiguous || isRival(best, other);
    }
    r.clear = best.withinThresholds && !r.ambiguous && !best.match.aspect->edgeOn;
}

bool better(const GraphReading& a, const GraphReading& b) {
    if (a.candidates.empty()) return false;
    if (b.candidates.empty()) return true;
    const bool withinA = a.candidates.front().withinThresholds;
    const bool withinB = b.candidates.front().withinThresholds;
    if (withinA != withinB) return withinA;
    return a.cost < b.cost;
}

const Slip* likeliestSlip(const std::vector<GraphReading>& readings, const GraphReading& best,
                          double inkPx, bool any) {
    const bool found = !best.candidates.empty() && best.candidates.front().withinThresholds;
    const double below = found ? best.candidates.front().cost + params::kSlipMargin
                               : std::numeric_limits<double>::infinity();
    const std::string known = found && !any ? best.candidates.front().candidate.templateId : "";
    constexpr double kLeastShare = 0.85;
    const Slip* least = nullptr;
    const auto look = [&](const GraphReading& r) {
        if (inkOf(r.graph) < kLeastShare * inkPx) return;
        const Slip* slip = likeliestSlip(r.slips, known, below);
        if (slip != nullptr && (least == nullptr || slip->cost < least->cost)) least = slip;
    };
    look(best);
    for (const GraphReading& r : readings) look(r);
    return least;
}

}  // namespace ew
