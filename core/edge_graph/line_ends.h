// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/stroke/consolidate.h"

namespace ew {

/// One end of a line: side 0 is InkLine::a, 1 is InkLine::b.
struct LineEnd {
    int line = -1;
    int side = 0;
};

/// Ends that meet at one vertex.
struct EndCluster {
    Vec2 position = Vec2::Zero();  ///< least-squares meeting point of the lines [px]
    std::vector<LineEnd> ends;     ///< at least one; never both ends of one line
};

struct JoinOptions {
    double distancePx = 14.0;  ///< the distance threshold [px]
    double scale = 1.0;        ///< multiplies the reach of every end
    double breakReach =
        1.3;  ///< widest gap in the middle of a line drawn in two strokes [thresholds]
};

/// How far an end may be from its junction [px]: the threshold, less for short lines.
double joinReach(const InkLine& line, const JoinOptions& options);

/// Distance of an end from a junction as the threshold counts it [px]: overshoot counts in part.
double endDistance(const InkLine& line, int side, const Vec2& junction);

/// The point where lines meet that have these ends: weighted least squares, each end being precise
/// across its line and loose along it.
/// \pre at least one end.
Vec2 meetingPoint(const std::vector<InkLine>& lines, const std::vector<LineEnd>& ends,
                  double distancePx);

/// Joins line ends bottom up, the best fitting pair of clusters first; a cluster is valid while
/// every end is within its reach of the common meeting point. Every end is in exactly one cluster.
/// O(k log k) for k pairs of ends near each other.
std::vector<EndCluster> joinEnds(const std::vector<InkLine>& lines, const JoinOptions& options);

}  // namespace ew
