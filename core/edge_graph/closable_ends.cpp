// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edge_graph/closable_ends.h"

#include <algorithm>
#include <array>
#include <set>

#include "core/base/disjoint_sets.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Dangling lines, joined as if every open end were closed. All that has regions already is one
/// node: a path from it and back to it makes another region.
class Joined {
  public:
    explicit Joined(const EdgeGraph& graph) : graph_(graph), nodes_(nodeCount()) {
        for (std::size_t line = 0; line < graph.dangling.size(); ++line) {
            if (graph.dangling[line].junction >= 0) join(end(line, 0), kRegions);
            for (std::size_t other = 0; other < line; ++other) joinWhereTheyMeet(line, other);
        }
        for (const OpenEnd& open : graph.openEnds) join(nodeOf(open), nodeAt(open.target));
    }

    /// Of each line: would it border a region?
    std::vector<bool> bordering() {
        const std::size_t count = graph_.dangling.size();
        std::vector<bool> kept(count, true);
        std::set<std::array<int, 2>> pairs;
        for (std::size_t line = 0; line < count; ++line) {
            std::array<int, 2> ends{find(end(line, 0)), find(end(line, 1))};
            std::sort(ends.begin(), ends.end());
            // Two straight lines between the same two points are one.
            const bool isNew = pairs.insert(ends).second;
            kept[line] = ends[0] == kRegions || (isNew && ends[0] != ends[1]);
        }
        while (dropLooseLines(kept)) {
        }
        return kept;
    }

  private:
    static constexpr int kRegions = 0;

    static int end(std::size_t line, std::size_t side) {
        return static_cast<int>(2 * line + side) + 1;
    }
    std::size_t nodeCount() const { return 2 * graph_.dangling.size() + 1; }
    int find(int node) { return nodes_.root(node); }
    /// The node of the regions stays its own.
    void join(int a, int b) { nodes_.join(std::max(find(a), find(b)), std::min(find(a), find(b))); }
    void joinWhereTheyMeet(std::size_t line, std::size_t other) {
        for (std::size_t a = 0; a < 2; ++a) {
            for (std::size_t b = 0; b < 2; ++b) {
                if (samePlace(graph_.dangling[line].ends[a], graph_.dangling[other].ends[b])) {
                    join(end(line, a), end(other, b));
                }
            }
        }
    }
    static bool samePlace(const Vec2& a, const Vec2& b) {
        // Copies of one place, or places that nothing tells apart.
        constexpr double kSamePx = 1e-6;
        return (a - b).norm() < kSamePx;
    }
    int nodeOf(const OpenEnd& open) const {
        const auto line = at(open.edge);
        return end(line, samePlace(graph_.dangling[line].ends[0], open.tip) ? 0 : 1);
    }
    /// What an open end is meant to meet is an end of a line, or of what has regions.
    int nodeAt(const Vec2& target) const {
        for (std::size_t line = 0; line < graph_.dangling.size(); ++line) {
            for (std::size_t side = 0; side < 2; ++side) {
                if (samePlace(graph_.dangling[line].ends[side], target)) return end(line, side);
            }
        }
        return kRegions;
    }
    bool dropLooseLines(std::vector<bool>& kept) {
        std::vector<int> lines(nodeCount(), 0);
        for (std::size_t line = 0; line < kept.size(); ++line) {
            if (!kept[line]) continue;
            ++lines[at(find(end(line, 0)))];
            ++lines[at(find(end(line, 1)))];
        }
        bool any = false;
        for (std::size_t line = 0; line < kept.size(); ++line) {
            const bool loose =
                lines[at(find(end(line, 0)))] < 2 || lines[at(find(end(line, 1)))] < 2;
            any = any || (kept[line] && loose);
            kept[line] = kept[line] && !loose;
        }
        return any;
    }

    const EdgeGraph& graph_;
    DisjointSets nodes_;
};

}  // namespace

std::vector<OpenEnd> closableEnds(const EdgeGraph& graph) {
    const std::vector<bool> bordering = Joined(graph).bordering();
    std::vector<OpenEnd> told;
    for (const OpenEnd& open : graph.openEnds) {
        const bool again = std::any_of(told.begin(), told.end(), [&](const OpenEnd& o) {
            return o.tip == open.target && o.target == open.tip;
        });
        if (!again && bordering[at(open.edge)]) told.push_back(open);
    }
    return told;
}

}  // namespace ew
