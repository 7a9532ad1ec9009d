// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/level.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/document/body_list.h"

namespace ew {
namespace {

constexpr double kRadian = std::numbers::pi / 180.0;

/// A direction, and how much of the solid says so.
struct Weighted {
    Vec3 direction;  ///< unit, world
    double weight = 0.0;
};

std::vector<Weighted> faceNormals(const PolyhedronSpec& spec, const Mat3& rotation) {
    std::vector<Weighted> out;
    for (const auto& loop : spec.faces) {
        Vec3 area = Vec3::Zero();
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Vec3& a = spec.vertices[static_cast<std::size_t>(loop[k])];
            const Vec3& b = spec.vertices[static_cast<std::size_t>(loop[(k + 1) % loop.size()])];
            area += a.cross(b);
        }
        if (area.norm() > 0.0) out.push_back({rotation * area.normalized(), area.norm()});
    }
    return out;
}

std::vector<Weighted> edgeDirections(const PolyhedronSpec& spec, const Mat3& rotation) {
    std::vector<Weighted> out;
    for (const auto& loop : spec.faces) {
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Vec3 d = spec.vertices[static_cast<std::size_t>(loop[(k + 1) % loop.size()])] -
                           spec.vertices[static_cast<std::size_t>(loop[k])];
            if (d.norm() > 0.0) out.push_back({rotation * d.normalized(), d.norm()});
        }
    }
    return out;
}

/// The weightiest direction within the angle of the vertical, pointing up.
std::optional<Vec3> nearVertical(const std::vector<Weighted>& all, double angleDeg) {
    const double least = std::cos(angleDeg * kRadian);
    const Weighted* best = nullptr;
    for (const Weighted& w : all) {
        if (std::abs(w.direction.z()) < least) continue;
        if (best == nullptr || w.weight > best->weight) best = &w;
    }
    if (best == nullptr) return std::nullopt;
    return best->direction.z() < 0.0 ? Vec3(-best->direction) : best->direction;
}

std::optional<Mat3> upright(const PolyhedronSpec& spec, const Mat3& rotation, double angleDeg) {
    auto up = nearVertical(faceNormals(spec, rotation), angleDeg);
    if (!up) up = nearVertical(edgeDirections(spec, rotation), angleDeg);
    if (!up) return std::nullopt;
    return Eigen::Quaterniond::FromTwoVectors(*up, Vec3::UnitZ()).toRotationMatrix();
}

Eigen::AlignedBox3d boundsOf(const PolyhedronSpec& spec, const Pose& pose) {
    Eigen::AlignedBox3d box;
    for (const Vec3& v : spec.vertices) box.extend(pose.toWorld(v));
    return box;
}

Eigen::AlignedBox3d boundsOf(const Body& body) {
    const auto [low, high] = worldBounds(body);
    return {low, high};
}

/// Angles of the upright faces' normals round the vertical, modulo a right angle [rad].
std::vector<double> headings(const std::vector<Weighted>& normals) {
    std::vector<double> out;
    for (const Weighted& w : normals) {
        if (std::abs(w.direction.z()) > 1e-6) continue;
        out.push_back(std::atan2(w.direction.y(), w.direction.x()));
    }
    return out;
}

double toQuarter(double angle) {
    constexpr double kQuarter = 0.5 * std::numbers::pi;
    return angle - kQuarter * std::round(angle / kQuarter);
}

/// The least turn round the vertical that makes some upright face parallel to one of the others'.
Mat3 headed(const PolyhedronSpec& spec, const Mat3& rotation, const std::vector<Body>& others,
            double angleDeg) {
    const std::vector<double> mine = headings(faceNormals(spec, rotation));
    double least = angleDeg * kRadian;
    double turn = 0.0;
    for (const Body& other : others) {
        for (const SolidFace& face : other.solid.faces()) {
            const Vec3 normal = other.pose.rotation * face.normal;
            if (std::abs(normal.z()) > 1e-6) continue;
            const double theirs = std::atan2(normal.y(), normal.x());
            for (const double angle : mine) {
                const double by = toQuarter(theirs - angle);
                if (std::abs(by) >= least) continue;
                least = std::abs(by);
                turn = by;
            }
        }
    }
    return Eigen::AngleAxisd(turn, Vec3::UnitZ()).toRotationMatrix();
}

/// How far the picture moves at most [px].
double pictureMoves(const PolyhedronSpec& spec, const Pose& from, const Pose& to,
                    const OrthographicCamera& camera) {
    double most = 0.0;
    for (const Vec3& v : spec.vertices) {
        const Vec2 off = camera.project(to.toWorld(v)) - camera.project(from.toWorld(v));
        most = std::max(most, off.norm());
    }
    return most;
}

/// A turn about the middle of the solid.
Motion turnedInPlace(const PolyhedronSpec& spec, const Pose& pose, const Mat3& turn) {
    const Vec3 middle = boundsOf(spec, pose).center();
    return {turn, middle - turn * middle};
}

}  // namespace

Pose Motion::operator()(const Pose& pose) const {
    return {turn * pose.rotation, turn * pose.translation + shift};
}

OrthographicCamera Motion::operator()(const OrthographicCamera& camera) const {
    OrthographicCamera out = camera;
    out.direction = (turn * camera.direction).normalized();
    out.up = turn * camera.up;
    out.center = turn * camera.center + shift;
    return out;
}

std::optional<Motion> levelled(const PolyhedronSpec& spec, const Pose& pose, double angleDeg) {
    const auto turn = upright(spec, pose.rotation, angleDeg);
    if (!turn) return std::nullopt;
    Motion motion = turnedInPlace(spec, pose, *turn);
    motion.shift.z() -= boundsOf(spec, motion(pose)).min().z();
    return motion;
}

std::optional<Motion> setBeside(const PolyhedronSpec& spec, const Pose& pose,
                                const std::vector<Body>& others, const OrthographicCamera& camera,
                                const Thresholds& thresholds) {
    std::optional<Motion> motion;
    if (const auto up = upright(spec, pose.rotation, thresholds.angleDeg)) {
        const Mat3 head = headed(spec, *up * pose.rotation, others, thresholds.angleDeg);
        for (const Mat3& turn : {Mat3(head * *up), *up}) {
            const Motion turned = turnedInPlace(spec, pose, turn);
            if (pictureMoves(spec, pose, turned(pose), camera) > thresholds.distancePx) continue;
            motion = turned;
            break;
        }
    }
    constexpr double kFlattest = 0.1;  // sight so level reaches the ground far away
    const Vec3& sight = camera.direction;
    if (motion && std::abs(sight.z()) > kFlattest) {
        double ground = std::numeric_limits<double>::infinity();
        for (const Body& other : others) ground = std::min(ground, boundsOf(other).min().z());
        const double drop = ground - boundsOf(spec, (*motion)(pose)).min().z();
        Motion stands = *motion;
        stands.shift += sight * (drop / sight.z());
        const Eigen::AlignedBox3d box = boundsOf(spec, stands(pose));
        const bool clear = std::none_of(others.begin(), others.end(), [&](const Body& other) {
            const Eigen::AlignedBox3d common = box.intersection(boundsOf(other));
            return !common.isEmpty() && common.sizes().minCoeff() > 0.0;
        });
        if (clear) {
            motion = stands;
            // The difference of two large heights is not quite the ground's.
            motion->shift.z() += ground - boundsOf(spec, stands(pose)).min().z();
        }
    }
    return motion;
}

}  // namespace ew
