// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>

#include "core/modeling/general_fit.h"
#include "core/modeling/placement_directions.h"

namespace ew {

/// What a placement takes for granted of the template's own relations and of the drawing.
struct KeptRelations {
    bool perpendicular = true;
    bool parallel = true;
    std::set<int> loose = {};  ///< template vertices that are near places of the model by chance
    bool regular = false;      ///< edges as long as each other in the reference shape are so
    bool overrule = false;     ///< the ink need not fit
};

/// Those relations for the solver, without what the given directions settle.
SolverRelations keptRelations(const Template& tmpl, const TemplateAnalysis& analysis,
                              const DirectionAssignment& directions, const KeptRelations& keep);

}  // namespace ew
