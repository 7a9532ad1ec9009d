// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stroke/rounded_corners.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace ew {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kMuchShorter = 2.0;  ///< ratio of sides and pieces of corners
constexpr double kLeastSides = 0.6;   ///< share of the ink
constexpr double kLeastTurn = 25.0;   ///< between two sides [degrees]
constexpr double kMostTurn = 135.0;   ///< between two sides [degrees]
constexpr double kSideEnd = 0.25;     ///< share of a side that a curve may have bent
constexpr double kMostOfSide = 1.0;   ///< of what is left of a side, that a corner takes away
constexpr double kBetter = 0.7;       ///< rms of circle and lines, at most
constexpr double kAsGood = 1.5;       ///< the same where there are two short pieces or more
constexpr double kAsGoodPx = 0.3;     ///< ... and this much more
constexpr double kLeastRadius = 3.0;  ///< [px]
constexpr double kStraightPx = 2.5;   ///< ink farther from a side's line is part of a curve
constexpr double kSpacingPx = 1.6;    ///< of ink that is added
constexpr int kRadii = 32;

/// Signed turn from one direction to another [radians].
double turnOf(const Vec2& u, const Vec2& v) { return std::atan2(cross2(u, v), u.dot(v)); }

struct Line {
    Vec2 point = Vec2::Zero();
    Vec2 direction = Vec2(1, 0);  ///< unit, as it was drawn

    double off(const Vec2& p) const { return std::abs(cross2(direction, Vec2(p - point))); }
    Vec2 nearest(const Vec2& p) const { return point + direction * (p - point).dot(direction); }
};

std::optional<Vec2> meeting(const Line& a, const Line& b) {
    const double sine = cross2(a.direction, b.direction);
    if (std::abs(sine) < 1e-6) return std::nullopt;
    return Vec2(a.point + a.direction * (cross2(Vec2(b.point - a.point), b.direction) / sine));
}

/// The length between sides and pieces of corners; nothing where they are not far apart.
std::optional<double> leastSide(const std::vector<Segment>& pieces) {
    std::vector<double> lengths;
    for (const Segment& s : pieces) lengths.push_back(std::max(s.inkPx, 1e-9));
    std::sort(lengths.begin(), lengths.end());
    double widest = kMuchShorter;
    std::optional<double> least;
    for (std::size_t i = 1; i < lengths.size(); ++i) {
        if (lengths[i] / lengths[i - 1] < widest) continue;
        widest = lengths[i] / lengths[i - 1];
        least = lengths[i];
    }
    return least;
}

class Squarer {
  public:
    Squarer(std::vector<Segment>& pieces, const CutStroke& stroke)
        : pieces_(pieces), stroke_(stroke) {}

    bool run() {
        if (!findSides()) return false;
        std::vector<Segment> squared = pieces_;
        std::vector<bool> gone(pieces_.size(), false);
        bool any = false;
        const std::size_t corners = stroke_.closed ? sides_.size() : sides_.size() - 1;
        for (std::size_t c = 0; c < corners; ++c) {
            const std::size_t next = (c + 1) % sides_.size();
            const std::vector<std::size_t> between = piecesBetween(sides_[c], sides_[next]);
            if (between.empty()) {
                // Flat sides of an ellipse; but both ends of a stroke may be on one side.
                const double turn = turnOf(lines_[c].direction, lines_[next].direction);
                if (next > c && std::abs(turn) < kLeastTurn * kDegree) return false;
                continue;
            }
            const auto x = corner(c, next, between);
            if (!x) continue;
            Segment& before = squared[sides_[c]];
            Segment& after = squared[sides_[next]];
            if (before.a == pieces_[sides_[c]].a) before.a = lines_[c].nearest(before.a);
            if (after.b == pieces_[sides_[next]].b) after.b = lines_[next].nearest(after.b);
            before.b = *x;
            before.joinedToNext = c < next;
            after.a = *x;
            for (const std::size_t i : between) gone[i] = true;
            any = true;
        }
        if (!any) return false;
        for (std::size_t c = 0; c < sides_.size(); ++c) straighten(squared[sides_[c]], lines_[c]);
        pieces_.clear();
        for (std::size_t i = 0; i < squared.size(); ++i) {
            if (!gone[i]) pieces_.push_back(std::move(squared[i]));
        }
        return true;
    }

  private:
    /// The ink of a side as it would be without rounded corners.
    static void straighten(Segment& side, const Line& line) {
        const double length = (side.b - side.a).norm();
        const Vec2 d = (side.b - side.a) / std::max(length, 1e-9);
        std::erase_if(side.points, [&](const Vec2& p) { return line.off(p) > kStraightPx; });
        std::vector<Vec2> ink;
        double from = 0.0;
        const auto fill = [&](double to) {
            const int steps = static_cast<int>((to - from) / kSpacingPx);
            for (int k = 1; k < steps; ++k) ink.push_back(side.a + d * (from + k * kSpacingPx));
        };
        for (const Vec2& p : side.points) {
            fill((p - side.a).dot(d));
            ink.push_back(p);
            from = std::max(from, (p - side.a).dot(d));
        }
        fill(length);
        side.points = std::move(ink);
        side.inkPx = length;
        if (side.points.empty()) side.points = {side.a, side.b};
        side.rmsPx = fitLine(side.points).rmsPx;
    }

