// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/mirror_overlay.h"

#include <Eigen/Geometry>
#include <QPainter>
#include <algorithm>
#include <array>

namespace ew {

namespace {

constexpr double kMargin = 0.15;      // beyond the bodies, of their size
constexpr double kShareOfView = 0.3;  // where there are none
constexpr double kWidthPx = 1.25;

}  // namespace

std::array<Vec3, 4> mirrorOutline(const MirrorPlane& plane, const std::vector<Body>& bodies,
                                  const OrthographicCamera& view) {
    // One side of the outline is level, unless the plane itself is.
    const bool flat = std::abs(plane.normal.z()) > 0.999;
    const Vec3 u =
        flat ? plane.normal.unitOrthogonal() : Vec3(Vec3::UnitZ().cross(plane.normal).normalized());
    const Vec3 v = plane.normal.cross(u);
    Eigen::AlignedBox2d box;
    const auto add = [&](const Vec3& p) {
        box.extend(Vec2(u.dot(p - plane.point), v.dot(p - plane.point)));
    };
    for (const Body& body : bodies) {
        if (body.hidden) continue;
        for (const Vec3& p : body.solid.vertices()) add(body.pose.toWorld(p));
    }
    double margin = 0.0;
    if (box.isEmpty()) {
        add(view.center);
        margin = kShareOfView * view.worldPerPixel * std::min(view.width, view.height);
    } else {
        margin = kMargin * box.diagonal().norm();
    }
    const Vec2 low = box.min() - Vec2::Constant(margin);
    const Vec2 high = box.max() + Vec2::Constant(margin);
    const auto at = [&](double x, double y) { return Vec3(plane.point + x * u + y * v); };
    return {at(low.x(), low.y()), at(high.x(), low.y()), at(high.x(), high.y()),
            at(low.x(), high.y())};
}

void paintMirror(QPainter& painter, const MirrorPlane& plane, const std::vector<Body>& bodies,
                 const OrthographicCamera& view, const ThemeColours& colours) {
    QPolygonF outline;
    for (const Vec3& p : mirrorOutline(plane, bodies, view)) {
        const Vec2 px = view.project(p);
        outline << QPointF(px.x(), px.y());
    }
    QPen pen(colours.accent, kWidthPx);
    pen.setDashPattern({6.0, 3.0, 1.0, 3.0});  // the centre line of technical drawings
    pen.setCosmetic(true);
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(outline);
}

}  // namespace ew
