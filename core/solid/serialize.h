// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/solid.
#pragma once

#include <string>

#include "core/solid/mesh_kernel.h"

namespace ew {

/// What Solid::serialize() gives. O(size).
std::string textOf(const Solid::Impl& solid);

}  // namespace ew
