// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/vec.h"

namespace ew {

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
