// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/camera.h"

#include <cmath>

namespace ew {

Vec2 OrthographicCamera::project(const Vec3& world) const {
    const Vec3 r = right();
    const Vec3 u = r.cross(direction);
    const Vec3 d = (world - center) / worldPerPixel;
    return {width / 2 + d.dot(r), height / 2 - d.dot(u)};
}

Vec3 OrthographicCamera::unproject(const Vec2& px, double depth) const {
    const Vec3 r = right();
    const Vec3 u = r.cross(direction);
    return center + worldPerPixel *
                        ((px.x() - width / 2) * r - (px.y() - height / 2) * u + depth * direction);
}

Mat3 OrthographicCamera::cameraToWorld() const {
    Mat3 m;
    m.col(0) = right();
    m.col(1) = -trueUp();
    m.col(2) = direction;
    return m;
}

Result<void> OrthographicCamera::validate() const {
    if (!direction.allFinite() || !up.allFinite() || !center.allFinite() ||
        !std::isfinite(worldPerPixel) || !std::isfinite(width) || !std::isfinite(height)) {
        return fail(Errc::BadValue, "A camera needs finite numbers.");
    }
    if (std::abs(direction.norm() - 1.0) > 1e-6) {
        return fail(Errc::BadValue, "The camera's direction is not a unit vector.");
    }
    if (up.norm() < 1e-12 || direction.cross(up.normalized()).norm() < 1e-6) {
        return fail(Errc::BadValue, "The camera's up vector is parallel to its direction.");
    }
    if (!(worldPerPixel > 0) || worldPerPixel > 1e9 || worldPerPixel < 1e-9) {
        return fail(Errc::BadValue, "The camera's world_per_pixel must be positive.");
    }
    if (!(width >= 1) || !(height >= 1)) {
        return fail(Errc::BadValue, "The viewport must be at least one pixel wide and high.");
    }
    return {};
}

}  // namespace ew
