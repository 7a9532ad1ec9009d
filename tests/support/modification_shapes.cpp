// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/modification_shapes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/solid/visibility.h"

namespace ew::test {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The parts of a segment that lie on no edge of the solid.
Lines3 withoutEdges(const std::array<Vec3, 2>& line, const Solid& solid) {
    const Vec3 u = line[1] - line[0];
    const double len = u.norm();
    std::vector<std::array<double, 2>> left{{0.0, len}};
    for (const SolidEdge& e : solid.edges()) {
        const Vec3& a = solid.vertices()[at(e.ends[0])];
        const Vec3& b = solid.vertices()[at(e.ends[1])];
        if (u.cross(a - line[0]).norm() > 1e-6 * len || u.cross(b - line[0]).norm() > 1e-6 * len) {
            continue;
        }
        const double ta = (a - line[0]).dot(u) / len;
        const double tb = (b - line[0]).dot(u) / len;
        std::vector<std::array<double, 2>> next;
        for (const auto& l : left) {
            const double lo = std::min(ta, tb);
            const double hi = std::max(ta, tb);
            if (std::min(l[1], lo) > l[0]) next.push_back({l[0], std::min(l[1], lo)});
            if (l[1] > std::max(l[0], hi)) next.push_back({std::max(l[0], hi), l[1]});
        }
        left = std::move(next);
    }
    Lines3 lines;
    for (const auto& l : left) {
        if (l[1] - l[0] < 1e-6) continue;
        lines.push_back({line[0] + l[0] / len * u, line[0] + l[1] / len * u});
    }
    return lines;
}

}  // namespace

Solid solidOf(const PolyhedronSpec& spec) {
    auto solid = Solid::fromSpec(spec);
    if (!solid) throw std::runtime_error(solid.error().message);
    return *solid;
}

PolyhedronSpec boxSpec(const Vec3& a, const Vec3& b) {
    PolyhedronSpec s;
    for (const double z : {a.z(), b.z()}) {
        s.vertices.emplace_back(a.x(), a.y(), z);
        s.vertices.emplace_back(b.x(), a.y(), z);
        s.vertices.emplace_back(b.x(), b.y(), z);
        s.vertices.emplace_back(a.x(), b.y(), z);
    }
    s.faces = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    return s;
}

PolyhedronSpec prismSpec(const std::vector<Vec3>& outline, const Vec3& along) {
    PolyhedronSpec s;
    const int n = static_cast<int>(outline.size());
    s.faces.resize(2);
    for (const Vec3& p : outline) s.vertices.push_back(p);
    for (const Vec3& p : outline) s.vertices.emplace_back(p + along);
    for (int i = 0; i < n; ++i) {
        s.faces[0].push_back(n - 1 - i);
        s.faces[1].push_back(n + i);
        s.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
    }
    if ((outline[1] - outline[0]).cross(outline[2] - outline[0]).dot(along) < 0) {
        for (auto& f : s.faces) std::reverse(f.begin(), f.end());
    }
    return s;
}

PolyhedronSpec pyramidSpec(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& apex) {
    PolyhedronSpec s;
    s.vertices = {a, b, c, apex};
    s.faces = {{2, 1, 0}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    if ((b - a).cross(c - a).dot(apex - a) < 0) {
        for (auto& f : s.faces) std::reverse(f.begin(), f.end());
    }
    return s;
}

PolyhedronSpec frustumSpec(const Vec3& low, const Vec3& high, double drawnInX, double drawnInY) {
    PolyhedronSpec s = boxSpec(low, high);
    for (std::size_t i = 4; i < 8; ++i) {
        Vec3& v = s.vertices[i];
        v.x() += v.x() == low.x() ? drawnInX : -drawnInX;
        v.y() += v.y() == low.y() ? drawnInY : -drawnInY;
    }
    return s;
}

Lines3 polyline(const std::vector<Vec3>& p) {
    Lines3 lines;
    for (std::size_t i = 0; i + 1 < p.size(); ++i) lines.push_back({p[i], p[i + 1]});
    return lines;
}

Lines3 joined(Lines3 a, const Lines3& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

Lines3 newVisibleLines(const Body& target, const Solid& result, const OrthographicCamera& camera) {
    const auto view = SolidView::make(result, target.pose, camera);
    Lines3 lines;
    for (const VisiblePiece& p : view->visiblePieces()) {
        if (p.point) continue;
        const auto& ends = result.edges()[at(p.edge)].ends;
        const Vec3& a = result.vertices()[at(ends[0])];
        const Vec3& b = result.vertices()[at(ends[1])];
        for (const auto& l : withoutEdges({a + p.t0 * (b - a), a + p.t1 * (b - a)}, target.solid)) {
            // Nobody draws a line as short as its corners are wide.
            if ((l[1] - l[0]).norm() > 2.5) lines.push_back(l);
        }
    }
    return lines;
}

}  // namespace ew::test
