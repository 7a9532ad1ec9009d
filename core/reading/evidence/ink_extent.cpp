// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/evidence/ink_extent.h"

namespace ew {

double inkLengthPx(const InkReading& ink) {
    double length = 0.0;
    for (const Segment& s : ink.segments) length += s.inkPx;
    return length;
}

std::vector<Vec2> firstInk(const InkReading& ink) {
    if (ink.segments.empty()) return {};
    return {ink.segments.front().a};
}

}  // namespace ew
