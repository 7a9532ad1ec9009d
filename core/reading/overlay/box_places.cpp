// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/overlay/box_places.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/tolerance.h"

namespace ew {
namespace {

constexpr std::size_t kMostWalls = 4;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Where a face lies across an axis, if it stands across it.
std::optional<BoxPlace> placeOf(const BoxFrame& frame, const ModelView& model, std::size_t axis,
                                int face) {
    const CameraPlane& plane = model.plane(face);
    const double turn = plane.normal.dot(frame.axis[axis]);
    if (std::abs(turn) < 1 - tol::kSolidDirection) return std::nullopt;
    return BoxPlace{(plane.offset - plane.normal.dot(frame.origin)) / turn, 0.0, face, turn > 0};
}

/// How far apart planes are one.
double reachOf(const BoxFrame& frame) { return 1e-6 * frame.sizePx; }

/// A border of the face, with the face of the solid that stands upright there, if one does.
BoxPlace borderAt(const BoxFrame& frame, const ModelView& model, std::size_t axis, double value) {
    BoxPlace border{value, 0.0};
    for (std::size_t f = 0; f < model.solid().faces().size(); ++f) {
        const auto place = placeOf(frame, model, axis, static_cast<int>(f));
        if (!place || std::abs(place->value - value) > reachOf(frame)) continue;
        border.on = place->on;
        border.ahead = place->ahead;
        // The face's neighbour over a convex edge counts before what only lies in its plane.
        if (border.ahead == (value > 0.5 * (frame.border[axis][0] + frame.border[axis][1]))) break;
    }
    return border;
}

/// How many ends of lines along an axis lie on the edges of a face.
int endsAt(const BoxFrame& frame, const ModelView& model, std::size_t axis, int face,
           double distancePx) {
    int count = 0;
    for (const BoxLine& l : frame.lines) {
        if (l.axis != static_cast<int>(axis)) continue;
        for (const Vec2& p : {l.segment->a, l.segment->b}) {
            const auto& edges = model.edgesOf(face);
            count += std::any_of(edges.begin(), edges.end(), [&](int e) {
                const auto& ends = model.solid().edges()[at(e)].ends;
                return distanceToSegment(p, model.vertex(ends[0]).head<2>(),
                                         model.vertex(ends[1]).head<2>()) < distancePx;
            });
        }
    }
    return count;
}

}  // namespace

std::vector<BoxPlace> bordersAndWalls(const BoxFrame& frame, const ModelView& model,
                                      std::size_t axis, double distancePx) {
    std::vector<BoxPlace> places;
    for (const double border : frame.border[axis]) {
        places.push_back(borderAt(frame, model, axis, border));
    }
    const std::vector<BoxPlace> borders = places;
    std::vector<std::pair<int, BoxPlace>> walls;
    for (std::size_t f = 0; f < model.solid().faces().size(); ++f) {
        const int face = static_cast<int>(f);
        const auto place = placeOf(frame, model, axis, face);
        if (!place || std::any_of(borders.begin(), borders.end(), [&](const BoxPlace& b) {
                return std::abs(b.value - place->value) <= reachOf(frame);
            })) {
            continue;
        }
        const int ends = endsAt(frame, model, axis, face, distancePx);
        if (ends > 0) walls.emplace_back(ends, *place);
    }
    std::stable_sort(walls.begin(), walls.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    for (const auto& [ends, wall] : walls) {
        if (places.size() < borders.size() + kMostWalls) places.push_back(wall);
    }
    return places;
}

}  // namespace ew
