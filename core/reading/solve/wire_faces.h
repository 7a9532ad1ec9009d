// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/reading/extract/axis_frames.h"
#include "core/reading/extract/line_drawing.h"
#include "core/reading/solve/wire_lift.h"

namespace ew {

/// A face between wires.
struct WireFace {
    std::vector<std::vector<int>> loops;  ///< nodes; [0] the outer one, holes the other way round
};

/// The faces of a solid whose edges are the wires: regions of planes that two lines or more span,
/// two of them at every line, which do not lie in one plane there (Markowsky and Wesley 1980).
/// Where LineDrawing::regions are known they are the faces.
/// \param spreadPx  standard deviation of a corner, per axis.
/// \return one set of faces for each solid, counter-clockwise from outside; several where one wire
///         frame is that of several solids, four at most.
std::vector<std::vector<WireFace>> wireFaces(const LineDrawing& wires, const AxisFrame& frame,
                                             const WireLift& lift, double spreadPx);

}  // namespace ew
