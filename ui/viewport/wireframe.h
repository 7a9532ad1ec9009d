// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/base/camera.h"
#include "core/solid/polyhedron_spec.h"

namespace ew {

/// A piece of an edge as it is seen, or would be seen through the faces.
struct WireSegment {
    std::array<Vec2, 2> ends{Vec2::Zero(), Vec2::Zero()};  ///< [px]
    bool hidden = false;
};

/// A polyhedron's edges with the hidden parts told apart: general hidden-line removal for the
/// small shapes of templates and candidates. O(E^2 F) at worst; 1 ms at 40 edges.
/// \param spec  body frame; faces counter-clockwise from outside.
std::vector<WireSegment> wireSegments(const PolyhedronSpec& spec, const Pose& pose,
                                      const OrthographicCamera& camera);

/// A face with the side towards the eye, projected.
struct SeenFace {
    std::vector<Vec2> outline;   ///< [px]
    Vec3 normal = Vec3::Zero();  ///< unit, world
    Vec3 depth = Vec3::Zero();   ///< depth [px] at (x, y) is depth.x * x + depth.y * y + depth.z
};

/// The faces that look at the camera; ones seen edge-on are left out.
std::vector<SeenFace> seenFaces(const PolyhedronSpec& spec, const Pose& pose,
                                const OrthographicCamera& camera);

}  // namespace ew
