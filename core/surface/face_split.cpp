// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/face_split.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/tolerance.h"
#include "core/surface/planar_triangulation.h"
#include "core/surface/poly_mesh.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Largest distance of a corner's cosine from a right angle, 0 for a rectangle; 2 where a corner is
/// flat or turns the wrong way.
double badness(const std::vector<Vec3>& points, const std::array<int, 4>& quad,
               const Vec3& normal) {
    double worst = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec3 a = (points[at(quad[(k + 1) % 4])] - points[at(quad[k])]).normalized();
        const Vec3 b = (points[at(quad[(k + 3) % 4])] - points[at(quad[k])]).normalized();
        if (a.cross(b).dot(normal) < tol::kLeastQuadSine) return 2.0;
        worst = std::max(worst, std::abs(a.dot(b)));
    }
    return worst;
}

struct Join {
    double badness;
    std::size_t first;
    std::size_t second;
    std::array<int, 4> quad;
};

}  // namespace

bool isConvex(const std::vector<Vec3>& points, std::span<const int> loop) {
    const Vec3 normal = loopAreaVector(points, loop).normalized();
    const std::size_t n = loop.size();
    for (std::size_t k = 0; k < n; ++k) {
        const Vec3 in = points[at(loop[(k + 1) % n])] - points[at(loop[k])];
        const Vec3 out = points[at(loop[(k + 2) % n])] - points[at(loop[(k + 1) % n])];
        const double turn = in.cross(out).dot(normal);
        if (turn < -tol::kSamePlaneRelative * in.norm() * out.norm()) return false;
    }
    return true;
}

std::vector<std::vector<int>> splitFace(const std::vector<Vec3>& points,
                                        std::span<const std::span<const int>> loops) {
    const Vec3 normal = loopAreaVector(points, loops[0]).normalized();
    const auto triangles = triangulatePlanar(points, loops, normal);
    if (!triangles) return {};
    std::map<std::array<int, 2>, std::size_t> left;
    for (std::size_t t = 0; t < triangles->size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
            left[{(*triangles)[t][k], (*triangles)[t][(k + 1) % 3]}] = t;
        }
    }
    std::vector<Join> joins;
    for (const auto& entry : left) {
        const auto& side = entry.first;  // no binding: Clang 14 cannot capture one
        const std::size_t t = entry.second;
        const auto back = left.find({side[1], side[0]});
        if (side[0] > side[1] || back == left.end()) continue;
        const auto tip = [&](std::size_t triangle) {
            for (const int i : (*triangles)[triangle]) {
                if (i != side[0] && i != side[1]) return i;
            }
            return -1;
        };
        const std::array<int, 4> quad{side[0], tip(back->second), side[1], tip(t)};
        const double bad = badness(points, quad, normal);
        if (bad < 1.0) joins.push_back({bad, t, back->second, quad});
    }
    std::stable_sort(joins.begin(), joins.end(),
                     [](const Join& a, const Join& b) { return a.badness < b.badness; });
    std::vector<bool> used(triangles->size(), false);
    std::vector<std::vector<int>> out;
    for (const Join& join : joins) {
        if (used[join.first] || used[join.second]) continue;
        used[join.first] = used[join.second] = true;
        out.emplace_back(join.quad.begin(), join.quad.end());
    }
    for (std::size_t t = 0; t < triangles->size(); ++t) {
        if (!used[t]) out.emplace_back((*triangles)[t].begin(), (*triangles)[t].end());
    }
    return out;
}

}  // namespace ew
