// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/reading/propose/shape_hypothesis.h"

namespace ew {

/// Pyramids with an apex over the middle of their base. What is seen are triangles round the apex;
/// corners of the base that are hidden are told by a parallelogram or a regular polygon, which is
/// seen as an ellipse whose short axis points to the apex. O(nodes * corners).
/// \param spreadPx  how far corners lie from where they are meant, per axis [px].
std::vector<ShapeHypothesis> pyramidProposals(const LineDrawing& drawing, double spreadPx);

}  // namespace ew
