// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/edge_graph/build.h"

namespace ew {

/// A drawing with the edges that follow from what was drawn.
struct CompletedInk {
    InkReading ink;  ///< each line that was added is of the stroke that it repeats
    int added = 0;   ///< lines, >= 1
};

/// Few lines may stand for a whole drawing. Three lines from a point are three edges of a block,
/// whose other edges are parallel to them. A closed outline of straight lines and one line that
/// leaves it at a corner are a prism of that depth, with the outline in front.
/// \param distancePx  the distance threshold [px], > 0.
/// \return nothing where there are other lines, too; O(n^2) in the number of lines.
std::vector<CompletedInk> completedGestures(const InkReading& ink, double distancePx);

}  // namespace ew
