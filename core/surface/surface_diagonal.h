// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/tolerance.h"
#include "core/base/vec.h"

namespace ew {

/// Is a triangle higher over its longest side than `least`, and than rounding makes it? [mm]
inline bool hasArea(const Vec3& a, const Vec3& b, const Vec3& c, double least) {
    const double longest =
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    const double area = (b - a).cross(c - a).norm();
    return area > tol::kNoAreaRatio * longest && area > least * std::sqrt(longest);
}

/// The largest coordinate of points, without its sign [mm].
inline double farthestCoordinate(const std::vector<Vec3>& points) {
    double farthest = 0.0;
    for (const Vec3& p : points) farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
    return farthest;
}

/// Heights below this are lost in single precision, in which surfaces are exported [mm].
/// \param farthest  largest coordinate [mm]; in the world it may be somewhat larger.
inline double leastHeight(double farthest) { return 3.0 * tol::kSingleStep * farthest; }

/// A point of a surface.
struct SurfacePoint {
    Vec3 position;
    Vec3 normal;  ///< unit
};

/// Which of two diagonals of a cell is nearer to the surface: the one along which it turns less,
/// the shorter one where they do alike.
inline bool turnsLess(const SurfacePoint& a0, const SurfacePoint& a1, const SurfacePoint& b0,
                      const SurfacePoint& b1) {
    constexpr double kSameTurn = 0.1;  // share of the larger turn
    constexpr double kNoTurn = 1e-6;   // [rad]
    const Vec3 a = a1.position - a0.position;
    const Vec3 b = b1.position - b0.position;
    const double turnA = std::abs(a.dot(a1.normal - a0.normal));
    const double turnB = std::abs(b.dot(b1.normal - b0.normal));
    const double lengthA = a.squaredNorm();
    const double lengthB = b.squaredNorm();
    const double most = std::max(turnA, turnB);
    const bool flat = most * most <= kNoTurn * kNoTurn * std::min(lengthA, lengthB);
    if (!flat && std::abs(turnA - turnB) > kSameTurn * most) return turnA < turnB;
    return lengthA <= lengthB;
}

}  // namespace ew
