// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/solid.
#pragma once

#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/solid/mesh_kernel.h"
#include "core/solid/operand.h"

namespace ew {

/// A solid that differs from another one in some place only.
struct ChangedBrep {
    ExactBrep brep;             ///< in the form that assemble() would give it
    std::vector<int> sameAs;    ///< by face: the face of the base with the same outline, or -1
    FacePlanes planes;          ///< by face, as Solid::Impl has them
    std::vector<int> vertexOf;  ///< by vertex of the base: its vertex here, ascending, or -1
    Box3 changed;               ///< outside of it, the two surfaces are the same set of points
};

/// Makes a solid of it, the same as assemble() would make, bit by bit. Triangles of unchanged faces
/// are kept, and of the gate only the parts are repeated that a change could break: closed and
/// 2-manifold for all, self-intersection where a triangle lies in the changed box, and the sense of
/// the shells. Errors: those of the gate.
Result<std::shared_ptr<const Solid::Impl>> reassemble(const Solid::Impl& base,
                                                      const ChangedBrep& changed);

}  // namespace ew
