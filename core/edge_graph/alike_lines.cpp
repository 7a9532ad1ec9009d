// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edge_graph/alike_lines.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/stroke/segmenting.h"

namespace ew {
namespace {

constexpr double kRetracedOff = 0.6;  ///< from the line through both [distance thresholds]

/// Two lines that go on into one another, or retrace each other, as one; nothing where they do
/// not.
std::optional<InkLine> joined(const InkLine& a, const InkLine& b, const LineJoining& how,
                              double distancePx) {
    const Vec2 d = a.length() > b.length() ? a.direction() : b.direction();
    const auto span = [&](const InkLine& line) {
        const double s = line.a.dot(d);
        const double t = line.b.dot(d);
        return std::pair(std::min(s, t), std::max(s, t));
    };
    const auto [aLow, aHigh] = span(a);
    const auto [bLow, bHigh] = span(b);
    const double common = std::min(aHigh, bHigh) - std::max(aLow, bLow);
    const bool retraced = common > how.overlap * std::min(a.length(), b.length());
    if (!retraced && std::abs(common) > distancePx) return std::nullopt;
    const double sine = std::abs(cross2(a.direction(), b.direction()));
    if (sine > (retraced ? kAlongSine : how.bend)) return std::nullopt;
    InkLine out = a;
    out.points.insert(out.points.end(), b.points.begin(), b.points.end());
    if (out.points.size() < 2) return std::nullopt;
    const LineFit fit = fitLine(out.points);
    const auto off = [&](const Vec2& p) { return std::abs(cross2(fit.direction, p - fit.center)); };
    const double most = (retraced ? kRetracedOff : how.off) * distancePx;
    if (std::max({off(a.a), off(a.b), off(b.a), off(b.b)}) > most) return std::nullopt;
    out.a = fit.center + fit.tMin * fit.direction;
    out.b = fit.center + fit.tMax * fit.direction;
    out.inkPx += b.inkPx;
    out.strokes.insert(out.strokes.end(), b.strokes.begin(), b.strokes.end());
    std::sort(out.strokes.begin(), out.strokes.end());
    out.strokes.erase(std::unique(out.strokes.begin(), out.strokes.end()), out.strokes.end());
    return out;
}

}  // namespace

void joinAlike(std::vector<InkLine>& lines, const LineJoining& how, double distancePx) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
        for (std::size_t k = i + 1; k < lines.size(); ++k) {
            if (auto whole = joined(lines[i], lines[k], how, distancePx)) {
                lines[i] = *std::move(whole);
                lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(k));
                k = i;
            }
        }
    }
}

}  // namespace ew
