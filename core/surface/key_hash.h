// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface.
#pragma once

#include <cstdint>
#include <vector>

namespace ew {

/// Hash of a run of whole numbers, for keys that are compared in full where hashes agree.
template <class Int>
std::uint64_t keyHash(const std::vector<Int>& key) {
    std::uint64_t h = 0xcbf29ce484222325ULL;
    for (const Int k : key) {
        h = (h ^ static_cast<std::uint64_t>(k)) * 0x9e3779b97f4a7c15ULL;
        h ^= h >> 29U;
    }
    return h;
}

}  // namespace ew
