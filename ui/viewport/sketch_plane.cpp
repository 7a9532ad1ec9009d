// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/sketch_plane.h"

#include <cmath>

namespace ew {

namespace {
// sin(15 degrees): flatter than this the plane is as good as a line.
constexpr double kFlattest = 0.2588;
}  // namespace

QTransform sketchToView(const OrthographicCamera& sketch, const OrthographicCamera& view) {
    if (sketch == view) return {};
    const Vec2 origin = view.project(sketch.unproject({0, 0}));
    const Vec2 x = view.project(sketch.unproject({1, 0})) - origin;
    const Vec2 y = view.project(sketch.unproject({0, 1})) - origin;
    return {x.x(), x.y(), y.x(), y.y(), origin.x(), origin.y()};
}

std::optional<QTransform> viewToSketch(const OrthographicCamera& view,
                                       const OrthographicCamera& sketch) {
    if (sketch == view) return QTransform();
    if (std::abs(sketch.direction.dot(view.direction)) < kFlattest) return std::nullopt;
    bool invertible = false;
    const QTransform back = sketchToView(sketch, view).inverted(&invertible);
    if (!invertible) return std::nullopt;
    return back;
}

double meanScale(const QTransform& map) { return std::sqrt(std::abs(map.determinant())); }

Stroke mapStroke(const Stroke& stroke, const QTransform& map) {
    Stroke out = stroke;
    if (map.isIdentity()) return out;
    for (PenSample& s : out.samples) s.position = toVec(map.map(toPoint(s.position)));
    return out;
}

}  // namespace ew
