// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/edge_graph/edge_graph.h"

namespace ew {

/// What a reading of the strokes as a graph has to pay, in units of twice a log-likelihood.

/// Price of ink that a graph drops: a stray line is a line too many, a short one less so.
double strayPrice(const EdgeGraph& graph, double distancePx);

/// Price of ink that strays from its edge more than this hand wobbles, or than most edges of the
/// graph do: two edges taken for one, most likely.
double bentPrice(const EdgeGraph& graph, double wobblePx);

}  // namespace ew
