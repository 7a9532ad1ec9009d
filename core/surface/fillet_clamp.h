// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface.
#pragma once

#include <vector>

#include "core/surface/fillet_plan.h"

namespace ew {

/// Setbacks that fit, and for each edge that got less than it asked for what stopped it.
struct FilletFit {
    std::vector<double> setbacks;     ///< by edge [mm], 0 where it is not filleted
    std::vector<int> limitingEdge;    ///< by edge, -1 where it got what it asked for
    std::vector<int> limitingVertex;  ///< by edge, -1 as above, or where no corner is in the way
};

/// Largest setbacks up to the wanted ones with which every face keeps its shape: on every edge of
/// every face something is left, and no corner of a face runs into another edge of it. All setbacks
/// grow from zero at one rate; where room runs out, the edges that use it stop (max-min fair).
/// \param wanted  by edge [mm], > 0 on filleted edges.
/// O(n log n).
FilletFit fitSetbacks(const FilletPlan& plan, const std::vector<double>& wanted);

}  // namespace ew
