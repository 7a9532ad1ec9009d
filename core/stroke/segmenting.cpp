// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stroke/segmenting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/base/tolerance.h"
#include "core/stroke/partition.h"
#include "core/stroke/rounded_corners.h"

namespace ew {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr std::size_t kMaxNodes = 1500;

/// Consecutive duplicates removed.
std::vector<Vec2> distinctPoints(const Stroke& stroke) {
    std::vector<Vec2> points;
    points.reserve(stroke.samples.size());
    for (const PenSample& s : stroke.samples) {
        if (points.empty() || (s.position - points.back()).norm() > tol::kSamePointPx) {
            points.push_back(s.position);
        }
    }
    return points;
}

double pathLength(const std::vector<Vec2>& points) {
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
    return length;
}

double extent(const std::vector<Vec2>& points) {
    Eigen::AlignedBox2d box;
    for (const Vec2& p : points) box.extend(p);
    return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

/// Evenly spaced points along the path; vertices between two long straight runs are kept, so that
/// an exact polyline keeps its exact corners.
std::vector<Vec2> resample(const std::vector<Vec2>& points, double spacing) {
    std::vector<Vec2> out{points.front()};
    double carried = 0;  // arc length since the last emitted point
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec2 a = points[i - 1];
        const Vec2 d = points[i] - a;
        const double len = d.norm();
        double t = spacing - carried;
        for (; t < len - 1e-6 * spacing; t += spacing) out.push_back(a + d * (t / len));
        carried = len - (t - spacing);
        const bool longBefore = len >= 0.7 * spacing;
        const bool longAfter =
            i + 1 < points.size() && (points[i + 1] - points[i]).norm() >= 0.7 * spacing;
        if (i + 1 == points.size() || (longBefore && longAfter)) {
            out.push_back(points[i]);
            carried = 0;
        }
    }
    return out;
}

/// Number of leading points that belong to a pen hook.
std::size_t hookLength(const std::vector<Vec2>& nodes) {
    // Direction of the line behind the hook's reach.
    double arc = 0;
    std::size_t from = 0;
    std::size_t to = 0;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        arc += (nodes[i] - nodes[i - 1]).norm();
        if (from == 0 && arc >= tol::kHookReachPx) from = i;
        if (arc >= 3.2 * tol::kHookReachPx) {
            to = i;
            break;
        }
    }
    if (from == 0 || to <= from) return 0;
    const Vec2 main = (nodes[to] - nodes[from]).normalized();
    const double cosLimit = std::cos(tol::kHookAngleDeg * kDegree);
    std::size_t hook = 0;
    for (std::size_t i = 0; i < from; ++i) {
        const Vec2 step = nodes[i + 1] - nodes[i];
        if (step.dot(main) < cosLimit * step.norm()) hook = i + 1;
    }
    // What still goes its own way at the end of the reach is an edge.
    return hook < from ? hook : 0;
}

void trimHooks(std::vector<Vec2>& nodes) {
    const double length = pathLength(nodes);
    if (length < 4 * tol::kHookReachPx) return;
    const std::size_t front = hookLength(nodes);
    nodes.erase(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(front));
    std::reverse(nodes.begin(), nodes.end());
    const std::size_t back = hookLength(nodes);
    nodes.erase(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(back));
    std::reverse(nodes.begin(), nodes.end());
}

