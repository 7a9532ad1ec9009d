// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/overlay/box_edges.h"

#include <algorithm>

namespace ew {

namespace {
constexpr double kLeastSeen = 0.05;  // sine to the view
}

bool looksHere(const BoxFrame& frame, const Box& box, std::size_t axis, std::size_t k,
               bool material) {
    const double outward = box.side[axis][k] > box.side[axis][1 - k] ? 1.0 : -1.0;
    const double sense = material && !box.adds() ? -outward : outward;
    return sense * frame.axis[axis].z() < -kLeastSeen;
}

namespace {
/// What is to be seen of an edge between two sides of the box once the change is made.
Drawn drawnness(const BoxFrame& frame, const Box& box, const BoxEdge& e) {
    const bool bOn = box.coincides(e.b, e.kb);
    const bool cOn = box.coincides(e.c, e.kc);
    if (bOn && cOn) {
        // What is added flush with two faces carries the edge between them on.
        const bool onward = box.adds() && box.facesOn[e.b][e.kb] && box.facesOn[e.c][e.kc];
        const bool seen =
            looksHere(frame, box, e.b, e.kb, false) || looksHere(frame, box, e.c, e.kc, false);
        return onward && seen ? Drawn::Surely : Drawn::Never;
    }
    if (!bOn && !cOn) {
        const bool b = looksHere(frame, box, e.b, e.kb, true);
        const bool c = looksHere(frame, box, e.c, e.kc, true);
        // Inside a pocket people may leave edges out; there both sides must be seen.
        if (!box.adds()) return b && c ? Drawn::Maybe : Drawn::Never;
        return b || c ? Drawn::Surely : Drawn::Never;
    }
    const std::size_t onAxis = bOn ? e.b : e.c;
    const std::size_t onSide = bOn ? e.kb : e.kc;
    const bool mouth = looksHere(frame, box, onAxis, onSide, false) ||
                       (onAxis == 2 && onSide == 0);  // the frame's face is seen
    const bool wall =
        bOn ? looksHere(frame, box, e.c, e.kc, true) : looksHere(frame, box, e.b, e.kb, true);
    if (!box.adds()) return mouth ? Drawn::Surely : wall ? Drawn::Maybe : Drawn::Never;
    if (wall) return Drawn::Surely;
    const bool flush = onAxis != 2 && box.facesOn[onAxis][onSide];
    return flush && mouth ? Drawn::Surely : Drawn::Never;
}

}  // namespace

std::array<BoxEdge, 12> edgesOf(const BoxFrame& frame, const Box& box) {
    std::array<BoxEdge, 12> edges;
    std::size_t n = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t k = 0; k < 4; ++k, ++n) {
            BoxEdge& e = edges[n];
            e.axis = axis;
            e.b = (axis + 1) % 3;
            e.c = (axis + 2) % 3;
            e.kb = k & 1;
            e.kc = k >> 1;
            const double b = box.side[e.b][e.kb];
            const double c = box.side[e.c][e.kc];
            e.offset = b * frame.across(axis, e.b) + c * frame.across(axis, e.c);
            const double start = b * frame.along(axis, e.b) + c * frame.along(axis, e.c);
            e.from = start + box.side[axis][0] * frame.seen[axis];
            e.to = start + box.side[axis][1] * frame.seen[axis];
            if (e.from > e.to) std::swap(e.from, e.to);
            e.drawn = drawnness(frame, box, e);
        }
    }
    return edges;
}

}  // namespace ew
