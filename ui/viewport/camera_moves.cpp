// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/camera_moves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ew {

namespace {

constexpr double kRadiansPerPixel = std::numbers::pi / 360.0;  // half a degree
constexpr double kMinScale = 1e-6;                             // [mm/px]
constexpr double kMaxScale = 1e6;
constexpr double kFitShare = 0.62;  // of the viewport, so that there is room to draw round it

}  // namespace

namespace {

/// A camera that leans to one side, as one that a solid was turned level with, comes upright while
/// it is turned: the lean fades over this way [px].
constexpr double kRollFadesPx = 120.0;

Vec3 lessRolled(const Vec3& up, const Vec3& direction, double movedPx) {
    const Vec3 z(0, 0, 1);
    const Vec3 level = z - z.dot(direction) * direction;
    // Straight down or up there is no upright.
    if (level.norm() < 0.05) return up;
    const Vec3 upright = level.normalized();
    const double roll = std::atan2(upright.cross(up).dot(direction), upright.dot(up));
    constexpr double kNone = 1e-6;
    constexpr double kMost = 0.5 * std::numbers::pi;
    if (std::abs(roll) < kNone || std::abs(roll) > kMost) return up;
    const double left = std::clamp(1.0 - movedPx / kRollFadesPx, 0.0, 1.0);
    return Eigen::AngleAxisd(roll * left, direction) * upright;
}

}  // namespace

OrthographicCamera orbitCamera(const OrthographicCamera& camera, const Vec2& deltaPx,
                               const Vec3& pivot) {
    const Vec3 z(0, 0, 1);
    const Eigen::AngleAxisd turn(-deltaPx.x() * kRadiansPerPixel, z);
    Vec3 right = turn * camera.right();
    Vec3 up = turn * camera.trueUp();
    Vec3 direction = turn * camera.direction;
    // Tipping over the pole would turn the world upside down: stop where up is horizontal.
    const double rise = std::atan2(up.z(), -direction.z());  // 0 looking down, pi looking up
    const double wanted = rise - deltaPx.y() * kRadiansPerPixel;
    const double tip = std::clamp(wanted, 0.0, std::numbers::pi) - rise;
    const Eigen::AngleAxisd tilt(tip, right);
    up = (tilt * up).normalized();
    direction = (tilt * direction).normalized();
    up = lessRolled(up, direction, deltaPx.norm());
    const Mat3 before = camera.cameraToWorld();
    OrthographicCamera out = camera;
    out.direction = direction;
    out.up = up;
    const Vec3 inCamera = before.transpose() * (pivot - camera.center);
    out.center = pivot - out.cameraToWorld() * inCamera;
    return out;
}

OrthographicCamera panCamera(const OrthographicCamera& camera, const Vec2& deltaPx) {
    OrthographicCamera out = camera;
    out.center +=
        camera.worldPerPixel * (-deltaPx.x() * camera.right() + deltaPx.y() * camera.trueUp());
    return out;
}

OrthographicCamera zoomCamera(const OrthographicCamera& camera, const Vec2& px, double factor) {
    if (!(factor > 0.0)) return camera;
    OrthographicCamera out = camera;
    out.worldPerPixel = std::clamp(camera.worldPerPixel / factor, kMinScale, kMaxScale);
    out.center += camera.unproject(px) - out.unproject(px);
    return out;
}

OrthographicCamera standardView(const OrthographicCamera& camera, StandardView view) {
    OrthographicCamera out = camera;
    out.up = Vec3(0, 0, 1);
    switch (view) {
        case StandardView::Home:
            out.direction = OrthographicCamera().direction;
            break;
        case StandardView::Front:
            out.direction = Vec3(0, 1, 0);
            break;
        case StandardView::Back:
            out.direction = Vec3(0, -1, 0);
            break;
        case StandardView::Left:
            out.direction = Vec3(1, 0, 0);
            break;
        case StandardView::Right:
            out.direction = Vec3(-1, 0, 0);
            break;
        case StandardView::Top:
            out.direction = Vec3(0, 0, -1);
            out.up = Vec3(0, 1, 0);
            break;
        case StandardView::Bottom:
            out.direction = Vec3(0, 0, 1);
            out.up = Vec3(0, -1, 0);
            break;
    }
    return out;
}

OrthographicCamera fitCamera(const OrthographicCamera& camera, const std::vector<Vec3>& points) {
    if (points.empty()) return camera;
    Eigen::AlignedBox2d box;
    double nearest = 0.0;
    double farthest = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        box.extend(camera.project(points[i]));
        const double depth = camera.depthPx(points[i]);
        nearest = i == 0 ? depth : std::min(nearest, depth);
        farthest = i == 0 ? depth : std::max(farthest, depth);
    }
    OrthographicCamera out = camera;
    out.center = camera.unproject(box.center(), (nearest + farthest) / 2);
    const double grow = std::max(box.sizes().x() / (camera.width * kFitShare),
                                 box.sizes().y() / (camera.height * kFitShare));
    if (grow > 0.0) {
        out.worldPerPixel = std::clamp(camera.worldPerPixel * grow, kMinScale, kMaxScale);
    }
    return out;
}

OrthographicCamera resizeCamera(const OrthographicCamera& camera, double width, double height) {
    OrthographicCamera out = camera;
    out.width = std::max(1.0, width);
    out.height = std::max(1.0, height);
    return out;
}

OrthographicCamera scaleCamera(const OrthographicCamera& camera, double width, double height) {
    OrthographicCamera out = resizeCamera(camera, width, height);
    out.worldPerPixel *= std::max(camera.width / out.width, camera.height / out.height);
    return out;
}

std::vector<Vec3> bodyPoints(const std::vector<Body>& bodies) {
    std::vector<Vec3> points;
    for (const Body& body : bodies) {
        if (body.hidden) continue;
        for (const Vec3& v : body.solid.vertices()) points.push_back(body.pose.toWorld(v));
    }
    return points;
}

}  // namespace ew
