// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/question.h"

#include <utility>
#include <vector>

#include "core/base/words.h"

namespace ew {

void askInstead(Interpretation& reading, const std::string& but) {
    const auto best = static_cast<std::size_t>(*reading.accepted);
    const std::string name = withArticle(reading.candidates[best].templateName);
    Repair use;
    use.kind = Repair::Kind::UseCandidate;
    use.candidate = *reading.accepted;
    use.label = "Take it as " + name;
    if (but.starts_with(", but")) use.label += " all the same";
    reading.repairs.push_back(std::move(use));
    std::vector<Vec2> where;
    for (const Junction& j : reading.graph.junctions) where.push_back(j.position);
    reading.problem =
        Error{Errc::Ambiguous, "This could be " + name + but + "; choose it, or draw on.",
              std::move(where)};
    reading.accepted.reset();
}

Interpretation wholeOf(WholeReading whole) {
    Interpretation read;
    read.graph = std::move(whole.graph);
    read.candidates = std::move(whole.candidates);
    read.accepted = 0;
    return read;
}

Interpretation offeredWhole(WholeReading whole) {
    Interpretation read = wholeOf(std::move(whole));
    askInstead(read, "");
    return read;
}

}  // namespace ew