Segment makeSegment(const std::vector<Vec2>& nodes, std::size_t first, std::size_t last, int stroke,
                    double spacing) {
    Segment s;
    s.stroke = stroke;
    const std::vector<Vec2> all(nodes.begin() + static_cast<std::ptrdiff_t>(first),
                                nodes.begin() + static_cast<std::ptrdiff_t>(last + 1));
    s.inkPx = pathLength(all);
    // Ink beside a corner is rounded off by the hand, and the node next to it may lie beyond the
    // true corner: the fit leaves a little out.
    const bool cornerBefore = first > 0;
    const bool cornerAfter = last + 1 < nodes.size();
    const double margin = std::max(1.01 * spacing, std::min(5.0, 0.12 * s.inkPx));
    std::size_t lo = 0;
    std::size_t hi = all.size();
    for (double arc = 0; cornerBefore && lo + 3 < hi && arc < margin; ++lo) {
        arc += (all[lo + 1] - all[lo]).norm();
    }
    for (double arc = 0; cornerAfter && lo + 3 < hi && arc < margin; --hi) {
        arc += (all[hi - 1] - all[hi - 2]).norm();
    }
    s.points.assign(all.begin() + static_cast<std::ptrdiff_t>(lo),
                    all.begin() + static_cast<std::ptrdiff_t>(hi));
    const LineFit fit = fitLine(s.points);
    s.rmsPx = fit.rmsPx;
    const Vec2 dir =
        (all.back() - all.front()).dot(fit.direction) < 0 ? Vec2(-fit.direction) : fit.direction;
    double tMin = std::numeric_limits<double>::infinity();
    double tMax = -tMin;
    for (const Vec2& p : all) {
        const double t = (p - fit.center).dot(dir);
        tMin = std::min(tMin, t);
        tMax = std::max(tMax, t);
    }
    s.a = fit.center + dir * tMin;
    s.b = fit.center + dir * tMax;
    return s;
}

/// The pen went through the corner between two pieces, so both end where their lines meet.
void meetAtCorner(Segment& before, Segment& after, double distancePx) {
    const Vec2 u = before.b - before.a;
    const Vec2 v = after.b - after.a;
    const double sine = cross2(u.normalized(), v.normalized());
    if (std::abs(sine) < 0.05) return;
    const double t = cross2(after.a - before.a, v) / cross2(u, v);
    const Vec2 x = before.a + t * u;
    // The flatter the corner the less the lines say where it is.
    const double reach = distancePx * std::min(1.0, 4 * std::abs(sine));
    if ((x - before.b).norm() > reach || (x - after.a).norm() > reach) return;
    before.b = x;
    after.a = x;
}

double angleBetween(const Vec2& u, const Vec2& v) {
    return std::abs(std::atan2(cross2(u, v), u.dot(v)));
}

/// Share of the turn at a corner that happens close to it: near 1 for a corner, near 0.3 on a
/// circle.
double sharpness(const std::vector<Vec2>& nodes, std::size_t i, std::size_t j, std::size_t k) {
    auto direction = [&](std::size_t from, std::size_t to) {
        std::vector<Vec2> part(nodes.begin() + static_cast<std::ptrdiff_t>(from),
                               nodes.begin() + static_cast<std::ptrdiff_t>(to + 1));
        const LineFit f = fitLine(part);
        Vec2 d = f.direction;
        return (part.back() - part.front()).dot(d) < 0 ? Vec2(-d) : d;
    };
    const double whole = angleBetween(direction(i, j), direction(j, k));
    const std::size_t before = std::max<std::size_t>(2, (j - i) / 3);
    const std::size_t after = std::max<std::size_t>(2, (k - j) / 3);
    const double local = angleBetween(direction(j >= before ? j - before : 0, j),
                                      direction(j, std::min(j + after, nodes.size() - 1)));
    return whole < 1e-6 ? 1.0 : local / whole;
}

/// True where the corners between the pieces are spread out, as on an arc.
bool looksCurved(const std::vector<Vec2>& nodes, const std::vector<std::size_t>& cuts) {
    const std::size_t pieces = cuts.size() - 1;
    if (pieces < 2) return false;
    double turn = 0;
    double signedTurn = 0;
    std::vector<double> sharp;
    for (std::size_t c = 1; c + 1 < cuts.size(); ++c) {
        const Vec2 u = nodes[cuts[c]] - nodes[cuts[c - 1]];
        const Vec2 v = nodes[cuts[c + 1]] - nodes[cuts[c]];
        const double t = std::atan2(cross2(u, v), u.dot(v));
        turn += std::abs(t);
        signedTurn += t;
        sharp.push_back(sharpness(nodes, cuts[c - 1], cuts[c], cuts[c + 1]));
    }
    if (turn < 40 * kDegree || std::abs(signedTurn) < 0.8 * turn) return false;
    std::nth_element(sharp.begin(), sharp.begin() + static_cast<std::ptrdiff_t>(sharp.size() / 2),
                     sharp.end());
    return sharp[sharp.size() / 2] < tol::kCornerSharpness;
}

