// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "core/surface/box_tree.h"
#include "core/surface/subdivision.h"

namespace ew::test {

/// Distance of a point from a triangle.
inline double distanceTo(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 n = (b - a).cross(c - a).normalized();
    const Vec3 q = p - n * n.dot(p - a);
    const auto inside = [&](const Vec3& s, const Vec3& t) {
        return (t - s).cross(q - s).dot(n) >= 0;
    };
    if (inside(a, b) && inside(b, c) && inside(c, a)) return std::abs(n.dot(p - a));
    const auto segment = [&](const Vec3& s, const Vec3& t) {
        const double length = (t - s).squaredNorm();
        const double k = length > 0.0 ? std::clamp((p - s).dot(t - s) / length, 0.0, 1.0) : 0.0;
        return (p - s - k * (t - s)).norm();
    };
    return std::min({segment(a, b), segment(b, c), segment(c, a)});
}

/// Largest distance from points of the limit surface to the triangles: what SubdivisionOptions
/// calls the tolerance, measured instead of judged.
/// \param reach  about what is expected [mm].
inline double deviation(std::span<const Vec3> points, const SurfaceMesh& surface, double reach) {
    const auto corner = [&](std::size_t t, std::size_t k) -> const Vec3& {
        return surface.positions[static_cast<std::size_t>(surface.triangles[t][k])];
    };
    std::vector<Box3> boxes(surface.triangles.size());
    for (std::size_t t = 0; t < boxes.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) boxes[t].extend(corner(t, k));
    }
    const BoxTree tree(std::move(boxes));
    double worst = 0.0;
    for (const Vec3& p : points) {
        double best = std::numeric_limits<double>::infinity();
        // What is outside the box may be nearer than what was found in it, but not than its sides.
        double searched = 0.0;
        for (double r = reach; best > searched && std::isfinite(r); r *= 4.0) {
            searched = r;
            const Vec3 around = Vec3::Constant(r);
            tree.overlapping(Box3(p - around, p + around), [&](int item) {
                const auto t = static_cast<std::size_t>(item);
                best = std::min(best, distanceTo(p, corner(t, 0), corner(t, 1), corner(t, 2)));
            });
        }
        worst = std::max(worst, best);
    }
    return worst;
}

}  // namespace ew::test
