// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/vec.h"
#include "core/solid/boolean.h"
#include "tests/solid/voxels.h"

namespace ew::test {

struct BoxStep {
    IntBox box;
    BooleanKind kind = BooleanKind::Add;
};

/// The 24 rotations of a cube.
const std::vector<Eigen::Matrix3i>& cubeRotations();

/// The box, moved by an integer matrix about the origin: its corners stay exact doubles.
Solid movedBox(const IntBox& box, const Eigen::Matrix3i& matrix);

/// Runs the steps on a solid (the first one makes it) and on voxels, compares all that can be
/// counted after every step, or the refusal: NoChange, NothingLeft, TouchesIn... A refused step is
/// left out on both sides.
void checkSteps(const std::vector<BoxStep>& steps, const Eigen::Matrix3i& matrix);

/// checkSteps under the 24 rotations and a rotation about an oblique axis, scaled by 3.
void checkUnderRotations(const std::vector<BoxStep>& steps);

/// The same solid read from its text passes the whole gate and is the same.
void checkWholeGate(const Solid& solid);

}  // namespace ew::test
