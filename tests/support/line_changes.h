// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "tests/support/hand_model.h"
#include "tests/support/random.h"
#include "tests/support/sketch_generator.h"

namespace ew::test {

/// The lines of a drawing as an eye at a finite distance sees them. Only for drawings without T
/// junctions.
/// \param eyeWidths  distance of the eye from the middle of the solid, in widths of the drawing
///                   (the longer side of its bounds), > 1. 4 is mild, 2 strong perspective.
std::vector<Line2> linesInPerspective(const SketchCase& sketch, double eyeWidths);

/// Every corner (lines that share an end) is off by a vector, normally distributed [px per axis];
/// the lines stay straight and go on meeting in their corners.
std::vector<Line2> withMovedCorners(std::vector<Line2> lines, double spreadPx, Random& random);

/// One stroke a line, with a sample at either end, as a line tool draws them.
std::vector<Stroke> ruledStrokes(const std::vector<Line2>& lines);

}  // namespace ew::test
