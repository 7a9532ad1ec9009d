// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/base/vec.h"

namespace ew {

/// How far the base of a prism or pyramid is turned from the eye, told by how regular that makes
/// it: true length over drawn length along the picture of its axis, from 1.01 to 7.2 (82 to 8
/// degrees above the base). Every pair of edges that could be at right angles or equally long is
/// tried. O(corners^3).
/// \return nothing where no turn makes sense.
/// \param base  its picture [px], n >= 3.
/// \param axis  picture of its axis, not zero.
/// \param spread  standard deviation of its corners [px].
std::optional<double> foreshortening(const std::vector<Vec2>& base, const Vec2& axis,
                                     double spread);

/// How regular a polygon is: right angles, equal turns, equal sides and a mirror line each count,
/// the less the farther they are off.
/// \param spread  standard deviation of its corners, in its own unit.
double regularity(const std::vector<Vec2>& polygon, double spread);

}  // namespace ew
