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

bool keepsRelations(const TemplateAnalysis& analysis, const std::vector<int>& map) {
    std::vector<int> classMap(at(analysis.classCount), -1);
    std::vector<int> edgeMap;
    for (const AnalysedEdge& e : analysis.edges) {
        const int image = analysis.edgeBetween(map[at(e.ends[0])], map[at(e.ends[1])]);
        if (image < 0) return false;
        edgeMap.push_back(image);
        int& c = classMap[at(e.directionClass)];
        const int target = analysis.edges[at(image)].directionClass;
        if (c >= 0 && c != target) return false;
        c = target;
    }
    std::set<int> distinct(classMap.begin(), classMap.end());
    if (distinct.size() != classMap.size()) return false;
    const auto& pairs = analysis.perpendicularClasses;
    for (const auto& p : pairs) {
        const auto m = std::minmax(classMap[at(p[0])], classMap[at(p[1])]);
        if (!std::binary_search(pairs.begin(), pairs.end(),
                                std::array<int, 2>{m.first, m.second})) {
            return false;
        }
    }
    std::set<std::set<int>> groups;
    for (const auto& g : analysis.equalLength) groups.insert({g.begin(), g.end()});
    for (const auto& g : analysis.equalLength) {
        std::set<int> image;
        for (const int e : g) image.insert(edgeMap[at(e)]);
        if (!groups.contains(image)) return false;
    }
    return true;
}

}  // namespace

std::vector<std::vector<int>> symmetries(const Template& tmpl, const TemplateAnalysis& analysis) {
    const Flags flags(tmpl, analysis);
    std::vector<std::vector<int>> result;
    for (std::size_t seed = 0; seed < flags.vertex.size(); ++seed) {
        std::vector<int> image(flags.vertex.size(), -1);
        std::vector<int> map(tmpl.shape.vertices.size(), -1);
        std::vector<int> stack{0};
        image[0] = static_cast<int>(seed);
        bool consistent = true;
        while (!stack.empty() && consistent) {
            const int flag = stack.back();
            stack.pop_back();
            int& v = map[at(flags.vertex[at(flag)])];
            const int w = flags.vertex[at(image[at(flag)])];
            consistent = v < 0 || v == w;
            v = w;
            for (std::size_t m = 0; m < 3 && consistent; ++m) {
                const int to = flags.move[at(flag)][m];
                const int target = flags.move[at(image[at(flag)])][m];
                if (image[at(to)] < 0) {
                    image[at(to)] = target;
                    stack.push_back(to);
                } else {
                    consistent = image[at(to)] == target;
                }
            }
        }
        if (consistent && keepsRelations(analysis, map)) result.push_back(std::move(map));
    }
    return result;
}

}  // namespace ew
