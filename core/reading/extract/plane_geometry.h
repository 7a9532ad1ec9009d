// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/base/vec.h"

namespace ew {

/// The angle between two directions [degrees], 0..180.
inline double angleBetweenDeg(const Vec2& a, const Vec2& b) {
    return std::abs(std::atan2(cross2(a, b), a.dot(b))) * 180.0 / std::numbers::pi;
}

/// Is a point inside a simple polygon, whichever way that runs? Points on its border may be either.
inline bool insidePolygon(const std::vector<Vec2>& polygon, const Vec2& p) {
    bool inside = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Vec2& a = polygon[i];
        const Vec2& b = polygon[j];
        if ((a.y() > p.y()) == (b.y() > p.y())) continue;
        if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
    }
    return inside;
}

/// Area of a simple polygon, > 0 where it runs from x to y [px^2].
inline double areaOf(const std::vector<Vec2>& polygon) {
    double twice = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        twice += cross2(polygon[i], polygon[(i + 1) % polygon.size()]);
    }
    return 0.5 * twice;
}

/// Twice the area of a plane loop, as a vector across it that sees the loop run counter-clockwise.
inline Vec3 doubleArea(const std::vector<Vec3>& points, const std::vector<int>& loop) {
    const auto from = [&](std::size_t k) -> Vec3 {
        return points[static_cast<std::size_t>(loop[k])] -
               points[static_cast<std::size_t>(loop[0])];
    };
    Vec3 area = Vec3::Zero();
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) area += from(k).cross(from(k + 1));
    return area;
}

}  // namespace ew
