// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stroke/partition.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/tolerance.h"

namespace ew {
namespace {

constexpr std::size_t kMaxPieces = 40;
constexpr std::size_t kMaxCandidates = 90;

/// Prefix sums that give the total-least-squares residual of any run of nodes in O(1).
class RunResidual {
  public:
    explicit RunResidual(const std::vector<Vec2>& nodes) : sums_(nodes.size() + 1) {
        const std::size_t n = nodes.size();
        Vec2 origin = Vec2::Zero();
        for (const Vec2& p : nodes) origin += p;
        origin /= static_cast<double>(n);  // keeps the sums small, so differences stay exact
        arc_.resize(n, 0.0);
        for (std::size_t i = 1; i < n; ++i)
            arc_[i] = arc_[i - 1] + (nodes[i] - nodes[i - 1]).norm();
        for (std::size_t i = 0; i < n; ++i) {
            const double before = i > 0 ? arc_[i] - arc_[i - 1] : 0.0;
            const double after = i + 1 < n ? arc_[i + 1] - arc_[i] : 0.0;
            const double w = 0.5 * (before + after);
            const Vec2 p = nodes[i] - origin;
            Sums s = sums_[i];
            s.w += w;
            s.x += w * p.x();
            s.y += w * p.y();
            s.xx += w * p.x() * p.x();
            s.yy += w * p.y() * p.y();
            s.xy += w * p.x() * p.y();
            sums_[i + 1] = s;
        }
    }

    double length() const { return arc_.back(); }
    double arc(std::size_t i) const { return arc_[i]; }

    /// Integral of squared distance to the best line over nodes i..j [px^3].
    double operator()(std::size_t i, std::size_t j) const {
        const Sums& a = sums_[i];
        const Sums& b = sums_[j + 1];
        const double w = b.w - a.w;
        if (w <= 0) return 0.0;
        const double x = b.x - a.x;
        const double y = b.y - a.y;
        const double xx = (b.xx - a.xx) - x * x / w;
        const double yy = (b.yy - a.yy) - y * y / w;
        const double xy = (b.xy - a.xy) - x * y / w;
        const double root = std::sqrt((xx - yy) * (xx - yy) + 4 * xy * xy);
        return std::max(0.0, 0.5 * (xx + yy - root));
    }

  private:
    struct Sums {
        double w = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
    };
    std::vector<Sums> sums_;
    std::vector<double> arc_;
};

}  // namespace

namespace {

/// Nodes where the path may turn: local maxima of the distance to the chord between two nodes at
/// the same distance before and behind, at several scales. At most kMaxCandidates, the sharpest
/// first; the two ends always.
std::vector<std::size_t> cornerCandidates(const std::vector<Vec2>& nodes, double spacing) {
    const auto n = static_cast<std::ptrdiff_t>(nodes.size());
    std::vector<std::pair<double, std::size_t>> found;
    for (const double reachPx : {5.0, 10.0, 20.0, 40.0}) {
        const auto w = static_cast<std::ptrdiff_t>(std::lround(std::max(1.0, reachPx / spacing)));
        if (2 * w >= n) break;
        std::vector<double> bend(nodes.size(), 0.0);
        for (std::ptrdiff_t i = 1; i + 1 < n; ++i) {
            // Close to an end the window shrinks with the distance to it.
            const std::ptrdiff_t r = std::min({w, i, n - 1 - i});
            const Vec2 a = nodes[static_cast<std::size_t>(i - r)];
            const Vec2 b = nodes[static_cast<std::size_t>(i + r)];
            const Vec2 p = nodes[static_cast<std::size_t>(i)];
            // Half the detour over the node: also large where the pen turns back on itself.
            bend[static_cast<std::size_t>(i)] = ((p - 0.5 * (a + b)).norm()) / reachPx;
        }
        for (std::ptrdiff_t i = 1; i + 1 < n; ++i) {
            const double here = bend[static_cast<std::size_t>(i)];
            if (here < 0.03) continue;
            bool peak = true;
            const std::ptrdiff_t around = std::max<std::ptrdiff_t>(1, w / 2);
            for (std::ptrdiff_t j = std::max<std::ptrdiff_t>(0, i - around);
                 j <= std::min(n - 1, i + around) && peak; ++j) {
                const double other = bend[static_cast<std::size_t>(j)];
                peak = other < here || (other == here && j >= i);
            }
            if (peak) found.emplace_back(here, static_cast<std::size_t>(i));
        }
    }
    std::sort(found.rbegin(), found.rend());
    std::vector<std::size_t> result{0, nodes.size() - 1};
    std::vector<bool> taken(nodes.size(), false);
    for (const auto& [bend, i] : found) {
        if (result.size() >= kMaxCandidates) break;
        if (taken[i]) continue;
        taken[i] = true;
        result.push_back(i);
    }
    std::sort(result.begin(), result.end());
    return result;
}

}  // namespace

std::vector<std::size_t> optimalPartition(const std::vector<Vec2>& nodes, double wobblePx) {
    if (nodes.size() < 3) return {0, nodes.size() - 1};
    const RunResidual residual(nodes);
    const double length = residual.length();
    const std::vector<std::size_t> at =
        cornerCandidates(nodes, length / static_cast<double>(nodes.size() - 1));
    const std::size_t n = at.size();
    const double floor = wobblePx * wobblePx * length;
    const double evidence = std::max(1.0, length / tol::kWobbleCorrelationPx);
    auto criterion = [&](double sse, std::size_t pieces) {
        return 0.5 * evidence * std::log((sse + floor) / length) +
               tol::kCornerPenalty * static_cast<double>(pieces);
    };
    std::vector<double> cost(n * n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) cost[i * n + j] = residual(at[i], at[j]);
    }

