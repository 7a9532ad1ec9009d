// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tlib/analysis.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class UnionFind {
  public:
    explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
    int find(int i) {
        while (parent_[at(i)] != i) i = parent_[at(i)] = parent_[at(parent_[at(i)])];
        return i;
    }
    void unite(int a, int b) { parent_[at(find(a))] = find(b); }

  private:
    std::vector<int> parent_;
};

void collectEdges(const Template& tmpl, TemplateAnalysis& out) {
    std::map<std::pair<int, int>, int> known;
    for (std::size_t f = 0; f < tmpl.shape.faces.size(); ++f) {
        const auto& loop = tmpl.shape.faces[f];
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const int a = loop[i];
            const int b = loop[(i + 1) % loop.size()];
            const auto key = std::minmax(a, b);
            auto [it, added] = known.emplace(key, static_cast<int>(out.edges.size()));
            if (added) out.edges.push_back({{key.first, key.second}, {-1, -1}, -1, 1.0});
            out.edges[at(it->second)].faces[a < b ? 0 : 1] = static_cast<int>(f);
        }
    }
}

void collectClasses(const Template& tmpl, TemplateAnalysis& out) {
    UnionFind sets(out.edges.size());
    for (const auto& group : tmpl.relations.parallel) {
        const int first = out.edgeBetween(group[0][0], group[0][1]);
        for (const TemplateEdge& e : group) sets.unite(out.edgeBetween(e[0], e[1]), first);
    }
    std::map<int, int> number;
    std::vector<Vec3> direction;
    for (std::size_t e = 0; e < out.edges.size(); ++e) {
        AnalysedEdge& edge = out.edges[e];
        const int root = sets.find(static_cast<int>(e));
        const Vec3 d =
            tmpl.shape.vertices[at(edge.ends[1])] - tmpl.shape.vertices[at(edge.ends[0])];
        const auto [it, added] = number.emplace(root, out.classCount);
        if (added) {
            ++out.classCount;
            direction.push_back(d);
        }
        edge.directionClass = it->second;
        edge.sense = d.dot(direction[at(it->second)]) >= 0 ? 1.0 : -1.0;
    }
    for (const auto& pair : tmpl.relations.perpendicular) {
        const int a = out.edges[at(out.edgeBetween(pair[0][0], pair[0][1]))].directionClass;
        const int b = out.edges[at(out.edgeBetween(pair[1][0], pair[1][1]))].directionClass;
        out.perpendicularClasses.push_back({std::min(a, b), std::max(a, b)});
    }
    auto& pc = out.perpendicularClasses;
    std::sort(pc.begin(), pc.end());
    pc.erase(std::unique(pc.begin(), pc.end()), pc.end());
    for (const auto& group : tmpl.relations.equalLength) {
        std::vector<int> edges;
        for (const TemplateEdge& e : group) edges.push_back(out.edgeBetween(e[0], e[1]));
        out.equalLength.push_back(std::move(edges));
    }
}

Vec3 newellNormal(const PolyhedronSpec& shape, const std::vector<int>& loop) {
    Vec3 n = Vec3::Zero();
    for (std::size_t i = 0; i < loop.size(); ++i) {
        n += shape.vertices[at(loop[i])].cross(shape.vertices[at(loop[(i + 1) % loop.size()])]);
    }
    return n.normalized();
}

bool isConvex(const Template& tmpl, const std::vector<Vec3>& normals) {
    for (std::size_t f = 0; f < normals.size(); ++f) {
        const Vec3& p = tmpl.shape.vertices[at(tmpl.shape.faces[f][0])];
        for (const Vec3& v : tmpl.shape.vertices) {
            if (normals[f].dot(v - p) > 1e-7 * (1.0 + v.norm())) return false;
        }
    }
    return true;
}

std::optional<RectilinearStructure> findRectilinear(const Template& tmpl,
                                                    const TemplateAnalysis& a) {
    if (a.classCount != 3 || a.perpendicularClasses.size() != 3 || !a.equalLength.empty()) {
        return std::nullopt;
    }
    RectilinearStructure r;
    for (int axis = 0; axis < 3; ++axis) {
        r.axisClass[at(axis)] = axis;
        // Vertices joined by edges of the other two directions share the plane.
        UnionFind sets(tmpl.shape.vertices.size());
        Vec3 direction = Vec3::Zero();
        for (const AnalysedEdge& e : a.edges) {
            if (e.directionClass != axis) {
                sets.unite(e.ends[0], e.ends[1]);
            } else if (direction.isZero()) {
                direction = e.sense * (tmpl.shape.vertices[at(e.ends[1])] -
                                       tmpl.shape.vertices[at(e.ends[0])])
                                          .normalized();
            }
        }
        std::map<int, int> number;
        for (std::size_t v = 0; v < tmpl.shape.vertices.size(); ++v) {
            const auto [it, added] =
                number.emplace(sets.find(static_cast<int>(v)), static_cast<int>(number.size()));
            if (added) r.reference[at(axis)].push_back(direction.dot(tmpl.shape.vertices[v]));
            r.planes[at(axis)].push_back(it->second);
        }
        r.planeCount[at(axis)] = static_cast<int>(number.size());
    }
    return r;
}

}  // namespace

int TemplateAnalysis::edgeBetween(int a, int b) const {
    const auto key = std::minmax(a, b);
    for (std::size_t e = 0; e < edges.size(); ++e) {
        if (edges[e].ends[0] == key.first && edges[e].ends[1] == key.second) {
            return static_cast<int>(e);
        }
    }
    return -1;
}

TemplateAnalysis analyse(const Template& tmpl) {
    TemplateAnalysis out;
    collectEdges(tmpl, out);
    collectClasses(tmpl, out);
    for (const auto& loop : tmpl.shape.faces) {
        out.faceNormals.push_back(newellNormal(tmpl.shape, loop));
    }
    out.convex = isConvex(tmpl, out.faceNormals);
    out.rectilinear = findRectilinear(tmpl, out);
    return out;
}

}  // namespace ew
