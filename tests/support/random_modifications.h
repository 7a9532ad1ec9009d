// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/solid/exact_tool.h"
#include "tests/support/random.h"

namespace ew::test {

/// A box, wedge or pyramid on a face of a solid (or, inward, in it), about 10 mm big: its base in
/// the face's plane exactly and, by chance, a side along an edge of the face, a corner on a vertex.
ToolSpec randomTool(const Solid& solid, bool inward, Random& random);

/// A box, prism or pyramid of 30 to 60 mm after up to `most` random additions and cuts; those that
/// are refused are left out. The same random numbers give the same solid.
Solid randomModifiedSolid(int most, Random& random);

}  // namespace ew::test
