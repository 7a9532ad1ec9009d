// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/tlib/analysis.h"

namespace ew {

/// Every permutation of a template's vertices that keeps its faces and all its relations; the
/// identity first. Mirror images count: a relation does not know left from right. O(E^2).
std::vector<std::vector<int>> symmetries(const Template& tmpl, const TemplateAnalysis& analysis);

/// Are two templates one but for the numbers of their vertices and the proportions of their
/// reference shapes? O(E^2).
bool areSame(const Template& a, const TemplateAnalysis& aKnown, const Template& b,
             const TemplateAnalysis& bKnown);

}  // namespace ew
