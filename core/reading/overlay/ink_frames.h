// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/edge_graph/build.h"

namespace ew {

/// The parallelepiped along three directions of the ink that just holds all of it, as a picture.
struct InkFrame {
    Vec2 center = Vec2::Zero();
    std::array<Vec2, 3> axes;  ///< whole edges [px]
    double sizePx = 0.0;
};

/// The frames of all triples of directions that lines of the ink share (those with most ink, at
/// most five). Seen along axis i, the outline is as wide as the other two axes together, which is
/// three linear equations for the three lengths.
/// \param hull  corners of the convex hull of the ink [px].
std::vector<InkFrame> inkFrames(const InkReading& ink, const std::vector<Vec2>& hull);

}  // namespace ew
