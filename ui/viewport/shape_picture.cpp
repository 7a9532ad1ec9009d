// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/shape_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ew {

namespace {

constexpr int kFiner = 2;           // samples a pixel, each way
constexpr double kMargin = 0.06;    // of the picture's sides
constexpr double kCreaseCos = 0.9;  // normals of neighbours further apart than this are an edge

/// What is seen at each sample.
struct Buffer {
    int width, height;
    std::vector<double> depth;  // infinity where nothing is
    std::vector<Vec3> normal;   // of the camera's space

    Buffer(int w, int h)
        : width(w),
          height(h),
          depth(static_cast<std::size_t>(w) * static_cast<std::size_t>(h),
                std::numeric_limits<double>::infinity()),
          normal(depth.size(), Vec3::Zero()) {}
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
};

struct Corner {
    Vec3 place;  // px, px, depth
    Vec3 normal;
};

void fillTriangle(Buffer& buffer, const std::array<Corner, 3>& corners) {
    const auto& [a, b, c] = corners;
    const Vec3 ab = b.place - a.place;
    const Vec3 ac = c.place - a.place;
    const double area = ab.x() * ac.y() - ab.y() * ac.x();
    if (area == 0.0 || !std::isfinite(area)) return;
    const auto [left, right] = std::minmax({a.place.x(), b.place.x(), c.place.x()});
    const auto [top, bottom] = std::minmax({a.place.y(), b.place.y(), c.place.y()});
    const int x1 = std::min(buffer.width - 1, static_cast<int>(right));
    const int y1 = std::min(buffer.height - 1, static_cast<int>(bottom));
    for (int y = std::max(0, static_cast<int>(top)); y <= y1; ++y) {
        for (int x = std::max(0, static_cast<int>(left)); x <= x1; ++x) {
            const double dx = x + 0.5 - a.place.x();
            const double dy = y + 0.5 - a.place.y();
            const double u = (dx * ac.y() - dy * ac.x()) / area;
            const double v = (dy * ab.x() - dx * ab.y()) / area;
            if (u < 0 || v < 0 || u + v > 1) continue;
            const double depth = a.place.z() + u * ab.z() + v * ac.z();
            const std::size_t at = buffer.at(x, y);
            if (depth >= buffer.depth[at]) continue;
            buffer.depth[at] = depth;
            buffer.normal[at] = a.normal + u * (b.normal - a.normal) + v * (c.normal - a.normal);
        }
    }
}

/// Meshes of all bodies, and a camera that fits them into the picture.
struct View {
    std::vector<ShapeMesh> meshes;
    OrthographicCamera camera;
};

View viewOf(const std::vector<Body>& bodies, const DerivedShape& shape,
            const OrthographicCamera& camera, QSize size) {
    View view{{}, camera};
    view.camera.width = size.width();
    view.camera.height = size.height();
    view.camera.center = Vec3::Zero();
    view.camera.worldPerPixel = 1.0;
    Eigen::AlignedBox2d box;
    for (std::size_t b = 0; b < bodies.size() && b < shape.bodies.size(); ++b) {
        if (bodies[b].hidden) continue;
        view.meshes.push_back(shapeMesh(bodies[b], shape.bodies[b]));
        for (const Vec3& p : view.meshes.back().positions) box.extend(view.camera.project(p));
    }
    if (box.isEmpty()) return view;
    view.camera.center = view.camera.unproject(box.center());
    const double room = 1.0 - 2 * kMargin;
    const double grow =
        std::max(box.sizes().x() / (room * size.width()), box.sizes().y() / (room * size.height()));
    if (grow > 0.0 && std::isfinite(grow)) view.camera.worldPerPixel = grow;
    return view;
}

void fillMesh(Buffer& buffer, const ShapeMesh& mesh, const OrthographicCamera& camera) {
    const Mat3 toCamera = camera.cameraToWorld().transpose();
    const auto& normals = mesh.normalTriangles.empty() ? mesh.triangles : mesh.normalTriangles;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        std::array<Corner, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& p = mesh.positions[static_cast<std::size_t>(mesh.triangles[t][k])];
            const Vec2 px = camera.project(p);
            corners[k].place = Vec3(px.x(), px.y(), camera.depthPx(p));
            if (!mesh.normals.empty()) {
                corners[k].normal =
                    toCamera * mesh.normals[static_cast<std::size_t>(normals[t][k])];
            }
        }
        if (mesh.normals.empty()) {
            // In camera space x goes right, y down and z away, so outward is towards the eye.
            const Vec3 flat = (corners[1].place - corners[0].place)
                                  .cross(corners[2].place - corners[0].place)
                                  .normalized();
            for (Corner& corner : corners) corner.normal = flat;
        }
        if (corners[0].normal.z() >= 0 && corners[1].normal.z() >= 0 && corners[2].normal.z() >= 0)
            continue;
        fillTriangle(buffer, corners);
    }
}

QRgb shaded(const Vec3& normal, const QColor& body) {
    // The viewport's main light, from the upper left in front; y points down here.
    const Vec3 light = Vec3(-0.4, -0.85, -0.9).normalized();
    const double k = 0.56 + 0.44 * std::max(0.0, normal.normalized().dot(light));
    return qRgb(static_cast<int>(body.red() * k), static_cast<int>(body.green() * k),
                static_cast<int>(body.blue() * k));
}

/// Does the shape end, or turn sharply, between two samples?
bool breaksOff(const Buffer& buffer, std::size_t a, std::size_t b) {
    const bool seen = std::isfinite(buffer.depth[a]);
    if (seen != std::isfinite(buffer.depth[b])) return true;
    return seen && buffer.normal[a].normalized().dot(buffer.normal[b].normalized()) < kCreaseCos;
}

}  // namespace

QImage shapePicture(const std::vector<Body>& bodies, const DerivedShape& shape,
                    const OrthographicCamera& camera, QSize logicalSize, double devicePixelRatio,
                    const ThemeColours& colours) {
    const QSize device = (QSizeF(logicalSize) * devicePixelRatio).toSize().expandedTo({1, 1});
    const QSize fine = device * kFiner;
    const View view = viewOf(bodies, shape, camera, fine);
    Buffer buffer(fine.width(), fine.height());
    for (const ShapeMesh& mesh : view.meshes) fillMesh(buffer, mesh, view.camera);
    QImage image(fine, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    for (int y = 0; y < buffer.height; ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < buffer.width; ++x) {
            const std::size_t at = buffer.at(x, y);
            const bool edge =
                (x + 1 < buffer.width && breaksOff(buffer, at, buffer.at(x + 1, y))) ||
                (y + 1 < buffer.height && breaksOff(buffer, at, buffer.at(x, y + 1)));
            if (edge)
                line[x] = colours.bodyEdge.rgb();
            else if (std::isfinite(buffer.depth[at]))
                line[x] = shaded(buffer.normal[at], colours.body);
        }
    }
    image = image.scaled(device, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    image.setDevicePixelRatio(devicePixelRatio);
    return image;
}

}  // namespace ew
