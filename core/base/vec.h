// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>

namespace ew {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// z component of the cross product. In Sketch Plane px (y down) positive means that b is
/// clockwise of a on the screen.
inline double cross2(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// A rigid motion: rotation after which the translation is added. World units (mm).
struct Pose {
    Mat3 rotation = Mat3::Identity();
    Vec3 translation = Vec3::Zero();

    Vec3 toWorld(const Vec3& body) const { return rotation * body + translation; }
    Vec3 toBody(const Vec3& world) const { return rotation.transpose() * (world - translation); }
    Vec3 directionToWorld(const Vec3& body) const { return rotation * body; }
    Vec3 directionToBody(const Vec3& world) const { return rotation.transpose() * world; }
};

/// Distance of p from the segment from a to b, prolonged past either end.
inline double distanceToSegment(const Vec2& p, const Vec2& a, const Vec2& b, double past = 0.0) {
    const Vec2 d = b - a;
    const double share = past / std::max(d.norm(), 1e-6);
    const double t =
        std::clamp((p - a).dot(d) / std::max(d.squaredNorm(), 1e-12), -share, 1.0 + share);
    return (p - a - t * d).norm();
}

}  // namespace ew
