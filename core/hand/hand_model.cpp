// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/hand/hand_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/hand/hand_plan.h"

namespace ew {
namespace {

constexpr double kFadePx = 15.0;   ///< wobble fades towards ends and corners over this length
constexpr double kSlowPx = 25.0;   ///< the pen slows down within this distance of a corner
constexpr double kSlowest = 0.25;  ///< of the cruising speed, at ends and corners
constexpr double kShortestStepPx =
    0.3;                             ///< samples nearer than this to an exact corner are left out
constexpr double kNoPressure = 1.0;  ///< of a device that knows none

/// Smooth noise along a stroke with standard deviation 1 and correlation length 20 to 60 px (the
/// autocorrelation of a sine is 0 after a quarter of its wave length).
class SmoothNoise {
  public:
    explicit SmoothNoise(Random& random) {
        double power = 0.0;
        for (Wave& w : waves_) {
            w.amplitude = random.uniform(0.3, 1.0);
            w.frequency = 2.0 * std::numbers::pi / (80.0 * std::pow(3.0, random.uniform()));
            w.phase = random.uniform(0.0, 2.0 * std::numbers::pi);
            power += w.amplitude * w.amplitude / 2.0;
        }
        for (Wave& w : waves_) w.amplitude /= std::sqrt(power);
    }
    double at(double s) const {
        double sum = 0.0;
        for (const Wave& w : waves_) sum += w.amplitude * std::sin(w.frequency * s + w.phase);
        return sum;
    }

