// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/solid/polyhedron_spec.h"
#include "tests/support/random.h"

namespace ew::test {

/// A random instance of a template class, standing on z = 0 or turned as randomSketch says, about
/// one unit big. Empty for an unknown id.
PolyhedronSpec randomShape(const std::string& id, Random& random);

PolyhedronSpec boxSpec(double x, double y, double z);

/// A right prism over a polygon (counter-clockwise from above), from z = 0 to `height`: bottom
/// vertices first, then the top ones in the same order.
PolyhedronSpec prismSpec(const std::vector<Vec2>& polygon, double height);

}  // namespace ew::test
