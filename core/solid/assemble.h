// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/solid.
#pragma once

#include <memory>

#include "core/base/result.h"
#include "core/solid/mesh_kernel.h"

namespace ew {

/// Makes a solid from exact planar faces: triangulates every face, passes the whole gate of
/// docs/design.md, merges coplanar neighbours and drops points on straight edges, and fills the
/// person's view. Faces that are planar within tolerance only keep their triangles as facets of one
/// region.
/// Errors: those of Solid::fromSpec.
Result<std::shared_ptr<const Solid::Impl>> assemble(ExactBrep brep);

}  // namespace ew
