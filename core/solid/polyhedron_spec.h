// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/vec.h"

namespace ew {

/// A polyhedron as vertices and planar faces, in doubles: what reconstruction hands to the solid
/// room and what templates are made of. Coordinates that should be equal are equal to the bit
/// (parallel faces of a box share their coordinate).
struct PolyhedronSpec {
    std::vector<Vec3> vertices;           ///< body frame [mm]
    std::vector<std::vector<int>> faces;  ///< each a loop of >= 3 vertex indices, counter-clockwise
                                          ///< seen from outside; a face has no holes here
};

/// The bodies of a polyhedron that share no vertex, in the order of their first face; vertices in
/// the order in which they were. O(n).
std::vector<PolyhedronSpec> separateBodies(const PolyhedronSpec& spec);

}  // namespace ew
