// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface.
#pragma once

#include "core/surface/subdivision.h"

namespace ew {

/// Flips the longest side of triangles that run backwards although the surface does not, and of
/// those without an area. Where a face is narrower than the chords of one of its curved edges are
/// high, these cross the opposite edge; where a face of the control cage has a corner straight on
/// a crease, three points there are on one line. The points stay, the surface stays closed.
/// Creases are not flipped. O(triangles).
void flipBadTriangles(SurfaceMesh& surface);

}  // namespace ew
