// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QTransform>
#include <optional>

#include "core/base/camera.h"
#include "core/stroke/stroke.h"

namespace ew {

// Ink belongs to the Sketch Plane of the camera that it was drawn through. Seen through another
// parallel camera, that plane's px map affinely.

/// Sketch Plane px of `sketch` to px of `view`.
QTransform sketchToView(const OrthographicCamera& sketch, const OrthographicCamera& view);

/// The other way: px of `view` onto the Sketch Plane of `sketch`. Nothing where that plane is seen
/// so much from the side (under 15 degrees) that drawing on it would be guesswork.
std::optional<QTransform> viewToSketch(const OrthographicCamera& view,
                                       const OrthographicCamera& sketch);

inline QPointF toPoint(const Vec2& v) { return {v.x(), v.y()}; }
inline Vec2 toVec(const QPointF& p) { return {p.x(), p.y()}; }

/// Side of a square of the area that a square px has after the map.
double meanScale(const QTransform& map);

Stroke mapStroke(const Stroke& stroke, const QTransform& map);

}  // namespace ew
