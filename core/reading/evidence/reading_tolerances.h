// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/edge_graph/build.h"

namespace ew {

/// Tolerances to try, the plain ones first. None joins ends at a corner from farther than the
/// distance threshold; only a gap inside an edge may be wider.
const std::vector<ReadingOptions>& readingOptions();

/// Where the search for repairs starts from.
struct DraftOptions {
    ReadingOptions reading;
    double price = 0.0;
    double leastSpread = 0.0;  ///< for hands that miss by that much only [distance thresholds]
};
const std::vector<DraftOptions>& draftOptions();

}  // namespace ew
