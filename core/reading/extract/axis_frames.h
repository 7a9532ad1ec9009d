// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/reading/extract/line_drawing.h"

namespace ew {

/// Three directions of a drawing's lines that a parallel view can show at right angles to one
/// another.
struct AxisFrame {
    Mat3 axes = Mat3::Identity();  ///< body to camera, a rotation: column k is axis k
    std::vector<int> axisOf;       ///< per edge of the graph: axis that it runs along, -1 for none
    double share = 0.0;            ///< of all line length that runs along an axis, 0..1
};

/// Frames of all feasible triples of line directions, the likeliest first: most ink, then upright
/// in the picture, then along the lines of the lowest corner, where the body stands. Of the two
/// attitudes that look the same the one seen from above comes first. O(lines^2 + families^3).
/// \param spreadPx  standard deviation of a line's end, per axis.
/// \param most      frames at most, the two attitudes counting as two.
std::vector<AxisFrame> axisFrames(const LineDrawing& drawing, double spreadPx, std::size_t most);

}  // namespace ew
