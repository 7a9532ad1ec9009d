// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/solid. The part of the gate that works on the mesh, in exact arithmetic.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/solid/mesh_kernel.h"

namespace ew {

/// No two of these triangles cross or touch but for what they share. Error: SelfIntersecting.
Result<void> checkFaces(const ExactMesh& surface, const std::vector<Mesh::FaceHandle>& faces);

/// Shells that lie in an even number of others look outwards, the others inwards. Errors:
/// NotOriented, NoVolume.
/// \pre closed, 2-manifold, free of self-intersection.
Result<void> checkShells(const ExactMesh& surface);

/// Volume of the closed surface [mm^3]; negative where it is inside out. The same for meshes that
/// hold the same triangles in the same order.
double volumeOf(const ExactMesh& surface);

/// Number of connected pieces of the surface; fills the piece of every face, by face index.
int shellsOf(const Mesh& mesh, std::vector<int>& shellOfFace);

}  // namespace ew
