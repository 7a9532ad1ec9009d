// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "core/base/vec.h"

namespace ew {

/// Constrained Delaunay triangulation of a polygon with holes, in the projection along the largest
/// axis of its normal. Adds no point; exact predicates on the rounded coordinates.
/// \param loops   indices into points, [0] the outline, counter-clockwise about `normal`.
/// \param inside  where given, further points of the triangles; those that are not inside the
///                polygon, or where another point is, are left out and taken off the list.
/// \return triangles counter-clockwise about `normal`; nothing where loops cross or touch.
std::optional<std::vector<std::array<int, 3>>> triangulatePlanar(
    const std::vector<Vec3>& points, std::span<const std::span<const int>> loops,
    const Vec3& normal, std::vector<int>* inside = nullptr);

}  // namespace ew
