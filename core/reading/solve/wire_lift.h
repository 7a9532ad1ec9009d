// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/reading/extract/axis_frames.h"
#include "core/reading/extract/line_drawing.h"

namespace ew {

/// The corners of a wire frame in space.
struct WireLift {
    std::vector<Vec3> points;  ///< per node, camera space [px]; of a crossing zero
    /// Per axis and node: number of the plane across that axis that the corner lies in. Corners in
    /// one plane for certain have one number.
    std::array<std::vector<int>, 3> planes;
    double rank = 0.0;  ///< how much speaks for the depths of what hangs together by slanted lines
                        ///< only, or not at all: one for each line that comes to lie in a plane
                        ///< across an axis, and the like
};

/// Lifts a wire frame: corners joined by a line along an axis lie in common planes across the other
/// two, so do those of a face (LineDrawing::Region) with lines along two axes. Coordinates are
/// those that are seen nearest to the drawn corners (linear least squares). Parts that no such
/// plane joins have depths of their own: the likeliest lay most slanted lines into planes across an
/// axis, put what is in between into the middle, and let parts share planes. \param spreadPx
/// standard deviation of a corner, per axis. \return the likeliest first, four at most; none
/// without a line along an axis. O(nodes^3).
std::vector<WireLift> liftWires(const LineDrawing& wires, const AxisFrame& frame, double spreadPx);

}  // namespace ew
