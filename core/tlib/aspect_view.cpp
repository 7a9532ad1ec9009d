// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tlib/aspect_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ew {
namespace {
std::size_t at(int i) { return static_cast<std::size_t>(i); }
}  // namespace

AspectView makeView(const PolyhedronSpec& shape, const TemplateAnalysis& analysis,
                    const Vec3& direction) {
    const Vec3 helper = std::abs(direction.z()) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
    const Vec3 right = direction.cross(helper).normalized();
    const Vec3 down = direction.cross(right);
    Eigen::AlignedBox3d box;
    for (const Vec3& p : shape.vertices) box.extend(p);
    const double scale = 1.0 / box.diagonal().norm();
    AspectView view;
    for (const Vec3& p : shape.vertices) {
        const Vec3 q = (p - box.center()) * scale;
        view.points.emplace_back(q.dot(right), q.dot(down), q.dot(direction));
    }
    for (const Vec3& n : analysis.faceNormals) view.facing.push_back(n.dot(direction));
    return view;
}

bool insideLoop(const AspectView& view, const std::vector<int>& loop, const Vec2& p) {
    bool in = false;
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
        const Vec3& a = view.points[at(loop[i])];
        const Vec3& b = view.points[at(loop[j])];
        if ((a.y() > p.y()) != (b.y() > p.y()) &&
            p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x()) {
            in = !in;
        }
    }
    return in;
}

std::vector<Vec3> spreadDirections(int count) {
    std::vector<Vec3> result;
    const double golden = std::numbers::pi * (3.0 - std::sqrt(5.0));
    const Mat3 turn =
        (Eigen::AngleAxisd(0.317, Vec3::UnitX()) * Eigen::AngleAxisd(0.711, Vec3::UnitY()))
            .toRotationMatrix();
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - 2.0 * (i + 0.5) / count;
        const double r = std::sqrt(1.0 - z * z);
        result.push_back(turn * Vec3(r * std::cos(golden * i), r * std::sin(golden * i), z));
    }
    return result;
}

std::string labelledKey(const Aspect& a) {
    std::string key;
    for (const int f : a.visibleFaces) key.append("f").append(std::to_string(f));
    std::vector<std::string> parts;
    for (std::size_t e = 0; e < a.edge.size(); ++e) {
        int u = a.vertex[at(a.graph.edges[e][0])];
        int v = a.vertex[at(a.graph.edges[e][1])];
        if (u > v) std::swap(u, v);
        std::string part = std::to_string(a.edge[e]);
        part.append(":").append(std::to_string(u)).append(",").append(std::to_string(v));
        parts.push_back(std::move(part));
    }
    std::sort(parts.begin(), parts.end());
    for (const auto& p : parts) key.append(";").append(p);
    return key;
}

namespace {
constexpr std::size_t kDirectionsKept = 4;

}  // namespace

void keepDirection(Aspect& aspect, const Vec3& d) {
    for (const Vec3& k : aspect.directions) {
        if (k.dot(d) > 0.96) return;
    }
    if (aspect.directions.size() < kDirectionsKept) aspect.directions.push_back(d);
}

}  // namespace ew
