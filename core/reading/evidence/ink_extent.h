// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/edge_graph/build.h"

namespace ew {

/// All ink that is lines [px].
double inkLengthPx(const InkReading& ink);

/// Where the first line begins [px]; nothing where there is none.
std::vector<Vec2> firstInk(const InkReading& ink);

}  // namespace ew
