// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/tlib/analysis.h"

namespace ew {

/// Every permutation of a template's vertices that keeps its faces and all its relations; the
/// identity first. Mirror images count: a relation does not know left from right. O(E^2).
std::vector<std::vector<int>> symmetries(const Template& tmpl, const TemplateAnalysis& analysis);

}  // namespace ew
