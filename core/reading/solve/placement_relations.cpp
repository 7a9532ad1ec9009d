// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/placement_relations.h"

#include <algorithm>
#include <cmath>

#include "core/base/tolerance.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::vector<std::vector<int>> equalInReference(const Template& tmpl,
                                               const TemplateAnalysis& analysis) {
    std::vector<std::vector<int>> groups;
    std::vector<double> lengths;
    for (std::size_t e = 0; e < analysis.edges.size(); ++e) {
        const auto& ends = analysis.edges[e].ends;
        const double len =
            (tmpl.shape.vertices[at(ends[1])] - tmpl.shape.vertices[at(ends[0])]).norm();
        std::size_t g = 0;
        while (g < groups.size() && std::abs(len - lengths[g]) > tol::kEqualCoordinate * len) ++g;
        if (g == groups.size()) {
            groups.emplace_back();
            lengths.push_back(len);
        }
        groups[g].push_back(static_cast<int>(e));
    }
    return groups;
}

/// Is the side of a triangle perpendicular to the edges that lead on from it in a face, by the
/// template's relations?
bool standsAcross(const TemplateAnalysis& analysis, const std::vector<int>& face, int a, int b) {
    const int side = analysis.edges[at(analysis.edgeBetween(a, b))].directionClass;
    const std::size_t n = face.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::array<int, 2> ends{face[i], face[(i + 1) % n]};
        const bool onward = (ends[0] == a || ends[0] == b) != (ends[1] == a || ends[1] == b);
        if (!onward) continue;
        const int c = analysis.edges[at(analysis.edgeBetween(ends[0], ends[1]))].directionClass;
        const auto& known = analysis.perpendicularClasses;
        if (std::none_of(known.begin(), known.end(), [&](const std::array<int, 2>& p) {
                return (p[0] == side && p[1] == c) || (p[0] == c && p[1] == side);
            })) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::vector<Ridge> ridgesOf(const Template& tmpl, const TemplateAnalysis& analysis,
                            const FacePairs& pairs) {
    std::vector<Ridge> ridges;
    for (const auto& [t, solidFace] : pairs) {
        const auto& face = tmpl.shape.faces[at(t)];
        const auto in = [&](int v) { return std::find(face.begin(), face.end(), v) != face.end(); };
        if (face.size() != 4) continue;
        for (const auto& loop : tmpl.shape.faces) {
            if (loop.size() != 3) continue;
            for (std::size_t i = 0; i < 3; ++i) {
                const int a = loop[(i + 1) % 3];
                const int b = loop[(i + 2) % 3];
                if (in(loop[i]) || !in(a) || !in(b) || !standsAcross(analysis, face, a, b)) {
                    continue;
                }
                ridges.push_back({loop[i], {a, b}, solidFace});
            }
        }
    }
    return ridges;
}

bool slopesAreFree(const std::vector<Ridge>& ridges, const TemplateAnalysis& analysis,
                   const DirectionAssignment& directions) {
    return std::all_of(ridges.begin(), ridges.end(), [&](const Ridge& r) {
        return std::none_of(r.base.begin(), r.base.end(), [&](int v) {
            const int e = analysis.edgeBetween(r.apex, v);
            return directions.byClass[at(analysis.edges[at(e)].directionClass)].has_value();
        });
    });
}

SolverRelations keptRelations(const Template& tmpl, const TemplateAnalysis& analysis,
                              const DirectionAssignment& directions, const KeptRelations& keep) {
    const SolverRelations all = solverRelations(analysis);
    const auto given = [&](int e) {
        return directions.byClass[at(analysis.edges[at(e)].directionClass)].has_value();
    };
    SolverRelations r;
    if (keep.parallel) {
        for (const auto& group : all.parallel) {
            if (!given(group.front())) r.parallel.push_back(group);
        }
    }
    r.equalLength = keep.regular ? equalInReference(tmpl, analysis) : all.equalLength;
    if (!keep.perpendicular) return r;
    for (const auto& pair : all.perpendicular) {
        // What the model says of two directions stands above the template.
        if (!given(pair[0]) || !given(pair[1])) r.perpendicular.push_back(pair);
    }
    return r;
}

}  // namespace ew
