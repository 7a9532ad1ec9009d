// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/surface/shapes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>
#include <numbers>

namespace ew::test {
namespace {

void addRing(PolyhedronSpec& spec, int sides, double radius, double z) {
    for (int i = 0; i < sides; ++i) {
        const double a = 2.0 * std::numbers::pi * i / sides;
        spec.vertices.emplace_back(radius * std::cos(a), radius * std::sin(a), z);
    }
}

std::vector<int> ring(int first, int sides, bool up) {
    std::vector<int> face;
    for (int i = 0; i < sides; ++i) face.push_back(first + (up ? i : sides - 1 - i));
    return face;
}

/// Grid planes with random distances.
std::vector<double> randomLines(Random& random, int count) {
    std::vector<double> lines{0.0};
    for (int i = 0; i < count; ++i) lines.push_back(lines.back() + random.uniform(0.3, 1.5));
    return lines;
}

PolyhedronSpec randomCells(Random& random) {
    std::array<std::vector<double>, 3> lines;
    for (auto& axis : lines) axis = randomLines(random, 1 + random.index(4));
    std::size_t cells = 1;
    for (const auto& axis : lines) cells *= axis.size() - 1;
    std::vector<bool> filled(cells);
    const double density = random.uniform(0.35, 0.95);
    for (std::size_t i = 0; i < cells; ++i) filled[i] = random.chance(density);
    if (std::find(filled.begin(), filled.end(), true) == filled.end()) filled[0] = true;
    return cellsSpec(lines, filled);
}

PolyhedronSpec randomSpec(Random& random) {
    const int sides = 3 + random.index(7);
    switch (random.index(9)) {
        case 0:
            return prismSpec(sides, 1.0, 1.0, random.uniform(0.2, 3.0));
        case 1:
            return prismSpec(sides, 1.0, random.uniform(0.2, 1.8), random.uniform(0.2, 3.0));
        case 2:
            return pyramidSpec(sides, random.uniform(0.2, 3.0));
        case 3:
            return bipyramidSpec(sides, random.uniform(0.3, 2.0));
        default:
            return randomCells(random);
    }
}

/// Maps planes to planes; the denominator stays near 1 within the unit ball.
void warp(Random& random, PolyhedronSpec& spec) {
    Vec3 low = spec.vertices[0];
    Vec3 high = low;
    for (const Vec3& p : spec.vertices) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const Vec3 center = 0.5 * (low + high);
    const double size = (high - low).norm();
    Mat3 linear = Mat3::Identity();
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) linear(i, k) += random.uniform(-0.3, 0.3);
    }
    if (linear.determinant() < 0.3) linear = Mat3::Identity();
    const Vec3 w(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
    const double scale = std::exp(random.uniform(-3.0, 5.0));
    for (Vec3& p : spec.vertices) {
        const Vec3 q = (p - center) / size;
        p = scale * (linear * q) / (1.0 + w.dot(q));
    }
}

}  // namespace

Solid solidOf(const PolyhedronSpec& spec) {
    auto solid = Solid::fromSpec(spec);
    if (!solid) {
        std::cerr << "no solid: " << solid.error().message << "\n";
        std::abort();
    }
    return *solid;
}

PolyhedronSpec boxSpec(const Vec3& low, const Vec3& high) {
    return cellsSpec(
        {std::vector<double>{low.x(), high.x()}, {low.y(), high.y()}, {low.z(), high.z()}}, {true});
}

PolyhedronSpec prismSpec(int sides, double bottomRadius, double topRadius, double height) {
    PolyhedronSpec spec;
    addRing(spec, sides, bottomRadius, 0.0);
    addRing(spec, sides, topRadius, height);
    spec.faces = {ring(0, sides, false), ring(sides, sides, true)};
    for (int i = 0; i < sides; ++i) {
        const int j = (i + 1) % sides;
        spec.faces.push_back({i, j, sides + j, sides + i});
    }
    return spec;
}

PolyhedronSpec pyramidSpec(int sides, double height) {
    PolyhedronSpec spec;
    addRing(spec, sides, 1.0, 0.0);
    spec.vertices.emplace_back(0, 0, height);
    spec.faces = {ring(0, sides, false)};
    for (int i = 0; i < sides; ++i) spec.faces.push_back({i, (i + 1) % sides, sides});
    return spec;
}

