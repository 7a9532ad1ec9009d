// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/mirror.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/tolerance.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr double kFarthest = 1e12;  // [mm], as cameras

/// Makes a unit vector that is along an axis but for rounding so to the bit.
void snapToAxis(Vec3& unit, double off) {
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(unit[axis]) <= 1.0 - off) continue;
        unit = Vec3::Unit(axis) * (unit[axis] > 0.0 ? 1.0 : -1.0);
    }
}

/// The one neighbour of each corner of a face that is no corner of it.
std::optional<std::vector<int>> waysOut(const PolyhedronSpec& spec, const std::vector<int>& loop) {
    const std::set<int> own(loop.begin(), loop.end());
    std::vector<int> out(loop.size(), -1);
    for (const auto& face : spec.faces) {
        const std::size_t n = face.size();
        for (std::size_t k = 0; k < n; ++k) {
            const int a = face[k];
            const int b = face[(k + 1) % n];
            for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
                if (!own.contains(from) || own.contains(to)) continue;
                for (std::size_t c = 0; c < loop.size(); ++c) {
                    if (loop[c] != from || out[c] == to) continue;
                    if (out[c] >= 0) return std::nullopt;
                    out[c] = to;
                }
            }
        }
    }
    const bool all = std::all_of(out.begin(), out.end(), [](int v) { return v >= 0; });
    if (!all) return std::nullopt;
    return out;
}

}  // namespace

Result<MirrorPlane> mirrorPlane(const Vec3& point, const Vec3& normal) {
    const bool usable = point.allFinite() && normal.allFinite() &&
                        point.cwiseAbs().maxCoeff() <= kFarthest &&
                        normal.cwiseAbs().maxCoeff() > tol::kShortestDirection &&
                        normal.cwiseAbs().maxCoeff() < 1.0 / tol::kShortestDirection;
    if (!usable) return fail(Errc::BadValue, "The mirror plane has no direction.");
    MirrorPlane plane{point, normal.normalized()};
    snapToAxis(plane.normal, 1e-15);
    return plane;
}

MirrorPlane inBody(const MirrorPlane& plane, const Pose& pose) {
    MirrorPlane out{pose.toBody(plane.point),
                    (pose.rotation.transpose() * plane.normal).normalized()};
    // A body that stands along the plane has it along its axes, to the bit.
    snapToAxis(out.normal, 1e-14);
    return out;
}

PolyhedronSpec mirrored(const PolyhedronSpec& spec, const MirrorPlane& plane) {
    PolyhedronSpec out = spec;
    for (Vec3& v : out.vertices) v = plane.image(v);
    for (auto& face : out.faces) std::reverse(face.begin(), face.end());
    return out;
}

std::optional<PolyhedronSpec> metPlane(const PolyhedronSpec& spec, const MirrorPlane& plane,
                                       double reach) {
    for (const auto& loop : spec.faces) {
        const bool near = std::all_of(loop.begin(), loop.end(), [&](int v) {
            return std::abs(plane.height(spec.vertices[at(v)])) <= reach;
        });
        if (!near) continue;
        const auto ways = waysOut(spec, loop);
        if (!ways) continue;
        PolyhedronSpec out = spec;
        bool possible = true;
        for (std::size_t c = 0; c < loop.size(); ++c) {
            const Vec3& p = spec.vertices[at(loop[c])];
            const Vec3 away = spec.vertices[at((*ways)[c])] - p;
            const double rise = plane.normal.dot(away);
            // An edge along the plane never meets it; one that ends before it has no room.
            const double share = -plane.height(p) / rise;
            possible = possible && std::isfinite(share) && share < 0.9 &&
                       std::abs(share) * away.norm() <= 4.0 * reach;
            if (possible) out.vertices[at(loop[c])] = p + share * away;
        }
        if (possible) return out;
    }
    return std::nullopt;
}

}  // namespace ew
