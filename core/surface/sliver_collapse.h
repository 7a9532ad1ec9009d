// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface.
#pragma once

#include "core/surface/subdivision.h"

namespace ew {

/// Takes out triangles without an area that flipBadTriangles left: one of their sides is drawn
/// together into one of its ends, the shortest that can be, or is flipped; the longest one also
/// where it is a crease. The surface stays closed and 2-manifold, no other triangle is turned over,
/// and there are fewer of them each time. Where none can be, corners are moved aside within the
/// surface by what single precision just tells (leastHeight), those of triangles that get too low
/// by that after them, or by a few times that where the surface lies on itself already. Points that
/// no triangle needs any more are dropped. O(triangles) where there is anything to do.
void collapseSlivers(SurfaceMesh& surface);

}  // namespace ew
