// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/solid_picture.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <limits>
#include <vector>

#include "ui/viewport/camera_moves.h"
#include "ui/viewport/sketch_plane.h"
#include "ui/viewport/wireframe.h"

namespace ew {

namespace {

constexpr double kMarginPx = 7.0;

QPolygonF polygonOf(const SeenFace& face, double scale) {
    QPolygonF polygon;
    for (const Vec2& p : face.outline) polygon.append(toPoint(p) * scale);
    return polygon;
}

QRgb shade(const Vec3& normalInCamera, const ThemeColours& colours) {
    // The viewport's main light, from the upper left in front; y points down here.
    const Vec3 light = Vec3(-0.4, -0.85, -0.9).normalized();
    const double lit = std::max(0.0, normalInCamera.dot(light));
    const double k = 0.56 + 0.44 * lit;
    const QColor c = colours.body;
    return qRgb(static_cast<int>(c.red() * k), static_cast<int>(c.green() * k),
                static_cast<int>(c.blue() * k));
}

/// Nearest face wins, pixel by pixel: right for any shape, and small pictures are cheap.
QImage fillFaces(const std::vector<SeenFace>& faces, const OrthographicCamera& camera, QSize device,
                 double scale, const ThemeColours& colours) {
    QImage out(device, QImage::Format_ARGB32_Premultiplied);
    out.fill(Qt::transparent);
    std::vector<double> nearest(
        static_cast<std::size_t>(device.width()) * static_cast<std::size_t>(device.height()),
        std::numeric_limits<double>::infinity());
    const Mat3 toCamera = camera.cameraToWorld().transpose();
    QImage mask(device, QImage::Format_Grayscale8);
    for (const SeenFace& face : faces) {
        const QPolygonF polygon = polygonOf(face, scale);
        const QRect box = polygon.boundingRect().toAlignedRect().intersected(mask.rect());
        if (box.isEmpty()) continue;
        mask.fill(0);
        QPainter painter(&mask);
        painter.setPen(Qt::NoPen);
        painter.setBrush(Qt::white);
        painter.drawPolygon(polygon);
        painter.end();
        const QRgb colour = shade(toCamera * face.normal, colours);
        for (int y = box.top(); y <= box.bottom(); ++y) {
            const uchar* in = mask.constScanLine(y);
            auto* line = reinterpret_cast<QRgb*>(out.scanLine(y));
            for (int x = box.left(); x <= box.right(); ++x) {
                if (in[x] < 128) continue;
                const double depth = face.depth.x() * (x + 0.5) / scale +
                                     face.depth.y() * (y + 0.5) / scale + face.depth.z();
                double& best =
                    nearest[static_cast<std::size_t>(y) * static_cast<std::size_t>(device.width()) +
                            static_cast<std::size_t>(x)];
                if (depth >= best) continue;
                best = depth;
                line[x] = colour;
            }
        }
    }
    return out;
}

OrthographicCamera fitted(const PolyhedronSpec& spec, const Pose& pose,
                          const OrthographicCamera& camera, QSize size) {
    OrthographicCamera c = resizeCamera(camera, size.width(), size.height());
    Eigen::AlignedBox2d box;
    Vec3 middle = Vec3::Zero();
    for (const Vec3& v : spec.vertices) {
        box.extend(c.project(pose.toWorld(v)));
        middle += pose.toWorld(v) / static_cast<double>(spec.vertices.size());
    }
    if (box.isEmpty()) return c;
    c.center = c.unproject(box.center(), c.depthPx(middle));
    const double grow = std::max(box.sizes().x() / std::max(1.0, c.width - 2 * kMarginPx),
                                 box.sizes().y() / std::max(1.0, c.height - 2 * kMarginPx));
    if (grow > 0.0 && std::isfinite(grow)) c.worldPerPixel *= grow;
    return c;
}

}  // namespace

QImage solidPicture(const PolyhedronSpec& spec, const Pose& pose, const OrthographicCamera& camera,
                    QSize logicalSize, double devicePixelRatio, const ThemeColours& colours) {
    return solidView(spec, pose, fitted(spec, pose, camera, logicalSize), devicePixelRatio,
                     colours);
}

QImage solidView(const PolyhedronSpec& spec, const Pose& pose, const OrthographicCamera& view,
                 double devicePixelRatio, const ThemeColours& colours) {
    const QSize device =
        (QSizeF(view.width, view.height) * devicePixelRatio).toSize().expandedTo({1, 1});
    QImage image = fillFaces(seenFaces(spec, pose, view), view, device, devicePixelRatio, colours);
    image.setDevicePixelRatio(devicePixelRatio);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    QPen seen(colours.bodyEdge, 1.3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    QPen hidden(colours.hiddenEdge, 1.0);
    hidden.setDashPattern({3.0, 3.0});
    const std::vector<WireSegment> segments = wireSegments(spec, pose, view);
    for (const bool pass : {true, false}) {
        painter.setPen(pass ? hidden : seen);
        for (const WireSegment& s : segments) {
            if (s.hidden == pass) painter.drawLine(toPoint(s.ends[0]), toPoint(s.ends[1]));
        }
    }
    return image;
}

}  // namespace ew
