// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/modeling/sighting.h"

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

/// Degrees of freedom that a template's relations leave (position and attitude included, depth
/// not): a lower bound of what a candidate of it costs.
int templateFreedoms(const Template& tmpl, const TemplateAnalysis& analysis);

/// Reconstructs any template from one parallel projection: sequential quadratic programming over
/// all vertex positions in camera space. Parallel, perpendicular and equal-length relations and
/// planarity of the faces are equality constraints (null-space method, rank-revealing, so redundant
/// relations do no harm); the line ends of the drawing are the least-squares objective; the
/// difference of the faces' angles to the reference shape is a weak second objective that closes
/// what is left open with the most regular shape. \param start  vertices to start from, e.g. from
/// startPoints or another solution. \return nothing where it does not converge or the visible faces
/// do not come out visible.
std::optional<GeneralSolution> solveGeneral(const Template& tmpl, const TemplateAnalysis& analysis,
                                            const Sighting& sighting,
                                            const SolverRelations& relations,
                                            const CameraPoints& start);

}  // namespace ew
