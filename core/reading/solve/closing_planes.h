// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/reading/solve/face_lift.h"

namespace ew {

/// A plane that a solid may have, of a face that is seen or of one that closes it behind an edge.
struct SolidPlane {
    int direction = -1;     ///< index of its normal
    double offset = 0.0;    ///< along that normal [px]
    double weightPx = 0.0;  ///< length of the lines that tell it
    int region = -1;        ///< face that is seen in it, -1 for a plane behind
    bool away = false;      ///< the solid is on its positive side
    int part = 0;           ///< FaceLift::part
};

/// Planes of one drawing, with the directions that they share.
struct SolidPlanes {
    std::vector<Vec3> directions;  ///< unit, camera space; the first three are the axes
    std::vector<SolidPlane> planes;
};

/// The planes of the faces that are seen, and those that may be behind the edges of which one face
/// is seen: across an axis, parallel to a seen face or to its mirror image in an axis plane, or
/// along the edge and an axis. The hidden face looks away from the eye, and the seen one is on its
/// inner side.
/// \param spreadPx  standard deviation of a corner, per axis.
SolidPlanes solidPlanes(const LineDrawing& drawing, const AxisFrame& frame, const FaceLift& lift,
                        double spreadPx);

}  // namespace ew
