// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/reading/evidence/sighting.h"

namespace ew {

/// What the general solver found.
struct GeneralSolution {
    CameraPoints points;  ///< every template vertex, hidden ones included
    double cost = 0.0;    ///< weighted squared residual of the ink plus regularity
    int freedoms = 0;     ///< degrees of freedom that drawing and relations leave open; they were
                          ///< closed by regularity
    int parameters = 0;   ///< degrees of freedom of the template's picture (depth excluded)
    double constraint = 0.0;  ///< largest violated relation, relative to the size
};

/// Relations as edge indices, ready for the solver.
struct SolverRelations {
    std::vector<std::vector<int>> parallel;
    std::vector<std::array<int, 2>> perpendicular;
    std::vector<std::vector<int>> equalLength;
};
SolverRelations solverRelations(const TemplateAnalysis& analysis);

/// Adds a reading's relations, vertices renamed by one of the template's symmetries.
void addReading(SolverRelations& relations, const TemplateAnalysis& analysis,
                const TemplateRelations& reading, const std::vector<int>& symmetry);

/// How far a body is from holding relations: sum of squared cosines of what should be
/// perpendicular, squared sines of what should be parallel and squared relative differences of what
/// should be equally long. 0 where they hold.
double violation(const SolverRelations& relations, const TemplateAnalysis& analysis,
                 const CameraPoints& points);

/// Degrees of freedom that a template's relations leave (position and attitude included, depth
/// not): a lower bound of what a candidate of it costs.
int templateFreedoms(const Template& tmpl, const TemplateAnalysis& analysis);

/// What is known of a template that is drawn on a solid, in camera space [px].
struct Anchors {
    struct Plane {
        int vertex;
        Vec3 normal;    ///< unit
        double offset;  ///< normal . vertex = offset
        Vec2 near;      ///< where the vertex was drawn
    };
    struct Line {
        int vertex;
        Vec3 point;
        Vec3 direction;  ///< unit
    };
    struct Point {
        int vertex;
        Vec3 point;
    };
    struct Direction {
        int edge;        ///< TemplateAnalysis::edges
        Vec3 direction;  ///< unit
    };
    /// The apex of a triangle lies over the middle of its base.
    struct Median {
        int apex;
        std::array<int, 2> base;
        Vec3 direction;  ///< from the middle of the base to the apex, unit, either way
    };
    std::vector<Plane> planes;
    std::vector<Line> lines;
    std::vector<Point> points;
    std::vector<Direction> directions;
    std::vector<Median> medians;  ///< for solveLinearly() only

    double depth() const;  ///< about where it all is [px]
};

/// As solveGeneral, with anchors that hold exactly; depth is told by them. Nothing where anchors
/// and relations contradict each other.
std::optional<GeneralSolution> solveAnchored(const Template& tmpl, const TemplateAnalysis& analysis,
                                             const Sighting& sighting,
                                             const SolverRelations& relations,
                                             const Anchors& anchors, const CameraPoints& start);

/// Reconstructs any template from one parallel projection: sequential quadratic programming over
/// all vertex positions in camera space. Parallel, perpendicular and equal-length relations and
/// planarity of the faces are equality constraints (null-space method, rank-revealing, so redundant
/// relations do no harm); the line ends of the drawing are the least-squares objective; the
/// difference of the faces' angles to the reference shape is a weak second objective that closes
/// what is left open with the most regular shape.
/// \param start  vertices to start from, e.g. from startPoints or another solution.
/// \return nothing where it does not converge or the visible faces do not come out visible.
/// \paper{5.1}
std::optional<GeneralSolution> solveGeneral(const Template& tmpl, const TemplateAnalysis& analysis,
                                            const Sighting& sighting,
                                            const SolverRelations& relations,
                                            const CameraPoints& start);

}  // namespace ew
