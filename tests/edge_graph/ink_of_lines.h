// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/edge_graph/build.h"

namespace ew::test {

using Lines = std::vector<std::array<Vec2, 2>>;

/// Each line as a stroke of two samples.
inline std::vector<Stroke> strokesOf(const Lines& lines) {
    std::vector<Stroke> strokes;
    for (const auto& l : lines) {
        Stroke s;
        s.samples.push_back({l[0], 1, 0});
        s.samples.push_back({l[1], 1, 0});
        strokes.push_back(std::move(s));
    }
    return strokes;
}

inline InkReading inkOf(const Lines& lines, double distancePx) {
    return readInk(strokesOf(lines), distancePx);
}

}  // namespace ew::test
