// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/solid: the steps from triangles to a finished solid.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/solid/mesh_kernel.h"

namespace ew {

struct Triangulated {
    std::vector<std::array<int, 3>> triangles;
    std::vector<int> regions;  ///< face of every triangle
};

/// Makes the mesh. Error: NotManifold where the triangles do not join to a closed 2-manifold.
Result<void> fillMesh(const std::vector<Point3>& points, const Triangulated& from, ExactMesh& to);

/// The plane of a face; null where its points do not lie in one plane exactly.
std::shared_ptr<const RPlane> exactPlane(const std::vector<Point3>& points, const FaceLoops& loops);

/// Fills the person's view and the measures.
/// \pre the surface passed the gate; faceOfTriangle ascends with the mesh faces; planes by face.
std::shared_ptr<const Solid::Impl> finishSolid(ExactMesh surface, const ExactBrep& brep,
                                               const std::vector<int>& faceOfTriangle,
                                               FacePlanes planes);

}  // namespace ew
