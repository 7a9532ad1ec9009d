// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/edge_graph/build.h"

namespace ew {

/// A drawing of which only the edges are left.
struct TrimmedInk {
    InkReading ink;                ///< its segments are cut off where their edges end
    std::vector<NoiseItem> tails;  ///< what was cut off
    double share = 0.0;            ///< of the edges whose lines run past a corner; 0..1
    std::vector<int> dropped;      ///< strokes of lines that are no edge, ascending
    /// >= 0; length of what was cut off, in mean lengths of a line, and about one for each place
    /// that is read against the ink.
    double cost = 0.0;
};

/// Guide lines run past the corners that they lead to, on one side or on both. Of each line the
/// stretch between two crossings is an edge, so that stretches meet where they end: at least two in
/// a corner, or one on the inside of another. Three lines that meet in one point mean a corner.
/// Branch and bound over the stretches of all lines; the work is bounded.
/// \param distancePx  the distance threshold [px], > 0.
/// \param most        ways to trim that are looked for, >= 1.
/// \return the cheapest ways, each different; empty where few lines run past anything, where no way
///         fits, or where there are too many lines.
std::vector<TrimmedInk> trimGuideLines(const InkReading& ink, double distancePx, std::size_t most);

}  // namespace ew