    constexpr double kInf = std::numeric_limits<double>::infinity();
    std::vector<double> best(cost.begin(), cost.begin() + static_cast<std::ptrdiff_t>(n));
    std::vector<std::vector<std::size_t>> from;  // per number of pieces: the cut before
    from.emplace_back(n, 0);
    double bestCriterion = criterion(best[n - 1], 1);
    std::size_t bestPieces = 1;
    for (std::size_t k = 2; k <= std::min(kMaxPieces, n - 1); ++k) {
        std::vector<double> next(n, kInf);
        std::vector<std::size_t> back(n, 0);
        for (std::size_t j = k; j < n; ++j) {
            for (std::size_t i = k - 1; i < j; ++i) {
                const double value = best[i] + cost[i * n + j];
                if (value < next[j]) {
                    next[j] = value;
                    back[j] = i;
                }
            }
        }
        best = std::move(next);
        from.push_back(std::move(back));
        const double value = criterion(best[n - 1], k);
        if (value < bestCriterion) {
            bestCriterion = value;
            bestPieces = k;
        }
        // Several more corners that do not pay, or nothing left to explain: stop.
        if (k >= bestPieces + 5 || best[n - 1] < 0.1 * floor) break;
    }

    std::vector<std::size_t> cuts{n - 1};
    for (std::size_t k = bestPieces; k >= 1; --k) {
        cuts.push_back(k == 1 ? 0 : from[k - 1][cuts.back()]);
    }
    std::reverse(cuts.begin(), cuts.end());
    for (std::size_t& c : cuts) c = at[c];
    return cuts;
}

void refineCuts(const std::vector<Vec2>& nodes, std::vector<std::size_t>& cuts) {
    if (cuts.size() < 3) return;
    const RunResidual residual(nodes);
    for (int pass = 0; pass < 2; ++pass) {
        for (std::size_t c = 1; c + 1 < cuts.size(); ++c) {
            double least = std::numeric_limits<double>::infinity();
            std::size_t at = cuts[c];
            const std::size_t reach = 12;
            const std::size_t lo = std::max(cuts[c - 1] + 1, cuts[c] > reach ? cuts[c] - reach : 0);
            const std::size_t hi = std::min(cuts[c + 1], cuts[c] + reach);
            for (std::size_t m = lo; m < hi; ++m) {
                const double value = residual(cuts[c - 1], m) + residual(m, cuts[c + 1]);
                if (value < least) {
                    least = value;
                    at = m;
                }
            }
            cuts[c] = at;
        }
    }
}

double runRms(const std::vector<Vec2>& nodes, std::size_t first, std::size_t last) {
    const RunResidual residual({nodes.begin() + static_cast<std::ptrdiff_t>(first),
                                nodes.begin() + static_cast<std::ptrdiff_t>(last + 1)});
    return std::sqrt(residual(0, last - first) / std::max(residual.length(), 1e-9));
}

}  // namespace ew
