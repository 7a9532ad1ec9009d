// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/result.h"
#include "core/base/vec.h"

namespace ew {

/// One reading of the pen.
struct PenSample {
    Vec2 position = Vec2::Zero();  ///< [Sketch Plane px], y down
    double pressure = 1.0;         ///< 0..1; line weight only, never read by the analysis
    double timeMs = 0.0;           ///< since pen-down [ms]; 0 throughout where unknown
};

/// One pen-down to pen-up.
struct Stroke {
    std::vector<PenSample> samples;  ///< in time order, n >= 1
};

/// The two thresholds of the paper.
/// \paper{4.1} \paper{7.4}
struct Thresholds {
    double distancePx = 14.0;  ///< do stroke ends meet at one vertex? [px], 1..100
    double angleDeg = 12.0;    ///< are two edges parallel? [degrees], 0.5..45
    bool operator==(const Thresholds&) const = default;
};

inline constexpr std::size_t kMaxSamplesPerStroke = 200'000;
inline constexpr std::size_t kMaxPendingStrokes = 2'000;
inline constexpr double kMaxCoordinatePx = 1e6;

/// Errc::BadCoordinates for NaN, infinite or beyond kMaxCoordinatePx (with the index of the point
/// in the message), Errc::TooManyPoints, Errc::EmptySketch for no sample at all.
Result<void> validateStroke(const Stroke& stroke);

/// A stroke as a steady hand draws a straight line: a sample every 6 px or so, no times.
Stroke straightStroke(const Vec2& from, const Vec2& to);

}  // namespace ew
