// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edge_graph/open_ends.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/tolerance.h"

namespace ew {
namespace {

struct Target {
    Vec2 point = Vec2::Zero();
    double gap = std::numeric_limits<double>::infinity();
};

class Search {
  public:
    Search(const EdgeGraph& graph, double distancePx)
        : graph_(graph), reach_(tol::kOpenEndReach * distancePx) {}

    std::optional<Target> from(std::size_t edge, std::size_t side) {
        const DanglingEdge& d = graph_.dangling[edge];
        tip_ = d.ends[side];
        const Vec2 axis = tip_ - d.ends[1 - side];
        out_ = axis.norm() > 1e-9 ? Vec2(axis.normalized()) : Vec2(1, 0);
        limit_ = std::min(reach_, 0.75 * axis.norm());
        best_ = Target{};
        for (std::size_t j = 0; j < graph_.junctions.size(); ++j) {
            if (static_cast<int>(j) != d.junction) offer(graph_.junctions[j].position);
        }
        for (std::size_t o = 0; o < graph_.dangling.size(); ++o) {
            if (o == edge) continue;
            offer(graph_.dangling[o].ends[1]);
            if (graph_.dangling[o].junction < 0) offer(graph_.dangling[o].ends[0]);
        }
        for (const GraphEdge& e : graph_.edges) {
            if (e.ends[0] == d.junction || e.ends[1] == d.junction) continue;
            crossAhead(graph_.junctions[static_cast<std::size_t>(e.ends[0])].position,
                       graph_.junctions[static_cast<std::size_t>(e.ends[1])].position);
        }
        return std::isfinite(best_.gap) ? std::optional<Target>(best_) : std::nullopt;
    }

  private:
    /// Takes a point that lies about ahead of the tip (or just beside or behind it).
    void offer(const Vec2& p) {
        const Vec2 d = p - tip_;
        const double gap = d.norm();
        if (gap > limit_ || gap < 1e-9) return;
        const double beside = std::abs(cross2(out_, d));
        const bool ahead = d.dot(out_) > 0 ? beside < 0.6 * gap + 0.1 * reach_ : gap < 0.3 * reach_;
        if (ahead && gap < limit_) {
            best_ = Target{p, gap};
            limit_ = gap;
        }
    }
    void crossAhead(const Vec2& a, const Vec2& b) {
        const bool beyond = ((a.cwiseMin(b) - tip_).array() > limit_).any() ||
                            ((tip_ - a.cwiseMax(b)).array() > limit_).any();
        if (beyond) return;
        const Vec2 e = b - a;
        const double sine = cross2(out_, e);
        if (std::abs(sine) < 0.2 * e.norm()) return;
        const double t = cross2(a - tip_, e) / sine;
        const double u = cross2(a - tip_, out_) / sine;
        if (t <= 0 || u <= 0.05 || u >= 0.95) return;
        offer(tip_ + t * out_);
    }

    const EdgeGraph& graph_;
    double reach_;
    Vec2 tip_ = Vec2::Zero();
    Vec2 out_ = Vec2::UnitX();
    double limit_ = 0;
    Target best_;
};

}  // namespace

void findOpenEnds(EdgeGraph& graph, double distancePx) {
    Search search(graph, distancePx);
    for (std::size_t e = 0; e < graph.dangling.size(); ++e) {
        const bool freeStart = graph.dangling[e].junction < 0;
        for (std::size_t side = freeStart ? 0 : 1; side < 2; ++side) {
            if (const auto target = search.from(e, side)) {
                graph.openEnds.push_back({graph.dangling[e].ends[side], target->point, target->gap,
                                          static_cast<int>(e)});
            }
        }
    }
}

}  // namespace ew
