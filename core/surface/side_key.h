// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface.
#pragma once

#include <cstdint>

namespace ew {

/// The side from one point to another as a key for maps: its twin has another one.
inline std::uint64_t sideKey(int from, int to) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(from)) << 32U) |
           static_cast<std::uint32_t>(to);
}

}  // namespace ew
