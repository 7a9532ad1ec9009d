// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/random_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/support/visible_edges.h"

namespace ew::test {
namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

/// A triangle with angles from 35 to 100 degrees and mean edge 1, counter-clockwise.
std::vector<Vec2> randomTriangle(Random& random) {
    double a = 0.0, b = 0.0, c = 0.0;
    do {
        a = random.uniform(35.0, 100.0);
        b = random.uniform(35.0, 100.0);
        c = 180.0 - a - b;
    } while (c < 35.0 || c > 100.0);
    const double ab = std::sin(radians(c));
    const double ac = std::sin(radians(b));
    const double bc = std::sin(radians(a));
    const double scale = 3.0 / (ab + ac + bc);
    return {Vec2(0, 0), Vec2(scale * ab, 0),
            scale * ac * Vec2(std::cos(radians(a)), std::sin(radians(a)))};
}

PolyhedronSpec randomPyramid(Random& random) {
    const double regular = 1.0 / (6.0 * std::numbers::sqrt2);
    while (true) {
        const std::vector<Vec2> base = randomTriangle(random);
        const double u = random.uniform(0.1, 0.8);
        const double v = random.uniform(0.1, 0.9 - u);
        const Vec2 foot = base[0] + u * (base[1] - base[0]) + v * (base[2] - base[0]);
        const double height = random.uniform(0.5, 1.3);
        PolyhedronSpec spec;
        for (const Vec2& p : base) spec.vertices.emplace_back(p.x(), p.y(), 0.0);
        spec.vertices.emplace_back(foot.x(), foot.y(), height);
        spec.faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
        double sum = 0.0;
        for (const SpecEdge& e : specEdges(spec)) {
            sum += (spec.vertices[static_cast<std::size_t>(e.ends[0])] -
                    spec.vertices[static_cast<std::size_t>(e.ends[1])])
                       .norm();
        }
        if (specVolume(spec) >= 0.4 * regular * std::pow(sum / 6.0, 3)) return spec;
    }
}

PolyhedronSpec randomFrustum(Random& random) {
    const double width = random.uniform(0.5, 1.0);
    const double top = random.uniform(0.3, 0.75);
    PolyhedronSpec spec = boxSpec(1.0, width, random.uniform(0.35, 1.2));
    const Vec2 middle(0.5, width / 2.0);
    for (std::size_t i = 4; i < 8; ++i) {
        spec.vertices[i].head<2>() = middle + top * (spec.vertices[i].head<2>() - middle);
    }
    return spec;
}

/// One of the 24 turns that take axes to axes.
Mat3 randomAttitude(Random& random) {
    std::vector<int> axes{0, 1, 2};
    random.shuffle(axes);
    Mat3 m = Mat3::Zero();
    for (int i = 0; i < 3; ++i) {
        m(i, axes[static_cast<std::size_t>(i)]) = random.chance(0.5) ? 1.0 : -1.0;
    }
    if (m.determinant() < 0.0) m.row(2) *= -1.0;
    return m;
}

void turn(PolyhedronSpec& spec, const Mat3& rotation) {
    for (Vec3& v : spec.vertices) v = rotation * v;
}

PolyhedronSpec randomLPrism(Random& random) {
    const double w = random.uniform(0.5, 1.0);
    const double h = random.uniform(0.5, 1.0);
    const double nw = w * random.uniform(0.3, 0.7);
    const double nh = h * random.uniform(0.3, 0.7);
    PolyhedronSpec spec = prismSpec({Vec2(0, 0), Vec2(w, 0), Vec2(w, h - nh), Vec2(w - nw, h - nh),
                                     Vec2(w - nw, h), Vec2(0, h)},
                                    random.uniform(0.35, 1.0));
    turn(spec, randomAttitude(random));
    return spec;
}

}  // namespace

PolyhedronSpec prismSpec(const std::vector<Vec2>& polygon, double height) {
    PolyhedronSpec spec;
    const int n = static_cast<int>(polygon.size());
    for (const Vec2& p : polygon) spec.vertices.emplace_back(p.x(), p.y(), 0.0);
    for (const Vec2& p : polygon) spec.vertices.emplace_back(p.x(), p.y(), height);
    std::vector<int> bottom, top;
    for (int i = 0; i < n; ++i) {
        bottom.push_back(n - 1 - i);
        top.push_back(n + i);
    }
    spec.faces = {bottom, top};
    for (int i = 0; i < n; ++i) {
        const int j = (i + 1) % n;
        spec.faces.push_back({i, j, n + j, n + i});
    }
    return spec;
}

PolyhedronSpec boxSpec(double x, double y, double z) {
    return prismSpec({Vec2(0, 0), Vec2(x, 0), Vec2(x, y), Vec2(0, y)}, z);
}

PolyhedronSpec randomShape(const std::string& id, Random& random) {
    if (id == "cube") {
        std::vector<double> sides{1.0, random.uniform(0.35, 1.0), random.uniform(0.35, 1.0)};
        random.shuffle(sides);
        return boxSpec(sides[0], sides[1], sides[2]);
    }
    if (id == "triangular-prism") {
        PolyhedronSpec spec = prismSpec(randomTriangle(random), random.uniform(0.5, 1.6));
        if (random.chance(0.5)) {
            // Lying on the side over its first base edge.
            turn(spec, Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitX()).toRotationMatrix());
        }
        return spec;
    }
    if (id == "triangular-pyramid") return randomPyramid(random);
    if (id == "wedge-frustum") return randomFrustum(random);
    if (id == "l-prism") return randomLPrism(random);
    return {};
}

}  // namespace ew::test
