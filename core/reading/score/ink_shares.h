// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/edge_graph/build.h"
#include "core/reading/score/candidates.h"

namespace ew {

/// What the ink of a drawing in free space is to a candidate, as lengths [px].
struct InkShares {
    double edges = 0.0;   ///< along edges that it shows
    double hidden = 0.0;  ///< along edges that it hides, where most of those were drawn
    double detail = 0.0;  ///< inside a face that it shows: a window, a label
    double stray = 0.0;   ///< none of these
    double all() const { return edges + hidden + detail + stray; }
};

/// \param nearPx  how far from an edge ink may run that was drawn for it [px].
/// \param pastPx  how far an edge may be overshot [px].
InkShares shareInk(const InkReading& ink, const RatedCandidate& candidate, double nearPx,
                   double pastPx);

/// The strokes of which less than half runs along an edge of the candidate, hidden ones included,
/// and those that are no lines. Ascending.
std::vector<int> strokesBeside(const InkReading& ink, const RatedCandidate& candidate,
                               double nearPx, double pastPx);

}  // namespace ew