/// A line is longer than it is wide: a small circle is none, though no corner was found in it.
bool isRing(const std::vector<Segment>& segments) {
    constexpr double kWidest = 0.2;
    return segments.size() == 1 &&
           segments[0].rmsPx > kWidest * (segments[0].b - segments[0].a).norm();
}

/// Drops pieces that only a rounded corner or a hook made, and corners that hardly turn.
class CutCleaner {
  public:
    CutCleaner(const std::vector<Vec2>& nodes, std::vector<std::size_t>& cuts, double distancePx,
               double wobblePx)
        : nodes_(nodes),
          cuts_(cuts),
          distancePx_(distancePx),
          wobblePx_(wobblePx),
          arc_(nodes.size()) {
        for (std::size_t i = 1; i < nodes.size(); ++i) {
            arc_[i] = arc_[i - 1] + (nodes[i] - nodes[i - 1]).norm();
        }
    }
    void run() {
        while (cuts_.size() > 2 && (dropTiny() || dropStraight())) {
        }
    }

  private:
    Vec2 chord(std::size_t c) const { return nodes_[cuts_[c + 1]] - nodes_[cuts_[c]]; }
    double ink(std::size_t c) const { return arc_[cuts_[c + 1]] - arc_[cuts_[c]]; }

    bool dropTiny() {
        for (std::size_t c = 0; c + 1 < cuts_.size(); ++c) {
            const bool first = c == 0;
            const bool last = c + 2 == cuts_.size();
            double neighbour = std::numeric_limits<double>::infinity();
            if (!first) neighbour = ink(c - 1);
            if (!last) neighbour = std::min(neighbour, ink(c + 1));
            if (ink(c) >= 0.5 * distancePx_ || ink(c) >= 0.35 * neighbour) continue;
            if (first) {
                cuts_.erase(cuts_.begin());
            } else if (last) {
                cuts_.pop_back();
            } else {
                // A chamfer inside a rounded corner: one corner in its middle.
                cuts_[c] = (cuts_[c] + cuts_[c + 1]) / 2;
                cuts_.erase(cuts_.begin() + static_cast<std::ptrdiff_t>(c + 1));
            }
            return true;
        }
        return false;
    }

    bool dropStraight() {
        for (std::size_t c = 1; c + 1 < cuts_.size(); ++c) {
            // A piece that goes there and back has no direction to compare.
            if (chord(c - 1).norm() < 0.7 * ink(c - 1) || chord(c).norm() < 0.7 * ink(c)) continue;
            const double turn = angleBetween(chord(c - 1), chord(c));
            const bool wobble = turn < tol::kWobbleTurnDeg * kDegree &&
                                runRms(nodes_, cuts_[c - 1], cuts_[c + 1]) < 1.3 * wobblePx_;
            if (turn < tol::kMinCornerDeg * kDegree || wobble) {
                cuts_.erase(cuts_.begin() + static_cast<std::ptrdiff_t>(c));
                return true;
            }
        }
        return false;
    }

    const std::vector<Vec2>& nodes_;
    std::vector<std::size_t>& cuts_;
    double distancePx_;
    double wobblePx_;
    std::vector<double> arc_;
};

/// How many pairs of straight pieces that do not follow one another cross.
std::size_t crossingsOf(const std::vector<Segment>& segments) {
    std::size_t count = 0;
    const auto apart = [](const Segment& s, const Segment& other) {
        const Vec2 d = s.b - s.a;
        return cross2(d, other.a - s.a) * cross2(d, other.b - s.a) < 0.0;
    };
    for (std::size_t i = 0; i < segments.size(); ++i) {
        for (std::size_t k = i + 2; k < segments.size(); ++k) {
            count += apart(segments[i], segments[k]) && apart(segments[k], segments[i]) ? 1 : 0;
        }
    }
    return count;
}

