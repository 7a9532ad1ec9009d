// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/reading/overlay/box_frame.h"

namespace ew {

/// A place where a side of a box may be.
struct BoxPlace {
    double value = 0.0;   ///< along the axis, from the frame's origin [px]
    double weight = 0.0;  ///< length of the lines that say so [px]
    int on = -1;          ///< face of the solid that lies there
    bool ahead = false;   ///< ... whose outside is that way along the axis
};

/// Where the solid itself says that a side across an axis may be: at the two borders of the frame's
/// face, those first, and at walls that lines along the axis end at. Between two walls a box needs
/// no line of its own there.
std::vector<BoxPlace> bordersAndWalls(const BoxFrame& frame, const ModelView& model,
                                      std::size_t axis, double distancePx);

}  // namespace ew
