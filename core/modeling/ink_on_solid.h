// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/edge_graph/build.h"
#include "core/modeling/model_view.h"
#include "core/modeling/placement.h"
#include "core/tlib/matcher.h"

namespace ew {

/// How far lines of this hand miss what they are meant to meet, told by their wobble alone [px]:
/// short lines hide a part of it, and corners are missed by more than lines wobble. Next to nothing
/// for an exact drawing.
double handNoisePx(const InkReading& ink);

/// Standard deviation per axis of where strokes end that aim at one place, by the ends of different
/// strokes that lie together [px]; 0 where none do.
double endSpread(const std::vector<Segment>& segments, double distancePx);
/// Ends of an unsteady hand are at least so far apart where they should meet [distance thresholds].
inline constexpr double kUnsteadySpread = 0.2;

/// Length of the ink that runs neither along an edge of the placed template nor along a visible one
/// of the model [px]. Edges of what is added count only where the solid does not hide them.
double unexplainedInk(const InkReading& ink, const Placement& placement, const GraphMatch& match,
                      const ModelView& view, double distancePx, double noisePx);

/// The strokes of which less than half runs along edges of the placed template or visible ones of
/// the model, and those that are no lines. Ascending.
std::vector<int> strokesBeside(const InkReading& ink, const Placement& placement,
                               const GraphMatch& match, const ModelView& view, double distancePx);

/// How much of the ink lies over the solid as it is seen, 0..1.
double shareOver(const InkReading& ink, const ModelView& view);

}  // namespace ew
