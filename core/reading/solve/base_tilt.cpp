// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/base_tilt.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace ew {
namespace {

double gauss(double off) { return std::exp(-0.5 * off * off); }

/// Of the polygon of a base that is turned from the eye about the normal of `along`: it is drawn
/// shorter along that direction by this factor.
std::vector<Vec2> unfolded(const std::vector<Vec2>& polygon, const Vec2& along, double factor) {
    const Vec2 across(-along.y(), along.x());
    std::vector<Vec2> out;
    for (const Vec2& p : polygon) out.emplace_back(p.dot(across), factor * p.dot(along));
    return out;
}

}  // namespace

std::optional<double> foreshortening(const std::vector<Vec2>& base, const Vec2& axis,
                                     double spread) {
    const Vec2 along = axis.normalized();
    const Vec2 across(-along.y(), along.x());
    const std::size_t n = base.size();
    std::vector<Vec2> edges;
    for (std::size_t k = 0; k < n; ++k) edges.push_back(base[(k + 1) % n] - base[k]);
    std::vector<double> tries;
    for (std::size_t a = 0; a < n; ++a) {
        for (std::size_t b = a + 1; b < n; ++b) {
            const double ap = edges[a].dot(along), ac = edges[a].dot(across);
            const double bp = edges[b].dot(along), bc = edges[b].dot(across);
            const double right = -(ac * bc) / (ap * bp);
            if (std::isfinite(right)) tries.push_back(right);
            const double equal = (bc * bc - ac * ac) / (ap * ap - bp * bp);
            if (std::isfinite(equal)) tries.push_back(equal);
        }
    }
    double best = -1.0;
    std::optional<double> out;
    const auto consider = [&](double factor) {
        // Seen from 8 to 82 degrees above the base; farther it looks like a line or hides all.
        if (!(factor > 1.01 && factor < 7.2)) return;
        const double score = regularity(unfolded(base, along, factor), spread * std::sqrt(factor));
        if (score <= best) return;
        best = score;
        out = factor;
    };
    for (const double square : tries) {
        if (square > 0.0) consider(std::sqrt(square));
    }
    for (int deg = 15; deg <= 75; deg += 5) {
        consider(1.0 / std::sin(deg * std::numbers::pi / 180.0));
    }
    return out;
}

double regularity(const std::vector<Vec2>& polygon, double spread) {
    const std::size_t n = polygon.size();
    std::vector<double> lengths, turns;
    Vec2 middle = Vec2::Zero();
    for (std::size_t k = 0; k < n; ++k) {
        const Vec2 in = polygon[k] - polygon[(k + n - 1) % n];
        const Vec2 out = polygon[(k + 1) % n] - polygon[k];
        lengths.push_back(out.norm());
        turns.push_back(std::atan2(cross2(in, out), in.dot(out)));
        middle += polygon[k] / static_cast<double>(n);
    }
    const double mean = std::max(
        spread, std::accumulate(lengths.begin(), lengths.end(), 0.0) / static_cast<double>(n));
    const double angle = 1.5 * spread / mean + 0.01;
    const double length = 1.5 * spread + 0.01 * mean;
    double score = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
        score += gauss((std::abs(turns[k]) - std::numbers::pi / 2.0) / angle);
        const std::size_t next = (k + 1) % n;
        score += 1.2 * gauss((turns[k] - turns[next]) / angle);
        score += 0.6 * gauss((lengths[k] - lengths[next]) / length);
    }
    double mirror = 0.0;
    // Mirror lines go through a corner or the middle of a side, and through the middle.
    for (std::size_t m = 0; m < n; ++m) {
        double corner = 0.0, side = 0.0;
        for (std::size_t k = 0; k < n; ++k) {
            const auto off = [&](std::size_t a, std::size_t b) {
                return gauss(((polygon[a] - middle).norm() - (polygon[b] - middle).norm()) /
                             length);
            };
            corner += off((m + k) % n, (m + n - k) % n);
            side += off((m + k) % n, (m + 2 * n - 1 - k) % n);
        }
        mirror = std::max({mirror, corner / static_cast<double>(n), side / static_cast<double>(n)});
    }
    return score + 0.6 * static_cast<double>(n) * mirror;
}

}  // namespace ew
