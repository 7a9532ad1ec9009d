// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Qt>

#include "core/base/vec.h"

namespace ew {

/// What holds the pointer.
enum class PenDevice { Mouse, Pen, Eraser, Touch };

/// What the pointer is asked to do, after buttons, keys and device were weighed against each other.
enum class PenIntent { Tool, Erase, Orbit, Pan };

enum class PenPhase {
    Hover,  ///< above the surface or no button down
    Begin,
    Update,
    End,
    Cancel,  ///< taken away: nothing that was begun may stay
    Leave,   ///< the pointer is gone, stop showing where it is
};

/// One plain value for every pointing device. Made once, at the border (InputArbiter); nothing
/// behind it sees native events. Time is passed in.
struct PenEvent {
    PenPhase phase = PenPhase::Hover;
    PenDevice device = PenDevice::Mouse;
    PenIntent intent = PenIntent::Tool;
    Vec2 position = Vec2::Zero();  ///< [logical px of the viewport], y down
    double pressure = 1.0;         ///< 0..1; 1 for devices without
    double timeMs = 0.0;           ///< clock of the device [ms]
};

}  // namespace ew
