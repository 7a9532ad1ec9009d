// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/stroke/consolidate.h"

namespace ew {

/// When two lines are one.
struct LineJoining {
    double overlap;  ///< of the shorter line lies on the other one, at least
    double bend;     ///< of a line in two strokes, sine, at most
    double off;      ///< from the line through both [distance thresholds]
};
/// Guide lines of two edges in line with one another lie on each other in part; but so does a line
/// that was drawn in two strokes.
inline constexpr LineJoining kStrictJoining{0.6, 0.12, 0.4};
inline constexpr LineJoining kLooseJoining{0.1, 0.25, 0.7};

/// How far a line that was drawn again may turn from the first one, sine.
inline constexpr double kAlongSine = 0.3;

/// Makes one line of what was drawn twice, or in two strokes, end to end. O(n^2).
/// \param distancePx  the distance threshold [px], > 0.
void joinAlike(std::vector<InkLine>& lines, const LineJoining& how, double distancePx);

}  // namespace ew
