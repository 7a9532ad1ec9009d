// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface.
#pragma once

#include "core/surface/subdivision.h"

namespace ew {

/// Cuts flat parts of a surface anew, over the points that they have, where some of their triangles
/// lie on others: beside slivers of the control cage the parameters of a surface may run backwards,
/// within its plane. The points stay, but for those that lie beyond the border of their part and
/// are moved into it; so do the normals and the number of triangles. A part whose border crosses
/// itself stays as it is.
/// \param surface  of this cage. O(triangles), where nothing is to be done.
void unfoldFlatParts(const ControlCage& cage, SurfaceMesh& surface);

}  // namespace ew
