// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/solid.
#pragma once

#include <array>
#include <vector>

#include "core/base/result.h"
#include "core/solid/mesh_kernel.h"

namespace ew {

/// Constrained Delaunay triangulation of one planar face, in the projection along the main axis of
/// its normal (exact, no coordinate is constructed). Uses the face's own points only.
/// \param face  index for messages.
/// \return triangles counter-clockwise from outside. The same input gives the same triangles.
/// Errors: SelfIntersecting where loops cross, touch or overlap; NoVolume for a face without area.
Result<std::vector<std::array<int, 3>>> triangulateFace(const std::vector<Point3>& points,
                                                        const FaceLoops& loops, std::size_t face);

}  // namespace ew
