// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/solid/shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ew::test {
namespace {

/// A ring of points at one height.
void addRing(PolyhedronSpec& spec, int sides, double radius, double z, double phase = 0.0) {
    for (int i = 0; i < sides; ++i) {
        const double a = phase + 2.0 * std::numbers::pi * i / sides;
        spec.vertices.emplace_back(radius * std::cos(a), radius * std::sin(a), z);
    }
}

/// The ring from `first` on as a face, looking up or down.
void addCap(PolyhedronSpec& spec, int first, int sides, bool up) {
    std::vector<int> face;
    for (int i = 0; i < sides; ++i) face.push_back(first + (up ? i : sides - 1 - i));
    spec.faces.push_back(face);
}

}  // namespace

PolyhedronSpec box(const Vec3& low, const Vec3& high) {
    PolyhedronSpec spec;
    for (const double z : {low.z(), high.z()}) {
        spec.vertices.emplace_back(low.x(), low.y(), z);
        spec.vertices.emplace_back(high.x(), low.y(), z);
        spec.vertices.emplace_back(high.x(), high.y(), z);
        spec.vertices.emplace_back(low.x(), high.y(), z);
    }
    spec.faces = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                  {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    return spec;
}

PolyhedronSpec frustum(int sides, double topRadius) {
    PolyhedronSpec spec;
    addRing(spec, sides, 1.0, 0.0);
    addRing(spec, sides, topRadius, 1.0);
    addCap(spec, 0, sides, false);
    addCap(spec, sides, sides, true);
    for (int i = 0; i < sides; ++i) {
        const int j = (i + 1) % sides;
        spec.faces.push_back({i, j, sides + j, sides + i});
    }
    return spec;
}

PolyhedronSpec prism(int sides) { return frustum(sides, 1.0); }

PolyhedronSpec pyramid(int sides) {
    PolyhedronSpec spec;
    addRing(spec, sides, 1.0, 0.0);
    spec.vertices.emplace_back(0, 0, 1);
    addCap(spec, 0, sides, false);
    for (int i = 0; i < sides; ++i) spec.faces.push_back({i, (i + 1) % sides, sides});
    return spec;
}

PolyhedronSpec bipyramid(int sides) {
    PolyhedronSpec spec;
    addRing(spec, sides, 1.0, 0.0);
    spec.vertices.emplace_back(0, 0, 1);
    spec.vertices.emplace_back(0, 0, -1);
    for (int i = 0; i < sides; ++i) {
        const int j = (i + 1) % sides;
        spec.faces.push_back({i, j, sides});
        spec.faces.push_back({j, i, sides + 1});
    }
    return spec;
}

PolyhedronSpec antiprism(int sides) {
    PolyhedronSpec spec;
    addRing(spec, sides, 1.0, 0.0);
    addRing(spec, sides, 1.0, 1.0, std::numbers::pi / sides);
    addCap(spec, 0, sides, false);
    addCap(spec, sides, sides, true);
    for (int i = 0; i < sides; ++i) {
        const int j = (i + 1) % sides;
        spec.faces.push_back({i, j, sides + i});
        spec.faces.push_back({j, sides + j, sides + i});
    }
    return spec;
}

PolyhedronSpec lPrism() {
    PolyhedronSpec spec;
    for (const double y : {0.0, 1.0}) {
        for (const Vec2& p :
             {Vec2(0, 0), Vec2(2, 0), Vec2(2, 1), Vec2(1, 1), Vec2(1, 2), Vec2(0, 2)}) {
            spec.vertices.emplace_back(p.x(), y, p.y());
        }
    }
    spec.faces = {{0, 1, 2, 3, 4, 5}, {11, 10, 9, 8, 7, 6}};
    for (int i = 0; i < 6; ++i) {
        const int j = (i + 1) % 6;
        spec.faces.push_back({i, i + 6, j + 6, j});
    }
    return spec;
}

PolyhedronSpec squareRing() {
    PolyhedronSpec spec;
    for (const double z : {0.0, 1.0}) {
        for (const double r : {2.0, 1.0}) {
            for (const Vec2& p : {Vec2(-r, -r), Vec2(r, -r), Vec2(r, r), Vec2(-r, r)}) {
                spec.vertices.emplace_back(p.x(), p.y(), z);
            }
        }
    }
    for (int i = 0; i < 4; ++i) {
        const int j = (i + 1) % 4;
        spec.faces.push_back({8 + i, 8 + j, 12 + j, 12 + i});  // top
        spec.faces.push_back({j, i, 4 + i, 4 + j});            // bottom
        spec.faces.push_back({i, j, 8 + j, 8 + i});            // outside
        spec.faces.push_back({4 + j, 4 + i, 12 + i, 12 + j});  // inside of the hole
    }
    return spec;
}

PolyhedronSpec torus(int segments, int corners) {
    PolyhedronSpec spec;
    for (int s = 0; s < segments; ++s) {
        const double a = 2.0 * std::numbers::pi * s / segments;
        for (int c = 0; c < corners; ++c) {
            const double b = 0.3 + 2.0 * std::numbers::pi * c / corners;
            const double r = 3.0 + std::cos(b);
            spec.vertices.emplace_back(r * std::cos(a), r * std::sin(a), std::sin(b));
        }
    }
    for (int s = 0; s < segments; ++s) {
        const int here = s * corners;
        const int there = (s + 1) % segments * corners;
        for (int c = 0; c < corners; ++c) {
            const int d = (c + 1) % corners;
            spec.faces.push_back({here + c, there + c, there + d, here + d});
        }
    }
    return spec;
}

PolyhedronSpec together(const PolyhedronSpec& a, const PolyhedronSpec& b) {
    PolyhedronSpec spec = a;
    const int base = static_cast<int>(a.vertices.size());
    spec.vertices.insert(spec.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (std::vector<int> face : b.faces) {
        for (int& i : face) i += base;
        spec.faces.push_back(std::move(face));
    }
    return spec;
}

PolyhedronSpec insideOut(PolyhedronSpec spec) {
    for (auto& face : spec.faces) std::reverse(face.begin(), face.end());
    return spec;
}

PolyhedronSpec moved(PolyhedronSpec spec, double angleRad, double scale, const Vec3& shift) {
    const Mat3 turn = Eigen::AngleAxisd(angleRad, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    for (Vec3& p : spec.vertices) p = turn * (scale * p) + shift;
    return spec;
}

double plainVolume(const PolyhedronSpec& spec) {
    double six = 0.0;
    const Vec3& o = spec.vertices[0];
    const auto at = [&](int i) -> Vec3 { return spec.vertices[static_cast<std::size_t>(i)] - o; };
    for (const auto& face : spec.faces) {
        for (std::size_t k = 1; k + 1 < face.size(); ++k) {
            six += at(face[0]).dot(at(face[k]).cross(at(face[k + 1])));
        }
    }
    return six / 6.0;
}

}  // namespace ew::test