  private:
    struct Wave {
        double amplitude = 0.0, frequency = 0.0, phase = 0.0;
    };
    std::array<Wave, 4> waves_;
};

double smoothStep(double x) {
    const double t = std::clamp(x, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// An end or a corner of a path.
struct SlowPoint {
    double s = 0.0;     ///< arc length [px]
    double fade = 1.0;  ///< 0..1: how much of the wobble is gone there
};

/// A polyline with arc length, and where on it the pen slows down.
struct Path {
    std::vector<Vec2> points;
    std::vector<double> length;   ///< per point, from the start [px]
    std::vector<SlowPoint> slow;  ///< ends and corners, ascending

    double total() const { return length.back(); }

    void add(const Vec2& p) {
        const double step = points.empty() ? 0.0 : (p - points.back()).norm();
        if (!points.empty() && step == 0.0) return;
        length.push_back(points.empty() ? 0.0 : length.back() + step);
        points.push_back(p);
    }

    double toNearestSlow(double s) const {
        double best = total();
        for (const SlowPoint& p : slow) best = std::min(best, std::abs(s - p.s));
        return best;
    }

    /// Share of the wobble that is left at arc length s.
    double wobbleAt(double s) const {
        double left = 1.0;
        for (const SlowPoint& p : slow) {
            left *= 1.0 - p.fade * (1.0 - smoothStep(std::abs(s - p.s) / kFadePx));
        }
        return left;
    }

    /// Point at arc length s, and the unit normal of the path there.
    Vec2 at(double s, Vec2& normal) const {
        const auto upper = std::upper_bound(length.begin(), length.end(), s);
        const auto i = std::clamp<std::ptrdiff_t>(upper - length.begin(), 1,
                                                  static_cast<std::ptrdiff_t>(length.size()) - 1);
        const auto k = static_cast<std::size_t>(i);
        const Vec2 d = points[k] - points[k - 1];
        const double step = length[k] - length[k - 1];
        normal = Vec2(-d.y(), d.x()) / step;
        const double t = std::clamp((s - length[k - 1]) / step, 0.0, 1.0);
        return t == 1.0 ? points[k] : Vec2(points[k - 1] + t * d);
    }
};

/// Where the hand really aims: ends and corners with their errors.
std::vector<Vec2> misplace(const PlannedStroke& plan, const HandLevel& level, double overshootPx,
                           Random& random) {
    std::vector<Vec2> p = plan.points;
    const auto endError = [&](const Vec2& end, const Vec2& next, bool broken) -> Vec2 {
        Vec2 error = random.inDisc(level.endErrorPx);
        if (!broken) return error;
        const Vec2 along = (next - end).normalized();
        return error - error.dot(along) * along;
    };
    const std::size_t n = p.size();
    p.front() += endError(plan.points[0], plan.points[1], plan.brokenStart);
    for (std::size_t i = 1; i + 1 < n; ++i) p[i] += random.inDisc(level.endErrorPx / 2.0);
    p.back() += endError(plan.points[n - 1], plan.points[n - 2], plan.brokenEnd);
    if (overshootPx > 0.0) {
        const Vec2 back = (p[0] - p[1]).normalized();
        const Vec2 on = (p[n - 1] - p[n - 2]).normalized();
        p.front() += random.uniform(0.0, overshootPx) * back;
        p.back() += random.uniform(0.0, overshootPx) * on;
    }
    return p;
}

/// Lines as arcs: a polyline through every line's arc, and which of its points are corners.
struct BowedLines {
    std::vector<Vec2> points;
    std::vector<bool> corner;
};

BowedLines bow(const std::vector<Vec2>& p, double share, Random& random) {
    constexpr int kPieces = 12;
    BowedLines out{{p.front()}, {true}};
    for (std::size_t i = 1; i < p.size(); ++i) {
        const Vec2 d = p[i] - p[i - 1];
        const Vec2 side(-d.y(), d.x());
        const double height = random.uniform(-share, share);
        for (int k = 1; k < kPieces; ++k) {
            const double t = static_cast<double>(k) / kPieces;
            out.points.emplace_back(p[i - 1] + t * d + 4.0 * t * (1.0 - t) * height * side);
            out.corner.push_back(false);
        }
        out.points.push_back(p[i]);
        out.corner.push_back(true);
    }
    return out;
}

Path roundCorners(const BowedLines& lines, double radiusPx) {
    constexpr int kPieces = 8;
    const std::vector<Vec2>& p = lines.points;
    Path path;
    path.add(p.front());
    path.slow.push_back({0.0, 1.0});
    for (std::size_t i = 1; i + 1 < p.size(); ++i) {
        if (!lines.corner[i]) {
            path.add(p[i]);
            continue;
        }
        const Vec2 in = p[i] - p[i - 1];
        const Vec2 out = p[i + 1] - p[i];
        // The wobble is an offset to one side, and the sides trade places where the pen turns back;
        // fading it by the turn keeps the line in one piece.
        const double fade = (1.0 - in.normalized().dot(out.normalized())) / 2.0;
        const double cut = std::min({radiusPx, 0.2 * in.norm(), 0.2 * out.norm()});
        if (cut <= 0.0) {
            path.add(p[i]);
            path.slow.push_back({path.total(), fade});
            continue;
        }
        const Vec2 a = p[i] - cut * in.normalized();
        const Vec2 b = p[i] + cut * out.normalized();
        const double before = path.total() + (a - path.points.back()).norm();
        for (int k = 0; k <= kPieces; ++k) {
            const double t = static_cast<double>(k) / kPieces;
            path.add((1 - t) * (1 - t) * a + 2 * t * (1 - t) * p[i] + t * t * b);
        }
        path.slow.push_back({(before + path.total()) / 2.0, fade});
    }
    path.add(p.back());
    path.slow.push_back({path.total(), 1.0});
    return path;
}

struct TimedLength {
    double s = 0.0;  ///< arc length [px]
    double timeMs = 0.0;
};

/// When the pen is where: samples at a fixed period, closer together where the pen is slow.
std::vector<TimedLength> paceAlong(const Path& path, bool exact, const HandHabits& habits,
                                   Random& random) {
    const double cruise = random.uniform(habits.cruisePx[0], habits.cruisePx[1]);
    std::vector<TimedLength> pace;
    double time = 0.0;
    for (double s = 0.0; s < path.total(); time += habits.samplePeriodMs) {
        pace.push_back({s, time});
        const double ease = smoothStep(path.toNearestSlow(s) / kSlowPx);
        s += cruise * (kSlowest + (1.0 - kSlowest) * ease);
    }
    pace.push_back({path.total(), time});
    if (!exact) return pace;
    // An exact hand has a sample on every corner, as a pen that stops there has.
    for (std::size_t c = 1; c + 1 < path.slow.size(); ++c) {
        const double corner = path.slow[c].s;
        const auto after = std::find_if(pace.begin(), pace.end(),
                                        [&](const TimedLength& t) { return t.s >= corner; });
        const double at = (after->timeMs + (after - 1)->timeMs) / 2.0;
        pace.insert(after, {corner, at});
    }
    const auto tooNear = [&](const TimedLength& t) {
        const double d = path.toNearestSlow(t.s);
        return d > 0.0 && d < kShortestStepPx;
    };
    pace.erase(std::remove_if(pace.begin(), pace.end(), tooNear), pace.end());
    return pace;
}

/// A flick before pen-down is steady or after the pen has left: three samples in a line.
void addHook(std::vector<PenSample>& samples, bool atStart, double hookPx, double periodMs,
             Random& random) {
    const PenSample anchor = atStart ? samples.front() : samples.back();
    const Vec2 flick = random.uniform(0.5, 1.0) * hookPx * random.direction();
    constexpr int kSteps = 3;
    if (atStart) {
        for (PenSample& s : samples) s.timeMs += kSteps * periodMs;
        for (int k = 1; k <= kSteps; ++k) {
            samples.insert(samples.begin(),
                           {anchor.position + flick * k / kSteps, 0.15, (kSteps - k) * periodMs});
        }
    } else {
        for (int k = 1; k <= kSteps; ++k) {
            samples.push_back(
                {anchor.position + flick * k / kSteps, 0.15, anchor.timeMs + k * periodMs});
        }
    }
}

/// What a mouse or a plain script leaves of a stroke.
void asTheDeviceSays(Stroke& stroke, const HandHabits& habits) {
    for (PenSample& s : stroke.samples) {
        if (habits.gridPx > 0.0) {
            s.position = habits.gridPx * (s.position / habits.gridPx).array().round().matrix();
        }
        if (habits.timed) continue;
        s.pressure = kNoPressure;
        s.timeMs = 0.0;
    }
}

Stroke drawStroke(const PlannedStroke& plan, const HandLevel& level, const HandHabits& habits,
                  Random& random) {
    const bool exact = level.wobblePx == 0.0 && level.endErrorPx == 0.0;
    const std::vector<Vec2> aims = misplace(plan, level, exact ? 0.0 : habits.overshootPx, random);
    if (habits.cornersOnly) {
        Stroke corners;
        for (const Vec2& p : aims) corners.samples.push_back({p, kNoPressure, 0.0});
        return corners;
    }
    const BowedLines lines = exact || habits.bowShare == 0.0
                                 ? BowedLines{aims, std::vector<bool>(aims.size(), true)}
                                 : bow(aims, habits.bowShare, random);
    const Path path = roundCorners(lines, 1.5 * level.wobblePx);
    const SmoothNoise wobble(random);
    Stroke stroke;
    Vec2 tremor = Vec2::Zero();
    for (const TimedLength& t : paceAlong(path, exact, habits, random)) {
        Vec2 normal;
        Vec2 p = path.at(t.s, normal);
        const double toEnd = std::min(t.s, path.total() - t.s);
        if (!exact) {
            p += level.wobblePx * path.wobbleAt(t.s) * wobble.at(t.s) * normal;
            // First-order autoregression with unit variance: neighbours half correlated.
            tremor = 0.5 * tremor + std::sqrt(0.75) * Vec2(random.normal(), random.normal());
            p += 0.1 * level.wobblePx * tremor;
        }
        stroke.samples.push_back({p, 0.25 + 0.5 * smoothStep(toEnd / 40.0), t.timeMs});
    }
    if (level.hookPx > 0.0) {
        for (const bool atStart : {true, false}) {
            if (!random.chance(habits.hookProbability)) continue;
            addHook(stroke.samples, atStart, level.hookPx, habits.samplePeriodMs, random);
        }
    }
    asTheDeviceSays(stroke, habits);
    return stroke;
}

HandHabits mouse() {
    HandHabits h;
    h.cruisePx = {10.0, 24.0};
    h.gridPx = 1.0;
    h.timed = false;
    return h;
}

HandHabits designer() {
    HandHabits h;
    h.bowShare = 0.015;
    h.overshootPx = 10.0;
    return h;
}

HandHabits vectorDrawing() {
    HandHabits h;
    h.cornersOnly = true;
    h.timed = false;
    return h;
}

}  // namespace

const std::array<HandStyle, 4>& handStyles() {
    static const std::array<HandStyle, 4> styles{
        {{"pen", {}}, {"mouse", mouse()}, {"designer", designer()}, {"vector", vectorDrawing()}}};
    return styles;
}

std::vector<Stroke> drawByHand(const std::vector<Line2>& lines, const HandLevel& level,
                               Random& random, const HandHabits& habits) {
    std::vector<Stroke> strokes;
    for (const PlannedStroke& plan : planStrokes(lines, level, habits, random)) {
        strokes.push_back(drawStroke(plan, level, habits, random));
    }
    return strokes;
}

}  // namespace ew