    bool findSides() {
        const auto least = leastSide(pieces_);
        if (!least) return false;
        double ink = 0.0;
        double inSides = 0.0;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            ink += pieces_[i].inkPx;
            if (pieces_[i].inkPx < *least) continue;
            inSides += pieces_[i].inkPx;
            sides_.push_back(i);
            lines_.push_back(middleLine(i));
        }
        return sides_.size() >= 2 && inSides >= kLeastSides * ink;
    }

    /// The line of a side without its ends, which curves may have bent.
    Line middleLine(std::size_t piece) const {
        const std::size_t from = stroke_.cuts[piece];
        const std::size_t to = stroke_.cuts[piece + 1];
        const auto end = static_cast<std::size_t>(kSideEnd * static_cast<double>(to - from));
        const std::vector<Vec2> middle(
            stroke_.nodes.begin() + static_cast<std::ptrdiff_t>(from + end),
            stroke_.nodes.begin() + static_cast<std::ptrdiff_t>(to - end + 1));
        const LineFit fit = fitLine(middle);
        const Vec2 drawn = middle.back() - middle.front();
        return {fit.center, drawn.dot(fit.direction) < 0.0 ? Vec2(-fit.direction) : fit.direction};
    }

    std::vector<std::size_t> piecesBetween(std::size_t before, std::size_t after) const {
        std::vector<std::size_t> out;
        for (std::size_t i = (before + 1) % pieces_.size(); i != after;
             i = (i + 1) % pieces_.size()) {
            out.push_back(i);
        }
        return out;
    }

    /// Where two sides meet in front of a rounded corner; nothing where it is none.
    std::optional<Vec2> corner(std::size_t c, std::size_t next,
                               const std::vector<std::size_t>& between) const {
        const Line& before = lines_[c];
        const Line& after = lines_[next];
        const double turn = turnOf(before.direction, after.direction);
        if (std::abs(turn) < kLeastTurn * kDegree || std::abs(turn) > kMostTurn * kDegree) {
            return std::nullopt;
        }
        const auto x = meeting(before, after);
        if (!x) return std::nullopt;
        const double most =
            kMostOfSide * std::min(pieces_[sides_[c]].inkPx, pieces_[sides_[next]].inkPx);
        const Vec2 start = stroke_.nodes[stroke_.cuts[between.front()]];
        const Vec2 end = stroke_.nodes[stroke_.cuts[between.back() + 1]];
        const double zone = 1.5 * std::max((*x - start).norm(), (*x - end).norm());
        if (zone > 2.0 * most || before.direction.dot(*x - start) < 0.0) return std::nullopt;
        const std::vector<Vec2> ink = inkAround(sides_[c], sides_[next], between, *x, zone);
        if (ink.size() < 4) return std::nullopt;
        const double lines = rmsOf(ink, [&](const Vec2& p) {
            double off = std::min(before.off(p), after.off(p));
            for (const std::size_t i : between) {
                const Segment& s = pieces_[i];
                off = std::min(off, Line{s.a, (s.b - s.a).normalized()}.off(p));
            }
            return off;
        });
        // Several pieces that turn one way follow any curve closely.
        const double limit = between.size() == 1 ? kBetter * lines : kAsGood * lines + kAsGoodPx;
        if (bestCircle(ink, before, after, *x, turn, most) > limit) return std::nullopt;
        return x;
    }

    /// The ink near a corner, in order.
    std::vector<Vec2> inkAround(std::size_t before, std::size_t after,
                                const std::vector<std::size_t>& between, const Vec2& x,
                                double zone) const {
        std::vector<Vec2> out;
        std::vector<std::size_t> all{before};
        all.insert(all.end(), between.begin(), between.end());
        all.push_back(after);
        for (const std::size_t i : all) {
            for (std::size_t n = stroke_.cuts[i]; n <= stroke_.cuts[i + 1]; ++n) {
                if ((stroke_.nodes[n] - x).norm() < zone) out.push_back(stroke_.nodes[n]);
            }
        }
        return out;
    }

    template <class Off>
    static double rmsOf(const std::vector<Vec2>& ink, const Off& off) {
        double sum = 0.0;
        for (const Vec2& p : ink) sum += off(p) * off(p);
        return std::sqrt(sum / static_cast<double>(ink.size()));
    }

    /// Rms distance of the ink to two sides and a circle that touches both, of the best radius.
    static double bestCircle(const std::vector<Vec2>& ink, const Line& before, const Line& after,
                             const Vec2& x, double turn, double mostBack) {
        const double tangent = std::tan(0.5 * std::abs(turn));
        const double most = mostBack / tangent;
        const Vec2 side =
            (turn > 0.0 ? 1.0 : -1.0) * Vec2(-before.direction.y(), before.direction.x());
        double best = std::numeric_limits<double>::infinity();
        for (int k = 0; k < kRadii; ++k) {
            const double radius =
                kLeastRadius * std::pow(most / kLeastRadius, static_cast<double>(k) / (kRadii - 1));
            const Vec2 from = x - before.direction * (radius * tangent);
            const Vec2 to = x + after.direction * (radius * tangent);
            const Vec2 center = from + radius * side;
            best = std::min(best, rmsOf(ink, [&](const Vec2& p) {
                                if ((p - from).dot(before.direction) < 0.0) return before.off(p);
                                if ((p - to).dot(after.direction) > 0.0) return after.off(p);
                                return std::abs((p - center).norm() - radius);
                            }));
        }
        return best;
    }

    std::vector<Segment>& pieces_;
    const CutStroke& stroke_;
    std::vector<std::size_t> sides_;  ///< pieces, ascending
    std::vector<Line> lines_;         ///< of the sides
};

}  // namespace

bool squareRoundedCorners(std::vector<Segment>& pieces, const CutStroke& stroke) {
    return Squarer(pieces, stroke).run();
}

}  // namespace ew
