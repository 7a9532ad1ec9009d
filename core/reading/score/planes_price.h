// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/reading/solve/polyhedron_fit.h"

namespace ew {

/// What slanted faces cost besides their freedoms, twice a log-likelihood.
double slantsPrice(const PlaneModel& model);

/// The same of a solid that was closed behind what is seen. A plane that only faces which look away
/// have is none of the drawing's: its freedoms are given back, and it is priced by how much it is
/// like what is seen: parallel to a seen face or across an axis, the mirror image of a seen face,
/// or another direction.
double planesPrice(const PlaneModel& model);

}  // namespace ew
