// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/edge_graph/build.h"

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

}  // namespace ew