bool isScribble(const std::vector<Vec2>& nodes, const std::vector<std::size_t>& cuts,
                const std::vector<Segment>& segments, double distancePx) {
    const double length = pathLength(nodes);
    const double diagonal = extent(nodes);
    double rms = 0;
    std::vector<double> lengths;
    for (const Segment& s : segments) {
        rms += s.rmsPx * s.rmsPx * s.inkPx;
        lengths.push_back((s.b - s.a).norm());
    }
    rms = std::sqrt(rms / std::max(length, 1e-9));
    std::nth_element(lengths.begin(),
                     lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2),
                     lengths.end());
    const double median = lengths[lengths.size() / 2];
    if (rms > 0.6 * distancePx) return true;
    if (cuts.size() > 36) return true;
    if (segments.size() >= 7 && median < 1.4 * distancePx) return true;
    // A solid with its hidden lines drawn in one stroke crosses itself a few times.
    if (segments.size() >= 8 && crossingsOf(segments) > segments.size()) return true;
    return segments.size() >= 5 && length > 14.0 * diagonal;
}

}  // namespace

LineFit fitLine(const std::vector<Vec2>& points) {
    LineFit fit;
    const double n = static_cast<double>(points.size());
    for (const Vec2& p : points) fit.center += p;
    fit.center /= n;
    double xx = 0;
    double yy = 0;
    double xy = 0;
    for (const Vec2& p : points) {
        const Vec2 d = p - fit.center;
        xx += d.x() * d.x();
        yy += d.y() * d.y();
        xy += d.x() * d.y();
    }
    const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
    fit.direction = {std::cos(angle), std::sin(angle)};
    double ss = 0;
    for (const Vec2& p : points) {
        const Vec2 d = p - fit.center;
        const double t = d.dot(fit.direction);
        const double off = cross2(fit.direction, d);
        ss += off * off;
        fit.tMin = std::min(fit.tMin, t);
        fit.tMax = std::max(fit.tMax, t);
    }
    fit.rmsPx = std::sqrt(ss / n);
    return fit;
}

StrokeReading readStroke(const Stroke& stroke, int index, double distancePx, double wobblePx) {
    StrokeReading reading;
    const std::vector<Vec2> points = distinctPoints(stroke);
    if (points.empty() || extent(points) < tol::kDotExtent * distancePx) {
        reading.kind = StrokeKind::Dot;
        reading.outline = points;
        return reading;
    }
    const double length = pathLength(points);
    const double spacing = std::max(length / static_cast<double>(kMaxNodes), 1.6);
    std::vector<Vec2> nodes = resample(points, spacing);
    reading.outline = nodes;
    trimHooks(nodes);

    std::vector<std::size_t> cuts = optimalPartition(nodes, wobblePx);
    CutCleaner(nodes, cuts, distancePx, wobblePx).run();
    refineCuts(nodes, cuts);
    // Two cuts may have moved to one corner.
    const std::size_t before = cuts.size();
    CutCleaner(nodes, cuts, distancePx, wobblePx).run();
    if (cuts.size() < before) refineCuts(nodes, cuts);
    for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
        reading.segments.push_back(makeSegment(nodes, cuts[c], cuts[c + 1], index, spacing));
        reading.segments.back().joinedToNext = c + 2 < cuts.size();
        if (c > 0) meetAtCorner(reading.segments[c - 1], reading.segments[c], distancePx);
    }
    const bool closed = (nodes.front() - nodes.back()).norm() < 0.5 * distancePx;
    const bool squared = squareRoundedCorners(reading.segments, {nodes, cuts, closed});
    if (isScribble(nodes, cuts, reading.segments, distancePx)) {
        reading.kind = StrokeKind::Scribble;
    } else if (squared) {
        reading.kind = StrokeKind::Polyline;
    } else if (looksCurved(nodes, cuts) || isRing(reading.segments)) {
        reading.kind = StrokeKind::Curve;
    }
    if (reading.kind != StrokeKind::Polyline) reading.segments.clear();
    return reading;
}

}  // namespace ew
