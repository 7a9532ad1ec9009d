// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "core/base/vec.h"

namespace ew::test {

/// Largest distance from a point of one set to the nearest of the other, both ways; sets of equal
/// size. Points are looked up in a grid of `cell`.
inline double setDistance(const std::vector<Vec3>& a, const std::vector<Vec3>& b, double cell) {
    const auto oneWay = [&](const std::vector<Vec3>& from, const std::vector<Vec3>& to) {
        std::map<std::array<long, 3>, std::vector<std::size_t>> grid;
        const auto key = [&](const Vec3& p) {
            return std::array<long, 3>{std::lround(p.x() / cell), std::lround(p.y() / cell),
                                       std::lround(p.z() / cell)};
        };
        for (std::size_t i = 0; i < to.size(); ++i) grid[key(to[i])].push_back(i);
        double worst = 0.0;
        for (const Vec3& p : from) {
            double best = cell;
            const auto c = key(p);
            for (long x = -1; x <= 1; ++x) {
                for (long y = -1; y <= 1; ++y) {
                    for (long z = -1; z <= 1; ++z) {
                        const auto it = grid.find({c[0] + x, c[1] + y, c[2] + z});
                        if (it == grid.end()) continue;
                        for (const std::size_t i : it->second) {
                            best = std::min(best, (to[i] - p).norm());
                        }
                    }
                }
            }
            worst = std::max(worst, best);
        }
        return worst;
    };
    return std::max(oneWay(a, b), oneWay(b, a));
}

}  // namespace ew::test
