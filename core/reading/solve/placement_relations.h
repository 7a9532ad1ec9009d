// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <set>
#include <vector>

#include "core/reading/solve/general_fit.h"
#include "core/reading/solve/placement_directions.h"

namespace ew {

/// What a placement takes for granted of the template's own relations and of the drawing.
struct KeptRelations {
    bool perpendicular = true;
    bool parallel = true;
    std::set<int> loose = {};  ///< template vertices that are near places of the model by chance
    bool regular = false;      ///< edges as long as each other in the reference shape are so
    bool overrule = false;     ///< the ink need not fit
    bool symmetric = false;    ///< what Ridge says is so
};

/// A triangle across a prism that lies with one side in a face of the solid: grooves and roofs are
/// mostly as steep on one side as on the other.
struct Ridge {
    int apex = -1;
    std::array<int, 2> base{};  ///< the side's ends
    int face = -1;              ///< of the solid
};
std::vector<Ridge> ridgesOf(const Template& tmpl, const TemplateAnalysis& analysis,
                            const FacePairs& pairs);
/// Does the solver have both slopes of every ridge to find?
bool slopesAreFree(const std::vector<Ridge>& ridges, const TemplateAnalysis& analysis,
                   const DirectionAssignment& directions);

/// Those relations for the solver, without what the given directions settle.
SolverRelations keptRelations(const Template& tmpl, const TemplateAnalysis& analysis,
                              const DirectionAssignment& directions, const KeptRelations& keep);

}  // namespace ew
