// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/document.
#pragma once

#include <optional>
#include <vector>

#include "core/base/camera.h"
#include "core/solid/polyhedron_spec.h"
#include "core/solid/solid.h"
#include "core/stroke/stroke.h"

namespace ew {

/// A motion of the world: p to turn * p + shift.
struct Motion {
    Mat3 turn = Mat3::Identity();
    Vec3 shift = Vec3::Zero();  ///< [mm]

    Motion inverse() const { return {turn.transpose(), -(turn.transpose() * shift)}; }
    Pose operator()(const Pose& pose) const;
    /// The camera that sees what was moved as it was seen before.
    OrthographicCamera operator()(const OrthographicCamera& camera) const;
};

/// How a first solid is set upright on the ground: the face or else the edge that is nearest to it
/// is turned level (upright), about the least angle, and the lowest corner comes to z = 0.
/// \return nothing where nothing of it is within `angleDeg` of level: it was meant to lean.
std::optional<Motion> levelled(const PolyhedronSpec& spec, const Pose& pose, double angleDeg);

/// How a further solid is set on the ground beside others: level, and turned round the vertical to
/// faces of theirs that it nearly is parallel to, as far as its picture stays within the distance
/// threshold of what was drawn; then along the line of sight until it stands on the ground where
/// the others stand, unless it would run into one of them.
/// \pre there are others. \return nothing where none of this is possible.
std::optional<Motion> setBeside(const PolyhedronSpec& spec, const Pose& pose,
                                const std::vector<Body>& others, const OrthographicCamera& camera,
                                const Thresholds& thresholds);

}  // namespace ew
