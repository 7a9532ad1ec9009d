// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/reading/extract/axis_frames.h"
#include "core/reading/extract/line_drawing.h"
#include "core/reading/propose/shape_hypothesis.h"

namespace ew {

/// Solids of any shape that a drawing may show, by its lines alone: three directions are axes,
/// regions become planes, and what is hidden is closed the simplest way by planes behind the edges
/// that are seen.
/// \param spreadPx  standard deviation of a corner, per axis.
/// \paper{8}
std::vector<ShapeHypothesis> polyhedronProposals(const LineDrawing& drawing, const AxisFrame& frame,
                                                 double spreadPx);

}  // namespace ew
