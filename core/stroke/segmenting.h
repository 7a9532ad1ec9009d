// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/vec.h"
#include "core/stroke/stroke.h"

namespace ew {

/// A straight piece of ink.
struct Segment {
    Vec2 a = Vec2::Zero();      ///< one end of the fitted line [px]
    Vec2 b = Vec2::Zero();      ///< the other end, in drawing direction where that is defined
    int stroke = -1;            ///< index of the stroke
    double inkPx = 0.0;         ///< length of ink [px]; more than |b - a| where it was overtraced
    double rmsPx = 0.0;         ///< rms distance of the ink to the line [px]
    std::vector<Vec2> points;   ///< evenly spaced ink points [px], for later refitting
    bool joinedToNext = false;  ///< the pen went on into the next segment without lifting
};

enum class StrokeKind { Polyline, Dot, Scribble, Curve };

struct StrokeReading {
    StrokeKind kind = StrokeKind::Polyline;
    std::vector<Segment> segments;  ///< in drawing order, empty unless Polyline
    std::vector<Vec2> outline;      ///< the thinned ink [px], for marking what was dropped
};

/// Splits one stroke at its corners and fits a line to each piece.
/// The corners are the optimal piecewise-linear partition of the resampled stroke: dynamic
/// programming over all partitions with total-least-squares residuals, the number of pieces chosen
/// by a penalised likelihood that knows how much the hand wobbles. (Chosen over ShortStraw, Wolin
/// et al. 2008, whose fixed window finds only three gestures in four whole.) Hooks at either end
/// are trimmed first; a stroke that retraces its own line is one segment.
/// \param stroke      n >= 1 finite samples [Sketch Plane px, y down], time order; any density.
/// \param index       copied to Segment::stroke.
/// \param distancePx  the distance threshold [px], > 0: the scale of what is small.
/// \param wobblePx    how far this hand strays from straight lines, rms [px], > 0.
/// \return kind Dot, Scribble or Curve where the stroke is no polyline: it is never forced to be
/// one. Cost: O(n) + O(m) with m <= 1500 resampled points.
/// \paper{4.1.1}
StrokeReading readStroke(const Stroke& stroke, int index, double distancePx, double wobblePx);

/// Total-least-squares line through points; ends are the extreme projections.
/// \pre at least one point.
struct LineFit {
    Vec2 center = Vec2::Zero();
    Vec2 direction = Vec2(1, 0);  ///< unit
    double rmsPx = 0.0;
    double tMin = 0.0, tMax = 0.0;  ///< extreme projections on direction, from center
};
LineFit fitLine(const std::vector<Vec2>& points);

}  // namespace ew
