// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/tlib/aspects.h"

namespace ew {

/// The shape in the coordinates of a view: x right, y down, z away from the eye; unit size.
struct AspectView {
    std::vector<Vec3> points;
    std::vector<double> facing;  ///< per face: normal . direction, negative towards the eye
};

AspectView makeView(const PolyhedronSpec& shape, const TemplateAnalysis& analysis,
                    const Vec3& direction);

/// Is a point inside a face as the view shows it?
bool insideLoop(const AspectView& view, const std::vector<int>& loop, const Vec2& p);

/// Directions spread evenly over the sphere (Fibonacci lattice), turned so that none is along an
/// axis.
std::vector<Vec3> spreadDirections(int count);

/// Key that is equal where two views show the same parts of the same template.
std::string labelledKey(const Aspect& aspect);

/// Adds a direction that is well apart from those kept so far; a few are enough.
void keepDirection(Aspect& aspect, const Vec3& direction);

}  // namespace ew