PolyhedronSpec bipyramidSpec(int sides, double height) {
    PolyhedronSpec spec;
    addRing(spec, sides, 1.0, 0.0);
    spec.vertices.emplace_back(0, 0, height);
    spec.vertices.emplace_back(0, 0, -height);
    for (int i = 0; i < sides; ++i) {
        const int j = (i + 1) % sides;
        spec.faces.push_back({i, j, sides});
        spec.faces.push_back({j, i, sides + 1});
    }
    return spec;
}

PolyhedronSpec lPrismSpec() {
    return cellsSpec({std::vector<double>{0, 1, 2}, {0, 1}, {0, 1, 2}}, {true, true, true, false});
}

PolyhedronSpec cellsSpec(const std::array<std::vector<double>, 3>& lines,
                         const std::vector<bool>& filled) {
    const std::array<int, 3> n{static_cast<int>(lines[0].size()) - 1,
                               static_cast<int>(lines[1].size()) - 1,
                               static_cast<int>(lines[2].size()) - 1};
    const auto isFilled = [&](const std::array<int, 3>& c) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (c[k] < 0 || c[k] >= n[k]) return false;
        }
        return static_cast<bool>(
            filled[static_cast<std::size_t>(c[0] + n[0] * (c[1] + n[1] * c[2]))]);
    };
    PolyhedronSpec spec;
    std::map<std::array<int, 3>, int> ids;
    const auto id = [&](const std::array<int, 3>& c) {
        const auto [it, isNew] = ids.emplace(c, static_cast<int>(spec.vertices.size()));
        if (isNew) {
            spec.vertices.emplace_back(lines[0][static_cast<std::size_t>(c[0])],
                                       lines[1][static_cast<std::size_t>(c[1])],
                                       lines[2][static_cast<std::size_t>(c[2])]);
        }
        return it->second;
    };
    for (int z = 0; z < n[2]; ++z) {
        for (int y = 0; y < n[1]; ++y) {
            for (int x = 0; x < n[0]; ++x) {
                const std::array<int, 3> cell{x, y, z};
                if (!isFilled(cell)) continue;
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const std::size_t u = (axis + 1) % 3;
                    const std::size_t v = (axis + 2) % 3;
                    for (const int side : {0, 1}) {
                        std::array<int, 3> other = cell;
                        other[axis] += side == 1 ? 1 : -1;
                        if (isFilled(other)) continue;
                        std::array<int, 3> c = cell;
                        c[axis] += side;
                        std::vector<int> face{id(c)};
                        ++c[u];
                        face.push_back(id(c));
                        ++c[v];
                        face.push_back(id(c));
                        --c[u];
                        face.push_back(id(c));
                        if (side == 0) std::reverse(face.begin(), face.end());
                        spec.faces.push_back(face);
                    }
                }
            }
        }
    }
    return spec;
}

PolyhedronSpec bossesSpec(int n) {
    std::vector<double> line{0.0};
    for (int i = 0; i < 2 * n + 1; ++i) line.push_back(line.back() + 1.0);
    const int m = 2 * n + 1;
    std::vector<bool> filled(static_cast<std::size_t>(2 * m * m), false);
    for (int y = 0; y < m; ++y) {
        for (int x = 0; x < m; ++x) {
            filled[static_cast<std::size_t>(x + m * y)] = true;
            filled[static_cast<std::size_t>(x + m * (y + m))] = x % 2 == 1 && y % 2 == 1;
        }
    }
    return cellsSpec({line, line, std::vector<double>{0.0, 1.0, 1.5}}, filled);
}

Solid randomSolid(std::uint64_t number) {
    Random random(Random::mix(number, 77));
    while (true) {
        PolyhedronSpec spec = randomSpec(random);
        if (random.chance(0.7)) warp(random, spec);
        auto solid = Solid::fromSpec(spec);
        if (solid) return *solid;
    }
}

FilletOptions allEdges(const Solid& solid, double setback, int segments) {
    FilletOptions options;
    options.segments = segments;
    for (std::size_t e = 0; e < solid.edges().size(); ++e) {
        options.edges.push_back({static_cast<int>(e), setback});
    }
    return options;
}

FilletOptions edgesOfKind(const Solid& solid, bool convex, double setback, int segments) {
    FilletOptions options = allEdges(solid, setback, segments);
    std::erase_if(options.edges, [&](const FilletChoice& c) {
        return solid.edges()[static_cast<std::size_t>(c.edge)].convex != convex;
    });
    return options;
}

double volumeOf(const FilletedCage& cage) {
    const auto triangles = triangulate(cage.mesh);
    return triangles ? enclosedVolume(cage.mesh.points, triangles->triangles) : 0.0;
}

}  // namespace ew::test
