// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tlib/symmetry.h"

#include <algorithm>
#include <array>
#include <set>

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Flags (vertex, edge, face) with the three moves that change one of them. An automorphism is
/// fixed by the image of one flag.
struct Flags {
    std::vector<int> vertex;
    std::vector<std::array<int, 3>> move;

    Flags(const Template& tmpl, const TemplateAnalysis& analysis) {
        // Flag 4e + 2f + s: edge e, its face f, its end s.
        const std::size_t n = analysis.edges.size();
        vertex.resize(4 * n);
        move.assign(4 * n, {-1, -1, -1});
        for (std::size_t e = 0; e < n; ++e) {
            for (std::size_t f = 0; f < 2; ++f) {
                for (std::size_t s = 0; s < 2; ++s) {
                    const std::size_t flag = 4 * e + 2 * f + s;
                    vertex[flag] = analysis.edges[e].ends[s];
                    move[flag][0] = static_cast<int>(4 * e + 2 * f + (1 - s));
                    move[flag][2] = static_cast<int>(4 * e + 2 * (1 - f) + s);
                    move[flag][1] = neighbour(tmpl, analysis, e, f, s);
                }
            }
        }
    }

  private:
    /// The flag with the other edge of the same face at the same vertex.
    static int neighbour(const Template& tmpl, const TemplateAnalysis& analysis, std::size_t e,
                         std::size_t f, std::size_t s) {
        const int face = analysis.edges[e].faces[f];
        const int v = analysis.edges[e].ends[s];
        const int far = analysis.edges[e].ends[1 - s];
        const auto& loop = tmpl.shape.faces[at(face)];
        const std::size_t i =
            static_cast<std::size_t>(std::find(loop.begin(), loop.end(), v) - loop.begin());
        const int before = loop[(i + loop.size() - 1) % loop.size()];
        const int after = loop[(i + 1) % loop.size()];
        const int other = analysis.edgeBetween(v, before == far ? after : before);
        const auto& o = analysis.edges[at(other)];
        const std::size_t side = o.faces[0] == face ? 0 : 1;
        const std::size_t end = o.ends[0] == v ? 0 : 1;
        return static_cast<int>(4 * at(other) + 2 * side + end);
    }
};

/// Does a map of the vertices of `a` to those of `b` keep edges and relations?
bool keepsRelations(const TemplateAnalysis& a, const TemplateAnalysis& b,
                    const std::vector<int>& map) {
    std::vector<int> classMap(at(a.classCount), -1);
    std::vector<int> edgeMap;
    for (const AnalysedEdge& e : a.edges) {
        const int image = b.edgeBetween(map[at(e.ends[0])], map[at(e.ends[1])]);
        if (image < 0) return false;
        edgeMap.push_back(image);
        int& c = classMap[at(e.directionClass)];
        const int target = b.edges[at(image)].directionClass;
        if (c >= 0 && c != target) return false;
        c = target;
    }
    std::set<int> distinct(classMap.begin(), classMap.end());
    if (distinct.size() != classMap.size()) return false;
    const auto& pairs = b.perpendicularClasses;
    for (const auto& p : a.perpendicularClasses) {
        const auto m = std::minmax(classMap[at(p[0])], classMap[at(p[1])]);
        if (!std::binary_search(pairs.begin(), pairs.end(),
                                std::array<int, 2>{m.first, m.second})) {
            return false;
        }
    }
    std::set<std::set<int>> groups;
    for (const auto& g : b.equalLength) groups.insert({g.begin(), g.end()});
    for (const auto& g : a.equalLength) {
        std::set<int> image;
        for (const int e : g) image.insert(edgeMap[at(e)]);
        if (!groups.contains(image)) return false;
    }
    return true;
}

/// The map of vertices that takes the first flag of `a` to a flag of `b`; empty where there is
/// none.
std::vector<int> mapFrom(const Flags& a, const Flags& b, std::size_t vertexCount, int seed) {
    std::vector<int> image(a.vertex.size(), -1);
    std::vector<int> map(vertexCount, -1);
    std::vector<int> stack{0};
    image[0] = seed;
    while (!stack.empty()) {
        const int flag = stack.back();
        stack.pop_back();
        int& v = map[at(a.vertex[at(flag)])];
        const int w = b.vertex[at(image[at(flag)])];
        if (v >= 0 && v != w) return {};
        v = w;
        for (std::size_t m = 0; m < 3; ++m) {
            const int to = a.move[at(flag)][m];
            const int target = b.move[at(image[at(flag)])][m];
            if (image[at(to)] < 0) {
                image[at(to)] = target;
                stack.push_back(to);
            } else if (image[at(to)] != target) {
                return {};
            }
        }
    }
    return map;
}

}  // namespace

std::vector<std::vector<int>> symmetries(const Template& tmpl, const TemplateAnalysis& analysis) {
    const Flags flags(tmpl, analysis);
    std::vector<std::vector<int>> result;
    for (std::size_t seed = 0; seed < flags.vertex.size(); ++seed) {
        std::vector<int> map =
            mapFrom(flags, flags, tmpl.shape.vertices.size(), static_cast<int>(seed));
        if (!map.empty() && keepsRelations(analysis, analysis, map)) {
            result.push_back(std::move(map));
        }
    }
    return result;
}

bool areSame(const Template& a, const TemplateAnalysis& aKnown, const Template& b,
             const TemplateAnalysis& bKnown) {
    if (a.shape.vertices.size() != b.shape.vertices.size() ||
        a.shape.faces.size() != b.shape.faces.size() ||
        aKnown.edges.size() != bKnown.edges.size() || aKnown.classCount != bKnown.classCount ||
        aKnown.perpendicularClasses.size() != bKnown.perpendicularClasses.size() ||
        aKnown.equalLength.size() != bKnown.equalLength.size()) {
        return false;
    }
    const Flags from(a, aKnown);
    const Flags to(b, bKnown);
    for (std::size_t seed = 0; seed < to.vertex.size(); ++seed) {
        const std::vector<int> map =
            mapFrom(from, to, a.shape.vertices.size(), static_cast<int>(seed));
        if (!map.empty() && keepsRelations(aKnown, bKnown, map)) return true;
    }
    return false;
}

}  // namespace ew
