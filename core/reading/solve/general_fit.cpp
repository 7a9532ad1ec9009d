// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/general_fit.h"

#include "core/reading/solve/general_solver.h"

namespace ew {

using general::at;
using general::Solver;

SolverRelations solverRelations(const TemplateAnalysis& analysis) {
    SolverRelations r;
    std::vector<std::vector<int>> classes(at(analysis.classCount));
    for (std::size_t e = 0; e < analysis.edges.size(); ++e) {
        classes[at(analysis.edges[e].directionClass)].push_back(static_cast<int>(e));
    }
    for (const auto& c : classes) {
        if (c.size() > 1) r.parallel.push_back(c);
    }
    for (const auto& pair : analysis.perpendicularClasses) {
        r.perpendicular.push_back({classes[at(pair[0])].front(), classes[at(pair[1])].front()});
    }
    r.equalLength = analysis.equalLength;
    return r;
}

void addReading(SolverRelations& relations, const TemplateAnalysis& analysis,
                const TemplateRelations& reading, const std::vector<int>& symmetry) {
    auto edge = [&](const TemplateEdge& e) {
        return analysis.edgeBetween(symmetry[at(e[0])], symmetry[at(e[1])]);
    };
    auto group = [&](const std::vector<TemplateEdge>& edges) {
        std::vector<int> out;
        for (const TemplateEdge& e : edges) out.push_back(edge(e));
        return out;
    };
    for (const auto& g : reading.parallel) relations.parallel.push_back(group(g));
    for (const auto& p : reading.perpendicular) {
        relations.perpendicular.push_back({edge(p[0]), edge(p[1])});
    }
    for (const auto& g : reading.equalLength) relations.equalLength.push_back(group(g));
}

double violation(const SolverRelations& relations, const TemplateAnalysis& analysis,
                 const CameraPoints& points) {
    const auto edge = [&](int e) {
        const auto& ends = analysis.edges[at(e)].ends;
        return Vec3(points[at(ends[1])] - points[at(ends[0])]);
    };
    double sum = 0;
    for (const auto& pair : relations.perpendicular) {
        sum += std::pow(edge(pair[0]).normalized().dot(edge(pair[1]).normalized()), 2);
    }
    for (const auto& group : relations.parallel) {
        for (const int e : group) {
            sum += edge(group.front()).normalized().cross(edge(e).normalized()).squaredNorm();
        }
    }
    for (const auto& group : relations.equalLength) {
        const double first = std::max(edge(group.front()).norm(), 1e-9);
        for (const int e : group) sum += std::pow(edge(e).norm() / first - 1.0, 2);
    }
    return sum;
}

int templateFreedoms(const Template& tmpl, const TemplateAnalysis& analysis) {
    const SolverRelations relations = solverRelations(analysis);
    const Sighting nothing;
    return Solver(tmpl, analysis, nothing, relations).freedoms();
}

double Anchors::depth() const {
    double sum = 0;
    double count = 0;
    for (const Plane& p : planes) {
        sum +=
            std::abs(p.normal.z()) > 1e-6
                ? (p.offset - p.normal.x() * p.near.x() - p.normal.y() * p.near.y()) / p.normal.z()
                : p.normal.z() * p.offset;
        count += 1;
    }
    for (const Point& p : points) {
        sum += p.point.z();
        count += 1;
    }
    return count > 0 ? sum / count : 0.0;
}

std::optional<GeneralSolution> solveAnchored(const Template& tmpl, const TemplateAnalysis& analysis,
                                             const Sighting& sighting,
                                             const SolverRelations& relations,
                                             const Anchors& anchors, const CameraPoints& start) {
    return Solver(tmpl, analysis, sighting, relations, &anchors).runAnchored(start);
}

std::optional<GeneralSolution> solveGeneral(const Template& tmpl, const TemplateAnalysis& analysis,
                                            const Sighting& sighting,
                                            const SolverRelations& relations,
                                            const CameraPoints& start) {
    return Solver(tmpl, analysis, sighting, relations).run(start);
}

}  // namespace ew
