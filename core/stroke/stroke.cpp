// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stroke/stroke.h"

#include <cmath>
#include <string>

namespace ew {

Result<void> validateStroke(const Stroke& stroke) {
    if (stroke.samples.empty()) return fail(Errc::EmptySketch, "The stroke has no points.");
    if (stroke.samples.size() > kMaxSamplesPerStroke) {
        return fail(Errc::TooManyPoints, "The stroke has " + std::to_string(stroke.samples.size()) +
                                             " points; at most " +
                                             std::to_string(kMaxSamplesPerStroke) + " are read.");
    }
    for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
        const Vec2& p = stroke.samples[i].position;
        // Written so that NaN fails too.
        if (!(std::abs(p.x()) <= kMaxCoordinatePx && std::abs(p.y()) <= kMaxCoordinatePx)) {
            return fail(Errc::BadCoordinates,
                        "Point " + std::to_string(i) + " of the stroke is not a usable position.");
        }
    }
    return {};
}

Stroke straightStroke(const Vec2& from, const Vec2& to) {
    constexpr double kStepPx = 6.0;
    constexpr double kMostSteps = 1000.0;
    const double steps = std::clamp(std::ceil((to - from).norm() / kStepPx), 1.0, kMostSteps);
    Stroke stroke;
    for (double k = 0.0; k <= steps; k += 1.0) {
        PenSample sample;
        sample.position = from + (to - from) * (k / steps);
        stroke.samples.push_back(sample);
    }
    return stroke;
}

}  // namespace ew
