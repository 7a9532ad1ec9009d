// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/surface/fillet.h"
#include "core/surface/fillet_plan.h"

namespace ew {

/// Weights of the two inward directions, in setbacks, along the arc of a strip: point = right *
/// weight[0] + left * weight[1], from (1, 0) at t = 0 to (0, 1) at t = 1.
std::array<double, 2> arcWeights(double foldCosine, double t);

/// The mesh of a plan with setbacks that fit. Makes no check.
/// \pre setbacks > 0 on filleted edges, 0 elsewhere.
FilletedCage buildFillet(const FilletPlan& plan, const std::vector<double>& setbacks, int segments);

/// A side of the hole that a corner leaves: the end of a strip.
struct PatchSide {
    std::vector<int> ids;        ///< segments + 1 points of the mesh
    Vec3 middle = Vec3::Zero();  ///< of the arc
    Vec3 inward = Vec3::Zero();  ///< unit, in which the strip goes on into the hole
    Vec3 center = Vec3::Zero();  ///< of the arc's circle, where the end is square to the edge
    double radius = 0.0;         ///< of the arc
    bool square = false;         ///< the end is square to the edge
    bool convex = true;
};

/// Fills a corner between three or more strip ends, counter-clockwise from outside, each beginning
/// where the one before ends: rings of quadrangles around a middle point or, for an odd number of
/// segments, a middle face. Where one ball touches all strips, the patch lies on it.
void addCornerPatch(PolyMesh& mesh, std::span<const PatchSide> sides);

}  // namespace ew
