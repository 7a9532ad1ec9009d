// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/base/vec.h"

namespace ew {

/// Parallel projection of the world onto the Sketch Plane, as docs/sketch-script.md defines it:
/// the Sketch Plane passes through `center`, perpendicular to `direction`.
/// \paper{3.3}
struct OrthographicCamera {
    Vec3 direction = Vec3(-1, 1, -1).normalized();  ///< unit, from the eye into the scene
    Vec3 up = Vec3(0, 0, 1);                        ///< any vector not parallel to direction
    Vec3 center = Vec3::Zero();                     ///< [mm] seen at the viewport's middle
    double worldPerPixel = 0.25;                    ///< [mm/px], > 0
    double width = 1280;                            ///< viewport [px]
    double height = 800;                            ///< viewport [px]

    Vec3 right() const { return direction.cross(up).normalized(); }
    Vec3 trueUp() const { return right().cross(direction); }

    /// World point to Sketch Plane px (origin top left, y down).
    Vec2 project(const Vec3& world) const;

    /// Sketch Plane px and depth to the world. `depthPx` is the distance from the Sketch Plane
    /// along `direction`, in px (multiples of worldPerPixel).
    Vec3 unproject(const Vec2& px, double depthPx = 0.0) const;

    /// Distance of a world point behind the Sketch Plane [px], positive away from the eye.
    double depthPx(const Vec3& world) const {
        return (world - center).dot(direction) / worldPerPixel;
    }

    /// Columns right, down, direction: rotates camera-space vectors (px axes x right, y down,
    /// z into the scene; a right-handed frame) to the world.
    Mat3 cameraToWorld() const;

    /// Errc::BadValue where a number is not finite, direction or up is zero, the two are parallel,
    /// or worldPerPixel is not positive.
    Result<void> validate() const;

    bool operator==(const OrthographicCamera& o) const {
        return direction == o.direction && up == o.up && center == o.center &&
               worldPerPixel == o.worldPerPixel && width == o.width && height == o.height;
    }
};

}  // namespace ew
