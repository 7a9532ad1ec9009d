// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/reading/score/candidates.h"

namespace ew {

/// Does a candidate pay more for how it fits than a hand that draws it would?
bool fitsPoorly(const RatedCandidate& candidate);

/// May the other one have been meant as well as the best? It shows another template, and its cost
/// is no more than so much higher: a drawing with a line too many or too few could have been meant
/// as something else altogether; and where a plainer shape fits as well as hands draw, it may be
/// what was meant.
bool isRival(const RatedCandidate& best, const RatedCandidate& other);

/// Is an edge of the solid many times as long as it was drawn, the solid thinner than this hand can
/// tell, or its picture narrower than what counts as meeting?
/// \param handPx      how far this hand's corners lie from where they are meant [px].
/// \param distancePx  the distance threshold [px].
bool isAbsurd(const RatedCandidate& candidate, double handPx, double distancePx,
              double worldPerPixel);

/// Does nothing that is seen of a candidate tell it from simpler solids? See hidesItsTaper().
bool looksAccidental(const RatedCandidate& candidate);

/// Those within the thresholds first, then the cheaper ones.
void sortCandidates(std::vector<RatedCandidate>& candidates);

}  // namespace ew
