// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/practice/practice_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/solid/boolean.h"

namespace ew {
namespace {

using Polygon = std::vector<Vec2>;

constexpr double kSizeMm = 60.0;

/// Over a counter-clockwise polygon; the top is drawn in round its middle, to one apex for 0.
PolyhedronSpec raised(const Polygon& polygon, double height, double top = 1.0) {
    const int n = static_cast<int>(polygon.size());
    PolyhedronSpec spec;
    Vec2 middle = Vec2::Zero();
    for (const Vec2& p : polygon) {
        spec.vertices.emplace_back(p.x(), p.y(), 0.0);
        middle += p / n;
    }
    std::vector<int> bottom;
    for (int i = n; i-- > 0;) bottom.push_back(i);
    spec.faces.push_back(bottom);
    if (top <= 0.0) {
        spec.vertices.emplace_back(middle.x(), middle.y(), height);
        for (int i = 0; i < n; ++i) spec.faces.push_back({i, (i + 1) % n, n});
        return spec;
    }
    std::vector<int> lid;
    for (int i = 0; i < n; ++i) {
        const Vec2 p = middle + top * (polygon[static_cast<std::size_t>(i)] - middle);
        spec.vertices.emplace_back(p.x(), p.y(), height);
        spec.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
        lid.push_back(n + i);
    }
    spec.faces.push_back(lid);
    return spec;
}

Polygon rectangle(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Polygon regular(int n, double radius) {
    Polygon out;
    for (int i = 0; i < n; ++i) {
        const double a = 2.0 * std::numbers::pi * (i + 0.5) / n;
        out.emplace_back(radius * std::cos(a), radius * std::sin(a));
    }
    return out;
}

/// On its front face instead of its base.
PolyhedronSpec lying(PolyhedronSpec spec) {
    for (Vec3& v : spec.vertices) v = Vec3(v.x(), -v.z(), v.y());
    return spec;
}

PolyhedronSpec boxSpec(PracticeRandom& random) {
    const double height = random.uniform(0.5, 1.3);
    return raised(rectangle(0, 0, random.uniform(0.7, 1.5), random.uniform(0.6, 1.2)), height);
}

PolyhedronSpec simpleSpec(PracticeRandom& random) {
    const double height = random.uniform(0.7, 1.3);
    switch (random.index(3)) {
        case 0:
            return lying(raised({{0, 0}, {1, 0}, {random.uniform(0.3, 0.7), 0.8}},
                                random.uniform(0.8, 1.4)));
        case 1:
            return raised({{0, 0}, {1, 0}, {random.uniform(0.2, 0.5), 0.9}}, height, 0.0);
        default:
            return raised(rectangle(0, 0, random.uniform(0.9, 1.3), random.uniform(0.8, 1.1)),
                          random.uniform(0.5, 0.8), random.uniform(0.45, 0.65));
    }
}

PolyhedronSpec outlinedSpec(PracticeRandom& random) {
    const double a = random.uniform(0.3, 0.45);
    const double height = random.uniform(0.5, 0.9);
    switch (random.index(3)) {
        case 0:
            return lying(raised({{0, 0}, {1.2, 0}, {1.2, a}, {a, a}, {a, 1}, {0, 1}}, height));
        case 1:
            return lying(raised({{0, 0}, {1, 0}, {1, 0.6}, {0.5, 1}, {0, 0.6}}, height));
        default:
            return raised(regular(5 + random.index(2), 0.6), height);
    }
}

PolyhedronSpec bentSpec(PracticeRandom& random) {
    const double a = random.uniform(0.3, 0.4);
    const double height = random.uniform(0.4, 0.8);
    switch (random.index(3)) {
        case 0:  // T
            return lying(raised({{a, 0},
                                 {1.2 - a, 0},
                                 {1.2 - a, 0.6},
                                 {1.2, 0.6},
                                 {1.2, 1},
                                 {0, 1},
                                 {0, 0.6},
                                 {a, 0.6}},
                                height));
        case 1:  // U
            return lying(raised({{0, 0},
                                 {1.3, 0},
                                 {1.3, 1},
                                 {1.3 - a, 1},
                                 {1.3 - a, 0.4},
                                 {a, 0.4},
                                 {a, 1},
                                 {0, 1}},
                                height));
        default:  // stairs
            return lying(raised({{0, 0},
                                 {1.2, 0},
                                 {1.2, 0.33},
                                 {0.8, 0.33},
                                 {0.8, 0.66},
                                 {0.4, 0.66},
                                 {0.4, 1},
                                 {0, 1}},
                                height));
    }
}

PolyhedronSpec scaled(PolyhedronSpec spec, double by) {
    for (Vec3& v : spec.vertices) v *= by;
    return spec;
}

/// Another box stands well inside its top.
Result<Solid> twoBoxes(PracticeRandom& random) {
    const double w = random.uniform(1.0, 1.5);
    const double d = random.uniform(0.8, 1.2);
    const double h = random.uniform(0.35, 0.6);
    auto base = Solid::fromSpec(scaled(raised(rectangle(0, 0, w, d), h), kSizeMm));
    if (!base) return base;
    const double x = w * random.uniform(0.2, 0.4);
    const double y = d * random.uniform(0.2, 0.35);
    PolyhedronSpec top =
        raised(rectangle(x, y, x + 0.42 * w, y + 0.42 * d), random.uniform(0.35, 0.6));
    for (Vec3& v : top.vertices) v.z() += h;
    auto other = Solid::fromSpec(scaled(std::move(top), kSizeMm));
    if (!other) return other;
    auto both = combine(*base, *other, BooleanKind::Add);
    if (!both) return fail(both.error());
    return std::move(both->solid);
}

OrthographicCamera cameraFor(const Solid& solid, PracticeRandom& random) {
    constexpr double kDegree = std::numbers::pi / 180.0;
    constexpr double kAcrossPx = 420.0;
    const double round = random.uniform(28.0, 62.0) * kDegree;
    const double down = random.uniform(24.0, 38.0) * kDegree;
    OrthographicCamera camera;
    camera.direction =
        Vec3(-std::cos(down) * std::sin(round), std::cos(down) * std::cos(round), -std::sin(down))
            .normalized();
    Eigen::AlignedBox2d seen;
    camera.center = Vec3::Zero();
    camera.worldPerPixel = 1.0;
    for (const Vec3& v : solid.vertices()) seen.extend(camera.project(v));
    camera.center = camera.unproject(seen.center());
    camera.worldPerPixel = seen.sizes().maxCoeff() / kAcrossPx;
    return camera;
}

}  // namespace

double PracticeRandom::uniform(double low, double high) {
    constexpr double kAll = 4294967296.0;
    return low + (high - low) * (static_cast<double>(engine_()) / kAll);
}

int PracticeRandom::index(int count) {
    return std::min(count - 1, static_cast<int>(uniform(0.0, count)));
}

Result<PracticeShape> practiceShape(int level, PracticeRandom& random) {
    Result<Solid> solid = fail(Errc::BadValue, "There is no such level.");
    switch (level) {
        case 1:
            solid = Solid::fromSpec(scaled(boxSpec(random), kSizeMm));
            break;
        case 2:
            solid = Solid::fromSpec(scaled(simpleSpec(random), kSizeMm));
            break;
        case 3:
            solid = Solid::fromSpec(scaled(outlinedSpec(random), kSizeMm));
            break;
        case 4:
            solid = Solid::fromSpec(scaled(bentSpec(random), kSizeMm));
            break;
        case 5:
            solid = twoBoxes(random);
            break;
        default:
            break;
    }
    if (!solid) return fail(solid.error());
    const OrthographicCamera camera = cameraFor(*solid, random);
    return PracticeShape{*std::move(solid), camera};
}

}  // namespace ew
