// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/score/graph_reading.h"

#include "core/reading/score/rivals.h"

namespace ew {

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

}  // namespace ew
