// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "core/stroke/segmenting.h"

namespace ew {

/// A line as it was meant: one segment, or several that retrace each other.
struct InkLine {
    Vec2 a = Vec2::Zero();     ///< [px]
    Vec2 b = Vec2::Zero();     ///< [px]
    std::vector<int> strokes;  ///< ascending, distinct
    std::vector<Vec2> points;  ///< all ink [px]
    double inkPx = 0.0;

    double length() const { return (b - a).norm(); }
    Vec2 direction() const { return (b - a).normalized(); }
};

struct ConsolidateOptions {
    double distancePx = 14.0;  ///< the distance threshold [px], > 0
    double scale = 1.0;        ///< multiplies every tolerance; < 1 keeps close lines apart
    std::size_t mostLines =
        std::numeric_limits<std::size_t>::max();  ///< stops where there are more
};

/// Merges overtraced lines by angle, distance and overlap; the merged line is fitted to the ink of
/// all. Broken lines (end to end) stay apart here: whether they are one edge depends on what else
/// ends there. O(n^2) in the number of segments.
/// \paper{4.1.1}
std::vector<InkLine> consolidate(const std::vector<Segment>& segments,
                                 const ConsolidateOptions& options);

}  // namespace ew
