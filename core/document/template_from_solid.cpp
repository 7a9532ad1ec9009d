// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/template_from_solid.h"

#include <utility>

#include "core/tlib/found_relations.h"

namespace ew {

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
    for (const FoundRelation& found : findRelations(tmpl.shape)) {
        if (found.kind != RelationKind::EqualLength) addRelation(tmpl.relations, found);
    }
    return tmpl;
}

}  // namespace ew
