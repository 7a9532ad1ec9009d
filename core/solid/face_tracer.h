// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/solid.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/solid/overlay.h"

namespace ew {

/// A face of a boolean's result; loops hold points of the overlay, in the order of orderLoops().
struct TracedFace {
    FaceLoops loops;
    FaceOrigin origin;
    std::shared_ptr<const RPlane> plane;  ///< null where it is planar within tolerance only
};

/// Puts the sides of an overlay together to faces: loops turn round the face's inside, points on
/// straight edges are dropped, holes go to the outline round them.
/// Errors: TouchesInEdge, TouchesInPoint.
Result<std::vector<TracedFace>> traceFaces(const Overlay& overlay, const Operand& target,
                                           const Operand& tool);

}  // namespace ew
