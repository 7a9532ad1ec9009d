// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/stroke/segmenting.h"

namespace ew {

/// A stroke that was cut into straight pieces.
struct CutStroke {
    const std::vector<Vec2>& nodes;        ///< evenly spaced ink [px]
    const std::vector<std::size_t>& cuts;  ///< piece i runs from node cuts[i] to cuts[i + 1]
    bool closed = false;                   ///< it ends where it began
};

/// The outline of a face with rounded corners, as drawing programs make it, is read as the sides
/// and the corners in which they would meet. A corner is rounded where the pieces between two
/// sides, all much shorter, follow a circle that touches both sides better than their own lines;
/// so a chamfer stays a side. What has no straight sides, as an ellipse, or turns back between
/// two of them, as a slot does, is left as it is.
/// \param pieces  one for each two cuts; sides are made to meet, pieces of rounded corners are
///                taken out.
/// \return was any corner rounded? Otherwise the pieces are as they were. O(n) in the nodes.
bool squareRoundedCorners(std::vector<Segment>& pieces, const CutStroke& stroke);

}  // namespace ew
