// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/base/vec.h"
#include "core/solid/solid.h"

namespace ew {

/// How the faces beside a face that is pulled go on.
enum class PullWalls {
    Follow,    ///< they keep their planes: the face grows or shrinks where they slant
    Straight,  ///< the face keeps its outline, and walls perpendicular to it join on
};

struct PullOutcome {
    Solid solid;
    bool slid = false;  ///< vertices, edges and faces are the same ones, index by index
};

/// Moves a face along its normal, exactly: what is swept is added to the solid or cut out of it, so
/// it stops or goes on where it meets other parts. A face that is moved out and back by the same
/// distance gives the very solid back, as long as it met nothing on its way.
/// \param face  index into Solid::faces().
/// \param distance  outwards positive [mm].
/// Errors: BadValue (no such face, no usable distance), NoChange (0), NotPlanar (the face is flat
/// only to the eye), OperationImpossible where walls that follow would leave nothing of the face
/// (the sentence says after how many mm), and those of combine().
/// Cost: O(faces).
Result<PullOutcome> pullFace(const Solid& solid, int face, double distance, PullWalls walls);

/// Adds a prism over an outline in a face to the solid, or cuts it out of it: `distance` outwards
/// is positive [mm]. Its base lies in the face's plane and its sides are perpendicular to it,
/// exactly; where it nearly lies in planes or on corners of the solid, it does. \param corners  of
/// the outline, counter-clockwise from outside [mm]. Errors: BadValue, NoChange, those of
/// makeTool() and combine().
Result<PullOutcome> pullProfile(const Solid& solid, int face, const std::vector<Vec3>& corners,
                                double distance);

}  // namespace ew
