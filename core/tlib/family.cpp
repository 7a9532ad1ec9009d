// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tlib/family.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "core/tlib/found_relations.h"

namespace ew {

namespace {

constexpr double kRadiusMm = 30.0;
constexpr double kHeightMm = 50.0;
constexpr double kTopShare = 0.5;  // of a frustum's base

void addRing(PolyhedronSpec& shape, int corners, double radius, double z) {
    for (int i = 0; i < corners; ++i) {
        // Turned by half a side, so that a base of four corners lies along the axes.
        const double a = 2.0 * std::numbers::pi * (i + 0.5) / corners - std::numbers::pi / 2.0;
        shape.vertices.emplace_back(radius * std::cos(a), radius * std::sin(a), z);
    }
}

PolyhedronSpec shapeOf(Family family, int n) {
    PolyhedronSpec shape;
    addRing(shape, n, kRadiusMm, 0.0);
    std::vector<int> bottom;
    for (int i = n - 1; i >= 0; --i) bottom.push_back(i);
    shape.faces.push_back(std::move(bottom));
    if (family == Family::Pyramid) {
        shape.vertices.emplace_back(0.0, 0.0, kHeightMm);
        for (int i = 0; i < n; ++i) shape.faces.push_back({i, (i + 1) % n, n});
        return shape;
    }
    addRing(shape, n, family == Family::Frustum ? kRadiusMm * kTopShare : kRadiusMm, kHeightMm);
    std::vector<int> top;
    for (int i = 0; i < n; ++i) top.push_back(n + i);
    shape.faces.push_back(std::move(top));
    for (int i = 0; i < n; ++i) {
        const int j = (i + 1) % n;
        shape.faces.push_back({i, j, n + j, n + i});
    }
    return shape;
}

/// Does an edge run from the base to what is above it?
bool rises(const TemplateEdge& e, int corners) { return (e[0] < corners) != (e[1] < corners); }

}  // namespace

Template familyTemplate(Family family, int corners) {
    const int n = std::clamp(corners, kFewestCorners, kMostCorners);
    Template out;
    const char* word = family == Family::Prism     ? "Prism"
                       : family == Family::Pyramid ? "Pyramid"
                                                   : "Frustum";
    out.name = std::string(word) + " over " + std::to_string(n) + " corners";
    out.id = std::string(word) + "-" + std::to_string(n);
    out.id.front() = static_cast<char>(out.id.front() - 'A' + 'a');
    out.shape = shapeOf(family, n);
    for (const FoundRelation& found : findRelations(out.shape)) {
        const bool slanting = family != Family::Prism && rises(found.edges.front(), n);
        if (found.kind != RelationKind::EqualLength || slanting) {
            addRelation(out.relations, found);
        }
    }
    return out;
}

}  // namespace ew
