// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/base/camera.h"
#include "core/solid/solid.h"
#include "tests/support/hand_model.h"
#include "tests/support/random.h"

namespace ew::test {

/// A drawing of what no single template of the library shows, with the solid that it shows.
struct WholeCase {
    Solid solid;  ///< world coordinates [mm]; several bodies are several shells
    OrthographicCamera camera;
    std::vector<Line2> lines;   ///< visible edges, whole [px]
    std::vector<Line2> hidden;  ///< the stretches that are hidden [px]
    bool tellsVolume = true;    ///< false: nothing about the base says how far it is turned
};

/// The rows of the benchmark, e.g. "prism", "pyramid", "parts-2", "trihedral".
const std::vector<std::string>& wholeKinds();

struct WholeShape {
    Solid solid;
    bool tellsVolume = true;  ///< see WholeCase
};

/// A random shape of that kind, about one unit big, standing on z = 0.
///
/// prism: over a convex polygon of 4 to 10 corners, regular in one of three, standing or lying.
/// concave: a prism over a T, U, L, plus, staircase or house outline. pyramid, frustum: over a
/// rectangle or a polygon of 5 to 8 corners, apex over the middle; the polygon is regular, that of
/// a frustum, whose top is seen, in half of them. parts-2, parts-5, parts-8: two, 3 to 5 and 6 to 8
/// boxes added to and cut out of one another on their faces, now and then a prism or a pyramid on
/// top. trihedral: a box or two with corners and edges cut off. many-edges: corners with four or
/// five edges: a roof flush on its walls, a pyramid flush on a box, a double pyramid. bodies: two
/// or three boxes or prisms on one ground.
WholeShape randomWhole(const std::string& kind, Random& random);

/// The same from a camera that shows it so that a person can tell it: tilt 18 to 50 degrees, three
/// faces or more well seen, and the rules of ReadabilityRules for junctions and lines.
WholeCase randomWholeCase(const std::string& kind, Random& random);

/// Lines that run past both of their ends, by a tenth to six tenths of their mean length, as guide
/// lines do.
std::vector<Line2> withGuides(const std::vector<Line2>& lines, Random& random);

/// The drawing of a solid: what is seen of every edge, and what is hidden.
WholeCase wholeCase(const Solid& solid, const OrthographicCamera& camera);

}  // namespace ew::test
