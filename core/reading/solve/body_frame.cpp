// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/body_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/tolerance.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Depth of the seen vertex nearest to the eye [px]: it goes onto the Sketch Plane.
double nearestDepth(const Sighting& s, const CameraPoints& points) {
    double z = std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < points.size(); ++v) {
        if (s.seen[v]) z = std::min(z, points[v].z());
    }
    return z;
}

Pose poseOf(const Mat3& cameraFrame, const Vec3& originPx, double nearest,
            const OrthographicCamera& camera) {
    Pose pose;
    pose.rotation = camera.cameraToWorld() * cameraFrame;
    pose.translation = camera.unproject(originPx.head<2>(), originPx.z() - nearest);
    return pose;
}

/// A mirror image of the template has its faces inside out.
void orientOutward(PolyhedronSpec& spec) {
    if (signedVolume(spec) >= 0) return;
    for (auto& loop : spec.faces) std::reverse(loop.begin(), loop.end());
}

/// Makes coordinates along one axis equal that differ by rounding only.
void uniteCoordinates(std::vector<Vec3>& points, int axis, double tolerance) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return points[a](axis) < points[b](axis); });
    for (std::size_t i = 0; i < order.size();) {
        std::size_t j = i;
        double sum = 0;
        while (j < order.size() && points[order[j]](axis) - points[order[i]](axis) <= tolerance) {
            sum += points[order[j]](axis);
            ++j;
        }
        double mean = sum / static_cast<double>(j - i);
        if (std::abs(mean) <= tolerance) mean = 0.0;
        for (std::size_t k = i; k < j; ++k) points[order[k]](axis) = mean;
        i = j;
    }
}

}  // namespace

double signedVolume(const PolyhedronSpec& spec) {
    double v = 0;
    for (const auto& loop : spec.faces) {
        for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
            v += spec.vertices[at(loop[0])].dot(
                spec.vertices[at(loop[i])].cross(spec.vertices[at(loop[i + 1])]));
        }
    }
    return v / 6;
}

PlacedBody placeRectilinear(const Template& tmpl, const RectilinearStructure& r,
                            const AffinePicture& picture, const std::array<Vec3, 3>& axes,
                            const Sighting& sighting, const OrthographicCamera& camera) {
    Mat3 frame;
    std::array<double, 3> sign{1, 1, 1};
    for (std::size_t a = 0; a < 3; ++a)
        frame.col(static_cast<Eigen::Index>(a)) = axes[a].normalized();
    if (frame.determinant() < 0) {
        // The body frame is right-handed; a left-handed drawing counts its first axis backwards.
        frame.col(0) = -frame.col(0);
        sign[0] = -1;
    }
    std::array<std::vector<double>, 3> coordinate;
    Vec3 origin(picture.origin.x(), picture.origin.y(), 0);
    for (std::size_t a = 0; a < 3; ++a) {
        const double length = axes[a].norm() * camera.worldPerPixel;
        double least = std::numeric_limits<double>::infinity();
        for (const double p : picture.position[a]) {
            coordinate[a].push_back(sign[a] * p * length);
            least = std::min(least, coordinate[a].back());
        }
        for (double& c : coordinate[a]) c -= least;
        origin += frame.col(static_cast<Eigen::Index>(a)) * (least / camera.worldPerPixel);
    }
    PlacedBody body;
    body.spec.faces = tmpl.shape.faces;
    CameraPoints seen;
    for (std::size_t v = 0; v < tmpl.shape.vertices.size(); ++v) {
        body.spec.vertices.emplace_back(coordinate[0][at(r.planes[0][v])],
                                        coordinate[1][at(r.planes[1][v])],
                                        coordinate[2][at(r.planes[2][v])]);
        seen.push_back(origin + frame * body.spec.vertices.back() / camera.worldPerPixel);
    }
    orientOutward(body.spec);
    body.pose = poseOf(frame, origin, nearestDepth(sighting, seen), camera);
    return body;
}

PlacedBody placeGeneral(const Template& tmpl, const CameraPoints& points, const Sighting& sighting,
                        const OrthographicCamera& camera) {
    PlacedBody body;
    body.spec.faces = tmpl.shape.faces;
    body.spec.vertices = points;
    orientOutward(body.spec);
    const auto& base = body.spec.faces.front();
    Vec3 normal = Vec3::Zero();
    const Vec3 o = points[at(base[0])];
    for (std::size_t i = 1; i + 1 < base.size(); ++i) {
        normal += (points[at(base[i])] - o).cross(points[at(base[i + 1])] - o);
    }
    Mat3 frame;
    frame.col(0) = (points[at(base[1])] - o).normalized();
    // The first face looks down: the body stands on it.
    frame.col(2) = -normal.normalized();
    frame.col(2) = (frame.col(2) - frame.col(0) * frame.col(0).dot(frame.col(2))).normalized();
    frame.col(1) = frame.col(2).cross(frame.col(0));
    double size = 0;
    for (Vec3& p : body.spec.vertices) {
        p = frame.transpose() * (p - o) * camera.worldPerPixel;
        size = std::max(size, p.norm());
    }
    for (int axis = 0; axis < 3; ++axis) {
        uniteCoordinates(body.spec.vertices, axis, tol::kEqualCoordinate * size);
    }
    body.pose = poseOf(frame, o, nearestDepth(sighting, points), camera);
    return body;
}

}  // namespace ew
