// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stroke/consolidate.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/tolerance.h"

namespace ew {
namespace {

struct Interval {
    double lo, hi;
};

Interval project(const InkLine& line, const Vec2& a, const Vec2& b) {
    const Vec2 d = line.direction();
    const double ta = (a - line.a).dot(d);
    const double tb = (b - line.a).dot(d);
    return {std::min(ta, tb), std::max(ta, tb)};
}

/// Does `s` retrace `line`? Both lie beside each other over most of the shorter one.
bool retraces(const InkLine& line, const InkLine& s, const ConsolidateOptions& o) {
    constexpr double kWidestRad = 0.6;
    static const double kWidestSine = std::sin(kWidestRad);
    const double sine = std::abs(cross2(line.direction(), s.direction()));
    if (sine > kWidestSine) return false;  // the most usual case, told cheaply
    const double reach = o.distancePx * o.scale;
    const double shorter = std::min(line.length(), s.length());
    const double slack = 0.35 * reach / std::max(shorter, 1e-9);
    const double limit = tol::kOvertraceDeg * o.scale * std::numbers::pi / 180.0 + std::atan(slack);
    if (sine > std::sin(std::min(limit, kWidestRad))) return false;

    const Interval on = project(line, s.a, s.b);
    const double overlap = std::min(on.hi, line.length()) - std::max(on.lo, 0.0);
    if (overlap <= 0) return false;
    if (overlap < tol::kOvertraceOverlap * shorter && overlap < 1.2 * o.distancePx) return false;

    // Distances are compared where both have ink.
    const Vec2 d = line.direction();
    auto offsetAt = [&](double t) {
        const Vec2 e = s.b - s.a;
        const double along = e.dot(d);
        const double u = std::abs(along) < 1e-9
                             ? 0.5
                             : std::clamp((t - (s.a - line.a).dot(d)) / along, 0.0, 1.0);
        return std::abs(cross2(d, s.a + u * e - line.a));
    };
    const double o1 = offsetAt(std::max(on.lo, 0.0));
    const double o2 = offsetAt(std::min(on.hi, line.length()));
    const double scaled = std::min(reach, 0.45 * shorter + 0.25 * reach);
    return 0.5 * (o1 + o2) < tol::kOvertraceMean * scaled &&
           std::max(o1, o2) < tol::kOvertraceMax * scaled;
}

/// Of a line that was traced hundreds of times every other point tells as much.
void thin(std::vector<Vec2>& points) {
    constexpr std::size_t kMostPoints = 4096;
    if (points.size() <= kMostPoints) return;
    for (std::size_t i = 0; 2 * i < points.size(); ++i) points[i] = points[2 * i];
    points.resize((points.size() + 1) / 2);
}

void absorb(InkLine& line, const InkLine& s) {
    line.points.insert(line.points.end(), s.points.begin(), s.points.end());
    thin(line.points);
    line.inkPx += s.inkPx;
    std::vector<int> strokes;
    std::set_union(line.strokes.begin(), line.strokes.end(), s.strokes.begin(), s.strokes.end(),
                   std::back_inserter(strokes));
    line.strokes = std::move(strokes);
    const LineFit fit = fitLine(line.points);
    Vec2 dir = fit.direction;
    if (dir.dot(line.b - line.a) < 0) dir = -dir;
    // The line reaches as far as either trace: stopping short is more usual than running past.
    auto end = [&](const Vec2& mine, bool high) {
        const double t = (mine - fit.center).dot(dir);
        const double sa = (s.a - fit.center).dot(dir);
        const double sb = (s.b - fit.center).dot(dir);
        return Vec2(fit.center + dir * (high ? std::max({t, sa, sb}) : std::min({t, sa, sb})));
    };
    const Vec2 a = end(line.a, false);
    const Vec2 b = end(line.b, true);
    line.a = a;
    line.b = b;
}

}  // namespace

std::vector<InkLine> consolidate(const std::vector<Segment>& segments,
                                 const ConsolidateOptions& options) {
    std::vector<InkLine> lines;
    lines.reserve(segments.size());
    for (const Segment& s : segments) {
        InkLine line;
        line.a = s.a;
        line.b = s.b;
        line.strokes = {s.stroke};
        line.points = s.points;
        line.inkPx = s.inkPx;
        lines.push_back(std::move(line));
    }

    std::vector<int> order(lines.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int i, int j) {
        return lines[static_cast<std::size_t>(i)].length() >
               lines[static_cast<std::size_t>(j)].length();
    });
    std::vector<InkLine> kept;
    for (const int i : order) {
        const InkLine& s = lines[static_cast<std::size_t>(i)];
        InkLine* into = nullptr;
        for (InkLine& k : kept) {
            if (retraces(k, s, options)) {
                into = &k;
                break;
            }
        }
        if (into) {
            absorb(*into, s);
        } else {
            kept.push_back(s);
            if (kept.size() > options.mostLines) break;
        }
    }
    return kept;
}

}  // namespace ew
