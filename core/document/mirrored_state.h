// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/document.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/document/document.h"

namespace ew {

/// What a candidate does, done on both sides of the document's mirror plane: a new solid that
/// reaches the plane becomes one with its mirror image, one that does not gets it as a second body;
/// what is added or cut is so on the other side as well. Faces that were drawn to lie in the plane
/// are put into it first.
/// \param after  what the candidate did without the plane.
/// \param reach  how far faces may be from the plane that they were drawn in [mm].
/// \pre before.mirror. Errors: those of makeTool() and combine().
Result<std::shared_ptr<const DocumentState>> withMirrorImage(
    const DocumentState& before, std::shared_ptr<const DocumentState> after,
    const Candidate& candidate, double reach);

/// The face of a body that is the mirror image of another one, by a point in that and its normal
/// (world); nothing where there is none.
std::optional<int> mirrorFace(const std::vector<Body>& bodies, int body, const Vec3& point,
                              const Vec3& normal, const MirrorPlane& plane);

/// The edges with those that are their mirror images, each once.
std::vector<EdgeRef> withMirrorEdges(const std::vector<Body>& bodies, std::vector<EdgeRef> edges,
                                     const MirrorPlane& plane);

}  // namespace ew
