// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/reading/solve/closing_planes.h"

namespace ew {

/// Depths of all parts.
struct PartDepths {
    std::vector<double> shifts;  ///< per part [px]
    double less = 0.0;           ///< so many fewer planes are common than with the likeliest depths
};

/// How deep the parts of a drawing lie that only hide one another: so that they have as many planes
/// in common as can be, and what hides is in front. The part with most area stays.
/// \return the likeliest first, at least one.
std::vector<PartDepths> partDepths(const LineDrawing& drawing, const FaceLift& lift,
                                   const SolidPlanes& planes, double spreadPx);

}  // namespace ew
