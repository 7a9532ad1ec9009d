// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/hand/random.h"

namespace ew::test {

using ew::Random;

}  // namespace ew::test
