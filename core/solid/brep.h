// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/solid.
#pragma once

#include "core/solid/mesh_kernel.h"

namespace ew {

/// The surface as a person counts it: triangles that share an edge and a region, or that lie in one
/// plane exactly, make one face; a point where only two faces meet along a straight line is no
/// corner. Faces come in the order of their first triangle, corners in the order of the vertices;
/// outer loops first, every loop from its smallest index.
struct PersonView {
    ExactBrep brep;
    std::vector<int> faceOfTriangle;  ///< by mesh face index
    bool changed = false;             ///< it differs from the mesh: regions merged, points dropped
};

/// \param regionCount  number of regions that the mesh was made from, to see if any merged.
/// \pre closed 2-manifold, free of self-intersection (a folded region has no loops to trace).
PersonView personView(const ExactMesh& surface, std::size_t regionCount);

/// Brings the loops of a face into the order of a PersonView, save for which loop is the outer one.
void orderLoops(FaceLoops& loops);

}  // namespace ew
