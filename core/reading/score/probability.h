// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "core/reading/types/interpretation.h"

namespace ew {

/// Fills Candidate::probability from the evidence: that the first one is what was meant, from how
/// much dearer the next different result is and how well it fits for each of its lines (a logistic
/// curve), and what is left shared out among the others by their costs; together at most 1.
/// Candidates of one template that make the same counts of faces and corners are one result.
/// \param lines  that were drawn, at least 1.
/// \param other  cost of what is no candidate and may have been meant, if anything.
void tellProbabilities(std::vector<Candidate>& candidates, std::size_t lines,
                       double other = std::numeric_limits<double>::infinity());

/// The same for a reading that is not taken by itself: what made it a question is in no cost. Of
/// first readings that were asked about less than half were meant (tests/bench/calibrate).
void tellProbabilitiesOfQuestion(std::vector<Candidate>& candidates);

}  // namespace ew
