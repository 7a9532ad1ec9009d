// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/support/hand_model.h"
#include "tests/support/random.h"
#include "tests/support/sketch_generator.h"

namespace ew::test {

/// What people do wrong when they draw a solid.
enum class Spoiling {
    OpenCorner,        ///< a line ends 30 to 45 px before its corner
    MissingEdge,       ///< one line is left out
    ExtraEdge,         ///< a line from corner to corner that is no edge
    CurvedEdge,        ///< one line is bent by a fifth to a third of its length
    HiddenLine,        ///< a hidden edge or all of them are drawn too
    MovedCorner,       ///< a corner is off by 60 px
    TwoDrawings,       ///< two solids beside each other
    Scribble,          ///< no lines at all
    OutlineOnly,       ///< nothing inside the outline
    ImpossibleCorner,  ///< a right-angled corner that no view shows: the three lines at it leave
                       ///< an angle of over 180 degrees at a Y
    TooSmall,          ///< 10 px across
};

/// All of them, with the names that the table prints.
struct SpoilingName {
    Spoiling kind;
    std::string_view name;
};
const std::vector<SpoilingName>& spoilings();

/// A drawing that was spoilt in one way.
struct SpoiltDrawing {
    SketchCase meant;
    std::vector<Stroke> strokes;
    std::vector<Vec2> places;        ///< any of them is where the fault is; none: it has no place
    std::vector<std::string> codes;  ///< error codes that name the cause
    bool mayBeRead = false;          ///< all the same the solid that is meant may be read
};

/// One drawing of a random template of the library by this hand; deterministic in `random`.
SpoiltDrawing spoiltDrawing(Spoiling kind, const HandLevel& hand, Random& random);

}  // namespace ew::test
