// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/edge_graph/edge_graph.h"

namespace ew {

/// Finds, for every dangling edge, what its free ends look meant to meet: the nearest junction,
/// inside of an edge or other free end ahead, within a few distance thresholds. Fills
/// graph.openEnds.
void findOpenEnds(EdgeGraph& graph, double distancePx);

}  // namespace ew
