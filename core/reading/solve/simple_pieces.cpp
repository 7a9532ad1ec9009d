// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/simple_pieces.h"

#include <algorithm>
#include <array>
#include <optional>

#include "core/reading/extract/plane_geometry.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

using Loops = std::vector<std::vector<int>>;

class Pieces {
  public:
    Pieces(const std::vector<Vec3>& points, const Loops& loops) {
        Eigen::Index drop = 0;
        doubleArea(points, loops.front()).cwiseAbs().maxCoeff(&drop);
        for (const Vec3& p : points) flat_.emplace_back(p[(drop + 1) % 3], p[(drop + 2) % 3]);
    }

    bool split(const Loops& loops, Loops& out) const {
        if (loops.size() == 1) {
            out.push_back(loops.front());
            return true;
        }
        for (std::size_t h = 1; h < loops.size(); ++h) {
            const auto cuts = diagonals(loops, h);
            if (!cuts) continue;
            const auto& [first, second] = *cuts;
            const auto& outer = loops[0];
            const auto& hole = loops[h];
            std::array<Loops, 2> halves;
            halves[0] = {joined(outer, first.outer, second.outer, hole, second.hole, first.hole)};
            halves[1] = {joined(outer, second.outer, first.outer, hole, first.hole, second.hole)};
            for (std::size_t other = 1; other < loops.size(); ++other) {
                if (other == h) continue;
                const bool inFirst =
                    insidePolygon(polygon(halves[0].front()), flat_[at(loops[other].front())]);
                halves[inFirst ? 0 : 1].push_back(loops[other]);
            }
            return split(halves[0], out) && split(halves[1], out);
        }
        return false;
    }

  private:
    struct Diagonal {
        std::size_t outer = 0, hole = 0;  ///< positions in the two loops
        double length = 0.0;
    };

    std::vector<Vec2> polygon(const std::vector<int>& loop) const {
        std::vector<Vec2> out;
        for (const int v : loop) out.push_back(flat_[at(v)]);
        return out;
    }

    double turn(int a, int b, int c) const {
        return cross2(flat_[at(b)] - flat_[at(a)], flat_[at(c)] - flat_[at(a)]);
    }

    /// Do two segments without a common end meet?
    bool meet(int a, int b, int c, int d) const {
        if (a == c || a == d || b == c || b == d) return false;
        return turn(a, b, c) * turn(a, b, d) <= 0.0 && turn(c, d, a) * turn(c, d, b) <= 0.0;
    }

    bool isFree(const Loops& loops, int a, int b) const {
        for (const auto& loop : loops) {
            for (std::size_t k = 0; k < loop.size(); ++k) {
                if (meet(a, b, loop[k], loop[(k + 1) % loop.size()])) return false;
            }
        }
        const Vec2 middle = 0.5 * (flat_[at(a)] + flat_[at(b)]);
        if (!insidePolygon(polygon(loops[0]), middle)) return false;
        return std::none_of(loops.begin() + 1, loops.end(),
                            [&](const auto& hole) { return insidePolygon(polygon(hole), middle); });
    }

    /// The shortest one, and the shortest that shares no corner with it.
    std::optional<std::array<Diagonal, 2>> diagonals(const Loops& loops, std::size_t hole) const {
        std::vector<Diagonal> all;
        for (std::size_t i = 0; i < loops[0].size(); ++i) {
            for (std::size_t j = 0; j < loops[hole].size(); ++j) {
                if (!isFree(loops, loops[0][i], loops[hole][j])) continue;
                all.push_back({i, j, (flat_[at(loops[0][i])] - flat_[at(loops[hole][j])]).norm()});
            }
        }
        std::sort(all.begin(), all.end(),
                  [](const Diagonal& a, const Diagonal& b) { return a.length < b.length; });
        for (std::size_t i = 0; i < all.size(); ++i) {
            for (std::size_t j = i + 1; j < all.size(); ++j) {
                if (all[i].outer == all[j].outer || all[i].hole == all[j].hole) continue;
                if (meet(loops[0][all[i].outer], loops[hole][all[i].hole], loops[0][all[j].outer],
                         loops[hole][all[j].hole])) {
                    continue;
                }
                return std::array<Diagonal, 2>{all[i], all[j]};
            }
        }
        return std::nullopt;
    }

    /// The outer loop from one corner to another, then the hole from one to another.
    static std::vector<int> joined(const std::vector<int>& outer, std::size_t outerFrom,
                                   std::size_t outerTo, const std::vector<int>& hole,
                                   std::size_t holeFrom, std::size_t holeTo) {
        std::vector<int> out;
        for (std::size_t k = outerFrom;; k = (k + 1) % outer.size()) {
            out.push_back(outer[k]);
            if (k == outerTo) break;
        }
        for (std::size_t k = holeFrom;; k = (k + 1) % hole.size()) {
            out.push_back(hole[k]);
            if (k == holeTo) break;
        }
        return out;
    }

    std::vector<Vec2> flat_;
};

}  // namespace

std::vector<std::vector<int>> simplePieces(const std::vector<Vec3>& points,
                                           const std::vector<std::vector<int>>& loops) {
    Loops out;
    if (!Pieces(points, loops).split(loops, out)) out.clear();
    return out;
}

}  // namespace ew
