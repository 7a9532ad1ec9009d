// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/template_variations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/support/random_shapes.h"

namespace ew::test {

PolyhedronSpec cutCorner(const PolyhedronSpec& spec, int vertex, double part) {
    PolyhedronSpec out = spec;
    const Vec3 corner = spec.vertices[static_cast<std::size_t>(vertex)];
    std::array<int, 3> neighbours{-1, -1, -1};
    std::array<int, 3> cuts{vertex, static_cast<int>(spec.vertices.size()),
                            static_cast<int>(spec.vertices.size()) + 1};
    std::size_t known = 0;
    const auto cutTowards = [&](int neighbour) {
        for (std::size_t i = 0; i < known; ++i) {
            if (neighbours[i] == neighbour) return cuts[i];
        }
        const Vec3 end = spec.vertices[static_cast<std::size_t>(neighbour)];
        const Vec3 p = corner + part * (end - corner);
        if (known == 0)
            out.vertices[static_cast<std::size_t>(vertex)] = p;
        else
            out.vertices.push_back(p);
        neighbours[known] = neighbour;
        return cuts[known++];
    };
    // Each face at the corner runs in from one neighbour and out to the next; the new triangle runs
    // the other way round.
    std::vector<std::array<int, 2>> steps;
    for (std::vector<int>& face : out.faces) {
        const auto at = std::find(face.begin(), face.end(), vertex);
        if (at == face.end()) continue;
        const auto n = static_cast<std::ptrdiff_t>(face.size());
        const auto i = at - face.begin();
        const int in = cutTowards(face[static_cast<std::size_t>((i + n - 1) % n)]);
        const int on = cutTowards(face[static_cast<std::size_t>((i + 1) % n)]);
        *at = in;
        face.insert(face.begin() + i + 1, on);
        steps.push_back({on, in});
    }
    std::vector<int> triangle{steps[0][0], steps[0][1]};
    for (const auto& step : steps) {
        if (step[0] == triangle[1]) triangle.push_back(step[1]);
    }
    out.faces.push_back(triangle);
    return out;
}

std::vector<Template> templateVariations(int count, Random& random, int fewestCorners) {
    std::vector<Template> out;
    for (int i = 0; i < count; ++i) {
        const int corners = fewestCorners + random.index(10 - fewestCorners);
        const double top = random.chance(0.5) ? 1.0 : random.uniform(0.4, 0.8);
        std::vector<Vec2> polygon;
        for (int k = 0; k < corners; ++k) {
            const double a = 2.0 * std::numbers::pi * k / corners;
            polygon.emplace_back(std::cos(a), std::sin(a));
        }
        Template t;
        t.id = "variation-" + std::to_string(i);
        t.name = "Variation " + std::to_string(i);
        t.shape = prismSpec(polygon, random.uniform(0.6, 1.6));
        for (int k = corners; k < 2 * corners; ++k) {
            t.shape.vertices[static_cast<std::size_t>(k)].head<2>() *= top;
        }
        std::vector<int> places(2 * static_cast<std::size_t>(corners));
        for (std::size_t k = 0; k < places.size(); ++k) places[k] = static_cast<int>(k);
        random.shuffle(places);
        places.resize(static_cast<std::size_t>(random.index(5)));
        for (const int place : places)
            t.shape = cutCorner(t.shape, place, random.uniform(0.2, 0.4));
        std::vector<TemplateEdge> sides;
        for (int k = 0; k < corners; ++k) {
            const auto cut = [&](int v) {
                return std::find(places.begin(), places.end(), v) != places.end();
            };
            if (!cut(k) && !cut(k + corners)) sides.push_back({k, k + corners});
        }
        if (top == 1.0 && sides.size() > 1) t.relations.parallel.push_back(std::move(sides));
        out.push_back(std::move(t));
    }
    return out;
}

}  // namespace ew::test
