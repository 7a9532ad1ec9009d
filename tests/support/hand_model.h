// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/hand/hand_model.h"
#include "tests/support/random.h"

namespace ew::test {

using ew::drawByHand;
using ew::HandHabits;
using ew::HandLevel;
using ew::HandStyle;
using ew::handStyles;
using ew::kExactHand;
using ew::kLightHand;
using ew::kNormalHand;
using ew::kRoughHand;
using ew::Line2;

}  // namespace ew::test
