// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "core/base/error.h"
#include "core/edge_graph/build.h"

namespace ew {

/// How a drawing's lines converge where it is in perspective.
struct Convergence {
    double degrees = 0.0;         ///< the widest angle between two lines that would meet
    std::array<Vec2, 2> where{};  ///< the middles of these two [px]
};

/// Does a drawing show edges that are parallel in space as an eye near to them would? Nearly all
/// lines fall into at most three families then, each of which meets in one point outside of the
/// drawing, and parallel lines fit at least two of them far worse: one alone may be the sides of a
/// body that tapers. Lines that share a corner are of two families.
/// O(lines^3).
/// \param spreadPx    standard deviation of a line's end per axis, > 0.
/// \param leastLines  of a family that tells anything, >= 3.
std::optional<Convergence> findConvergence(const EdgeGraph& graph, double spreadPx,
                                           std::size_t leastLines = 3);
/// ... by a hand that draws as these strokes were drawn.
std::optional<Convergence> findConvergence(const EdgeGraph& graph, const InkReading& ink,
                                           double distancePx, std::size_t leastLines = 3);

/// What is told of it.
Error perspectiveError(const Convergence& found);

}  // namespace ew
