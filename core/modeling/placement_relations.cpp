// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/modeling/placement_relations.h"

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

}  // namespace

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
