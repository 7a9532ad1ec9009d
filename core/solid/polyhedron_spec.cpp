// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/polyhedron_spec.h"

#include <cstddef>

#include "core/base/disjoint_sets.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

std::vector<PolyhedronSpec> separateBodies(const PolyhedronSpec& spec) {
    DisjointSets joined(spec.vertices.size());
    for (const std::vector<int>& face : spec.faces) {
        for (const int v : face) joined.join(v, face.front());
    }
    std::vector<int> bodyOf(spec.vertices.size(), -1);
    std::vector<PolyhedronSpec> bodies;
    for (const std::vector<int>& face : spec.faces) {
        int& body = bodyOf[at(joined.root(face.front()))];
        if (body < 0) {
            body = static_cast<int>(bodies.size());
            bodies.emplace_back();
        }
        bodies[at(body)].faces.push_back(face);
    }
    std::vector<int> number(spec.vertices.size(), -1);
    for (std::size_t v = 0; v < spec.vertices.size(); ++v) {
        const int body = bodyOf[at(joined.root(static_cast<int>(v)))];
        if (body < 0) continue;
        number[v] = static_cast<int>(bodies[at(body)].vertices.size());
        bodies[at(body)].vertices.push_back(spec.vertices[v]);
    }
    for (PolyhedronSpec& body : bodies) {
        for (std::vector<int>& face : body.faces) {
            for (int& v : face) v = number[at(v)];
        }
    }
    return bodies;
}

}  // namespace ew
