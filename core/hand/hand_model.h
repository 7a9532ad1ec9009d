// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/hand/random.h"
#include "core/stroke/stroke.h"

namespace ew {

/// A straight line that a hand is to draw, from end to end [Sketch Plane px].
using Line2 = std::array<Vec2, 2>;

/// How badly the hand draws.
struct HandLevel {
    /// Standard deviation of the line's offset across its own direction [px]. The offset is a sum
    /// of four sines, so it never exceeds 2.83 times this. It fades over the last 15 px before a
    /// stroke's end, to 0, and before a corner, the more the sharper it is: there endErrorPx alone
    /// says how far off the pen is.
    double wobblePx = 0.0;
    /// Every stroke end is off by a vector uniformly distributed in the disc of this radius [px]
    /// (along the line and across it). Corners inside a stroke are off by up to half of it.
    double endErrorPx = 0.0;
    double overtraceProbability = 0.0;  ///< an edge gets a second stroke over 50 to 110% of it
    double breakProbability = 0.0;      ///< an edge is two strokes, 2 to 8 px apart or overlapping
    double hookPx = 0.0;                ///< longest flick at pen-down or pen-up [px]
};

inline constexpr HandLevel kExactHand{};
inline constexpr HandLevel kLightHand{0.8, 3.0, 0.0, 0.0, 0.0};
inline constexpr HandLevel kNormalHand{1.6, 6.0, 0.15, 0.10, 3.0};
inline constexpr HandLevel kRoughHand{2.8, 9.0, 0.30, 0.25, 5.0};

/// How a drawing is divided into strokes. The first four are probabilities of a drawing and sum
/// up to 1.
struct HandHabits {
    double oneStrokePerEdge = 0.4;
    double shortTrails = 0.3;     ///< the pen goes on over a corner with probability 0.5
    double wholeFaces = 0.2;      ///< closed loops round regions first, short trails for the rest
    double longTrails = 0.1;      ///< the pen goes on as long as it can
    double withoutLifting = 0.5;  ///< share of longTrails: edges are drawn again to get on
    /// An edge that is not broken is cut in two strokes that meet at a point of it.
    double cutProbability = 0.08;
    /// No stroke that is part of an edge is shorter than this [px]; shorter edges are drawn whole.
    double shortestPiecePx = 25.0;
    double hookProbability = 0.3;  ///< per stroke end, where the level has hooks
    double samplePeriodMs = 8.0;
    std::array<double, 2> cruisePx{3.0, 6.0};  ///< px a sample away from corners and ends
    /// Lines bow to one side: sagitta as a share of the length, up to this, either way. 0 for an
    /// exact hand.
    double bowShare = 0.0;
    /// Strokes run past both of their ends by up to this [px], as designers' lines do. 0 for an
    /// exact hand.
    double overshootPx = 0.0;
    double gridPx = 0.0;  ///< positions are rounded to multiples of this [px], as a mouse's are
    bool timed = true;    ///< false: no times, no pressure
    bool cornersOnly = false;  ///< no samples but ends and corners, as a vector drawing has
};

/// A way of drawing besides the level: what device, what schooling.
struct HandStyle {
    std::string_view name;
    HandHabits habits;
};

/// "pen": the habits above. "mouse": whole pixels, 10 to 24 px apart, untimed. "designer": bowed
/// lines (1.5%) that run past their ends by up to 10 px. "vector": ends and corners only, untimed.
const std::array<HandStyle, 4>& handStyles();

/// Draws the lines by hand: which strokes, in random order and direction, and every sample of them.
///
/// - Lines that share an end (within 1e-6 px) may be drawn in one stroke over the common corner.
/// - Across its direction a stroke wobbles by smooth noise (correlation length 20 to 60 px) and by
///   a tremor of a tenth of it; corners inside a stroke are rounded at about 1.5 wobblePx.
/// - The pen slows to a quarter of its speed at ends and corners, so samples get closer there;
///   pressure swells and fades.
/// - A hand without wobble and end error puts a sample exactly on every end and corner, and all
///   other samples on the lines between (to rounding).
///
/// It knows nothing about recognition: its numbers come from its level and habits alone.
/// Deterministic in `random`.
std::vector<Stroke> drawByHand(const std::vector<Line2>& lines, const HandLevel& level,
                               Random& random, const HandHabits& habits = {});

}  // namespace ew
