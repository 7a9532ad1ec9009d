// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace ew::test {

/// Why drawings were not read rightly, with the numbers of those drawings.
using Reasons = std::map<std::string, std::vector<int>>;

/// A line a reason, with the first of its drawings.
inline void printReasons(const Reasons& reasons) {
    constexpr std::size_t kMostNumbers = 8;
    for (const auto& [reason, where] : reasons) {
        std::printf("    %3zu %s:", where.size(), reason.c_str());
        for (std::size_t k = 0; k < std::min(where.size(), kMostNumbers); ++k) {
            std::printf(" %d", where[k]);
        }
        std::printf("\n");
    }
}

}  // namespace ew::test
