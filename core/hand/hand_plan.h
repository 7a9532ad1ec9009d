// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/hand/hand_model.h"

namespace ew {

/// What one stroke is meant to be, before the hand shakes: a polyline from pen-down to pen-up.
struct PlannedStroke {
    std::vector<Vec2> points;  ///< n >= 2 [px]
    /// At a pen lift inside a broken edge the gap is planned, so the end is off across only.
    bool brokenStart = false;
    bool brokenEnd = false;
};

/// Divides lines into strokes of random order and direction, overtraced and broken as the level
/// says.
std::vector<PlannedStroke> planStrokes(const std::vector<Line2>& lines, const HandLevel& level,
                                       const HandHabits& habits, Random& random);

}  // namespace ew
