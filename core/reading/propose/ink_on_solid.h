// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/edge_graph/build.h"
#include "core/reading/extract/model_view.h"
#include "core/reading/propose/placement.h"
#include "core/tlib/matcher.h"

namespace ew {

/// Length of the ink that runs neither along an edge of the placed template nor along a visible one
/// of the model [px]. Edges of what is added count only where the solid does not hide them.
double unexplainedInk(const InkReading& ink, const Placement& placement, const GraphMatch& match,
                      const ModelView& view, double distancePx, double noisePx);

/// The strokes of which less than half runs along edges of the placed template or visible ones of
/// the model, and those that are no lines. Ascending.
/// \paper{4.1.3}
std::vector<int> strokesBeside(const InkReading& ink, const Placement& placement,
                               const GraphMatch& match, const ModelView& view, double distancePx);

/// How much of the ink lies over the solid as it is seen, 0..1.
double shareOver(const InkReading& ink, const ModelView& view);

}  // namespace ew
