// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/stroke/stroke.h"

namespace ew {

/// More strokes are no drawing that is read at once, and are not measured.
inline constexpr std::size_t kMostStrokesMeasured = 300;

/// The distance threshold that suits a drawing [px]: the default, or more where the drawing is
/// large and its strokes end farther than that from what they should meet. A hand's error grows
/// with what it draws.
///
/// Told by the gap from each stroke's end to the nearest other ink: four of five such gaps are
/// bridged, but none wider than a share of the drawing. O(ends x samples); at
/// once for more than kMostStrokesMeasured.
/// \param strokes  Sketch Plane px.
double suitedDistancePx(const std::vector<Stroke>& strokes);

}  // namespace ew
