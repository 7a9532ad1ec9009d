// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/reading/extract/axis_frames.h"
#include "core/reading/extract/line_drawing.h"
#include "core/reading/propose/shape_hypothesis.h"

namespace ew {

/// Solids of which a drawing shows all edges, those that are hidden, too.
/// \param wires     of wireDrawing().
/// \param spreadPx  standard deviation of a corner, per axis.
/// \paper{8}
std::vector<ShapeHypothesis> wireProposals(const LineDrawing& wires, const AxisFrame& frame,
                                           double spreadPx);

/// A wire frame may be looked at from above or from below. What speaks against a hypothesis by
/// that: lines upright in the picture go away from the eye towards their upper end.
/// \return share of the upright lines, 0..1; 0 where there are none.
double seenFromBelow(const ShapeHypothesis& h);

}  // namespace ew
