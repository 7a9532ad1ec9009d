// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/reading/propose/shape_hypothesis.h"

namespace ew {

/// Right prisms over regions of a drawing. A base that faces the eye is seen whole, so it is one
/// region that nothing hides; parallel lines leave its corners, and all that is hidden follows. How
/// far the base is turned from the eye is told by its outline: right angles, equal sides and turns,
/// a mirror line. O(regions * corners^3).
/// \param spreadPx  how far corners lie from where they are meant, per axis [px].
std::vector<ShapeHypothesis> prismProposals(const LineDrawing& drawing, double spreadPx);

}  // namespace ew
