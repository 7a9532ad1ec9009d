// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/reading/solve/general_fit.h"

namespace ew {

/// By direction class of a template: its direction in camera space (unit), where it is given.
using KnownDirections = std::vector<std::optional<Vec3>>;

/// Are all relations linear once these directions are given? Edges that are opposite in a
/// parallelogram are one vector; perpendicular to a given direction is linear.
bool isLinear(const Template& tmpl, const TemplateAnalysis& analysis, const KnownDirections& known);

/// As solveAnchored, in closed form: least squares under linear constraints. What drawing and
/// constraints leave open makes the edges concerned about as long as the others.
/// \param anchors  planes, lines, points and medians; its directions are not looked at.
/// \pre isLinear(). Nothing where the constraints contradict each other. Cost: O(vertices^3).
std::optional<GeneralSolution> solveLinearly(const Template& tmpl, const TemplateAnalysis& analysis,
                                             const Sighting& sighting, const Anchors& anchors,
                                             const KnownDirections& known);

}  // namespace ew
