// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/solid. The part of the gate that works on the mesh, in exact arithmetic.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/solid/mesh_kernel.h"

namespace ew {

/// The geometric part of the gate, in exact arithmetic: no self-intersection, bounds a volume,
/// outward. Errors: SelfIntersecting, NotOriented (inside out, or a cavity with the sense of an
/// outer shell), NoVolume. \pre closed, 2-manifold triangle mesh.
Result<void> checkVolume(const ExactMesh& surface);

/// Exact volume of the closed surface [mm^3]; negative where it is inside out.
Rational exactVolume(const ExactMesh& surface);

/// Number of connected pieces of the surface; fills the piece of every face, by face index.
int shellsOf(const Mesh& mesh, std::vector<int>& shellOfFace);

}  // namespace ew
