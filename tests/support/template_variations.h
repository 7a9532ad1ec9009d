// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/tlib/template.h"
#include "tests/support/random.h"

namespace ew::test {

/// Many valid templates, to fill a library: right prisms and pyramid stumps over regular polygons
/// of `fewestCorners` (3 or more) to 9 corners with none to four of their corners cut off. From 3
/// on many of them look like a cube or a prism from some side, from 5 on hardly any. Ids are
/// "variation-0", "variation-1", ... Relations: the side edges of a prism are parallel, where
/// their ends were not cut off.
std::vector<Template> templateVariations(int count, Random& random, int fewestCorners = 3);

/// The polyhedron with one corner cut off, which must have three edges: a triangle at `part`
/// (0..1) of each. The corner's index is used again; the other two new corners come last.
PolyhedronSpec cutCorner(const PolyhedronSpec& spec, int vertex, double part);

}  // namespace ew::test
