// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/solid/polyhedron_spec.h"

namespace ew {

/// Most corners of a mesh that is made a shape of.
inline constexpr std::size_t kMaxMeshPoints = 20'000;

/// The shape that a closed mesh of triangles or polygons is: points of one place are one vertex,
/// neighbouring faces of one plane are one face, and vertices inside straight edges are gone.
/// Places are one within a millionth of the size, planes within a hundred-thousandth. Errors:
/// BadTemplate for a mesh that is not closed, one that touches itself in an edge or a point, one
/// with a hole in a face, or with more than kMaxMeshPoints; BadValue for indices that are none. O(n
/// log n).
Result<PolyhedronSpec> shapeOfMesh(const PolyhedronSpec& mesh);

}  // namespace ew
