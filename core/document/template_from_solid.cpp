// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/template_from_solid.h"

#include <cmath>
#include <set>
#include <utility>

#include "core/base/tolerance.h"

namespace ew {

namespace {

/// Edges of one direction, all pointing the same way.
struct DirectionClass {
    Vec3 direction;
    std::vector<TemplateEdge> edges;
};

std::vector<DirectionClass> directionClasses(const Solid& solid) {
    std::vector<DirectionClass> classes;
    const auto& vertices = solid.vertices();
    for (const SolidEdge& edge : solid.edges()) {
        const auto [a, b] = edge.ends;
        const Vec3 d =
            (vertices[static_cast<std::size_t>(b)] - vertices[static_cast<std::size_t>(a)])
                .normalized();
        bool placed = false;
        for (DirectionClass& c : classes) {
            if (c.direction.cross(d).norm() > tol::kSolidDirection) continue;
            const bool sameSense = c.direction.dot(d) > 0;
            c.edges.push_back(sameSense ? TemplateEdge{a, b} : TemplateEdge{b, a});
            placed = true;
            break;
        }
        if (!placed) classes.push_back({d, {{a, b}}});
    }
    return classes;
}

bool meet(const TemplateEdge& a, const TemplateEdge& b) {
    return a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1];
}

/// A pair of edges of the two classes that share a vertex, if there is one.
bool findMeeting(const DirectionClass& a, const DirectionClass& b,
                 std::array<TemplateEdge, 2>& pair) {
    for (const TemplateEdge& ea : a.edges) {
        for (const TemplateEdge& eb : b.edges) {
            if (!meet(ea, eb)) continue;
            pair = {ea, eb};
            return true;
        }
    }
    return false;
}

TemplateRelations relationsOf(const Solid& solid) {
    TemplateRelations relations;
    const std::vector<DirectionClass> classes = directionClasses(solid);
    for (std::size_t i = 0; i < classes.size(); ++i) {
        if (classes[i].edges.size() >= 2) relations.parallel.push_back(classes[i].edges);
        for (std::size_t j = i + 1; j < classes.size(); ++j) {
            if (std::abs(classes[i].direction.dot(classes[j].direction)) > tol::kSolidDirection) {
                continue;
            }
            std::array<TemplateEdge, 2> pair;
            if (findMeeting(classes[i], classes[j], pair)) relations.perpendicular.push_back(pair);
        }
    }
    return relations;
}

}  // namespace

Result<Template> templateFromBodies(const std::vector<Body>& bodies, const std::string& id,
                                    const std::string& name) {
    if (bodies.empty()) return fail(Errc::NoSolid, "There is no solid to make a template from.");
    if (bodies.size() > 1) {
        return fail(Errc::BadTemplate, "A template is made from one solid; there are " +
                                           std::to_string(bodies.size()) + ".");
    }
    const Solid& solid = bodies.front().solid;
    Template tmpl;
    tmpl.id = id;
    tmpl.name = name;
    tmpl.shape.vertices = solid.vertices();
    for (const SolidFace& face : solid.faces()) {
        if (face.loops.size() != 1) {
            return fail(Errc::BadTemplate, "A template's faces have no holes; this solid's have.");
        }
        tmpl.shape.faces.push_back(face.loops.front());
    }
    tmpl.relations = relationsOf(solid);
    return tmpl;
}

}  // namespace ew
