// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tlib/found_relations.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/tolerance.h"

namespace ew {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Edges of one direction, all pointing the same way.
struct DirectionClass {
    Vec3 direction;
    std::vector<TemplateEdge> edges;
};

Vec3 along(const PolyhedronSpec& shape, const TemplateEdge& e) {
    return shape.vertices[at(e[1])] - shape.vertices[at(e[0])];
}

std::vector<TemplateEdge> edgesOf(const PolyhedronSpec& shape) {
    std::vector<TemplateEdge> edges;
    std::set<TemplateEdge> seen;
    for (const std::vector<int>& loop : shape.faces) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const auto [a, b] = std::minmax(loop[i], loop[(i + 1) % loop.size()]);
            if (seen.insert({a, b}).second) edges.push_back({a, b});
        }
    }
    return edges;
}

std::vector<DirectionClass> directionClasses(const PolyhedronSpec& shape,
                                             const std::vector<TemplateEdge>& edges,
                                             double tolerance) {
    std::vector<DirectionClass> classes;
    for (const TemplateEdge& edge : edges) {
        const Vec3 d = along(shape, edge).normalized();
        const auto place = std::find_if(classes.begin(), classes.end(), [&](const auto& c) {
            return c.direction.cross(d).norm() <= tolerance;
        });
        if (place == classes.end()) {
            classes.push_back({d, {edge}});
        } else {
            const bool sameSense = place->direction.dot(d) > 0;
            place->edges.push_back(sameSense ? edge : TemplateEdge{edge[1], edge[0]});
        }
    }
    return classes;
}

bool meet(const TemplateEdge& a, const TemplateEdge& b) {
    return a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1];
}

/// A pair of edges of the two classes that share a vertex; empty where there is none.
std::vector<TemplateEdge> meetingPair(const DirectionClass& a, const DirectionClass& b) {
    for (const TemplateEdge& ea : a.edges) {
        for (const TemplateEdge& eb : b.edges) {
            if (meet(ea, eb)) return {ea, eb};
        }
    }
    return {};
}

void addEqualLengths(const PolyhedronSpec& shape, const std::vector<TemplateEdge>& edges,
                     double tolerance, std::vector<FoundRelation>& out) {
    Eigen::AlignedBox3d box;
    for (const Vec3& v : shape.vertices) box.extend(v);
    const double slack = tolerance * box.diagonal().norm();
    std::vector<std::pair<double, std::vector<TemplateEdge>>> classes;
    for (const TemplateEdge& edge : edges) {
        const double length = along(shape, edge).norm();
        const auto place = std::find_if(classes.begin(), classes.end(), [&](const auto& c) {
            return std::abs(c.first - length) <= slack;
        });
        if (place == classes.end()) {
            classes.push_back({length, {edge}});
        } else {
            place->second.push_back(edge);
        }
    }
    for (auto& [length, group] : classes) {
        if (group.size() >= 2) out.push_back({RelationKind::EqualLength, std::move(group)});
    }
}

}  // namespace

std::vector<FoundRelation> findRelations(const PolyhedronSpec& shape) {
    return findRelations(shape, tol::kSolidDirection);
}

std::vector<FoundRelation> findRelations(const PolyhedronSpec& shape, double tolerance) {
    std::vector<FoundRelation> out;
    const std::vector<TemplateEdge> edges = edgesOf(shape);
    const std::vector<DirectionClass> classes = directionClasses(shape, edges, tolerance);
    for (const DirectionClass& c : classes) {
        if (c.edges.size() >= 2) out.push_back({RelationKind::Parallel, c.edges});
    }
    for (std::size_t i = 0; i < classes.size(); ++i) {
        for (std::size_t j = i + 1; j < classes.size(); ++j) {
            const double cosine = classes[i].direction.dot(classes[j].direction);
            if (std::abs(cosine) > tolerance) continue;
            std::vector<TemplateEdge> pair = meetingPair(classes[i], classes[j]);
            if (!pair.empty()) out.push_back({RelationKind::Perpendicular, std::move(pair)});
        }
    }
    addEqualLengths(shape, edges, tolerance, out);
    return out;
}

bool relationHolds(const PolyhedronSpec& shape, const FoundRelation& relation) {
    Eigen::AlignedBox3d box;
    for (const Vec3& v : shape.vertices) box.extend(v);
    const double slack = tol::kTemplateRelation * box.diagonal().norm();
    const Vec3 a = along(shape, relation.edges.front());
    return std::all_of(relation.edges.begin() + 1, relation.edges.end(), [&](const auto& edge) {
        const Vec3 b = along(shape, edge);
        if (!(a.norm() > 0.0 && b.norm() > 0.0)) return false;
        const Vec3 u = a.normalized();
        const Vec3 v = b.normalized();
        switch (relation.kind) {
            case RelationKind::Parallel:
                return u.cross(v).norm() <= tol::kTemplateRelation && u.dot(v) > 0.0;
            case RelationKind::Perpendicular:
                return std::abs(u.dot(v)) <= tol::kTemplateRelation;
            case RelationKind::EqualLength:
                break;
        }
        return std::abs(a.norm() - b.norm()) <= slack;
    });
}

std::vector<FoundRelation> listRelations(const TemplateRelations& relations) {
    std::vector<FoundRelation> out;
    for (const auto& group : relations.parallel) out.push_back({RelationKind::Parallel, group});
    for (const auto& pair : relations.perpendicular) {
        out.push_back({RelationKind::Perpendicular, {pair[0], pair[1]}});
    }
    for (const auto& group : relations.equalLength) {
        out.push_back({RelationKind::EqualLength, group});
    }
    return out;
}

void addRelation(TemplateRelations& relations, const FoundRelation& relation) {
    switch (relation.kind) {
        case RelationKind::Parallel:
            relations.parallel.push_back(relation.edges);
            break;
        case RelationKind::Perpendicular:
            relations.perpendicular.push_back({relation.edges[0], relation.edges[1]});
            break;
        case RelationKind::EqualLength:
            relations.equalLength.push_back(relation.edges);
            break;
    }
}

bool sameRelation(const FoundRelation& a, const FoundRelation& b) {
    if (a.kind != b.kind || a.edges.size() != b.edges.size()) return false;
    const auto unordered = [](const FoundRelation& r) {
        std::set<TemplateEdge> edges;
        for (const TemplateEdge& e : r.edges) {
            edges.insert({std::min(e[0], e[1]), std::max(e[0], e[1])});
        }
        return edges;
    };
    return unordered(a) == unordered(b);
}

}  // namespace ew
