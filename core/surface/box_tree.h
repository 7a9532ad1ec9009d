// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "core/base/vec.h"

namespace ew {

using Box3 = Eigen::AlignedBox3d;

/// A tree of boxes (median splits of the centres) over numbered items. O(n log n) to build. Boxes
/// are kept in single precision, a rounding larger than they are: some that only nearly meet are
/// visited too.
class BoxTree {
  public:
    BoxTree() = default;
    explicit BoxTree(const std::vector<Box3>& boxes);

    bool empty() const { return order_.empty(); }

    /// Calls visit(item) for every item whose box meets `box`.
    template <class Visit>
    void overlapping(const Box3& box, Visit&& visit) const {
        if (empty()) return;
        const Bounds bounds = boundsOf(box);
        std::array<int, kDepth> stack{0};
        int top = 1;
        while (top > 0) {
            const int index = stack[at(--top)];
            const Node& node = nodes_[at(index)];
            if (!meets(node.bounds, bounds)) continue;
            if (node.right >= 0) {
                stack[at(top++)] = node.right;
                stack[at(top++)] = index + 1;
                continue;
            }
            for (int k = node.first; k < node.last; ++k) {
                if (meets(bounds_[at(k)], bounds)) visit(order_[at(k)]);
            }
        }
    }

    /// Calls visit(a, b), once in one order, for every two items whose boxes meet.
    template <class Visit>
    void overlappingPairs(Visit&& visit) const {
        if (!empty()) within(0, visit);
    }

  private:
    struct Bounds {
        std::array<float, 3> low{};
        std::array<float, 3> high{};
    };
    struct Node {
        Bounds bounds;
        int right = -1;  ///< second child, the first one follows its parent; -1 in a leaf
        int first = 0;
        int last = 0;
    };
    /// What a split sorts.
    struct Item {
        std::array<float, 3> center;
        int item;
    };
    static constexpr int kDepth = 128;  ///< median splits of 2^31 items need 32 levels
    static constexpr int kLeaf = 4;

    static std::size_t at(int i) { return static_cast<std::size_t>(i); }
    static Bounds boundsOf(const Box3& box);
    static bool meets(const Bounds& a, const Bounds& b) {
        // No branch between the axes: it would be taken at random.
        return static_cast<bool>(int{a.low[0] <= b.high[0]} & int{b.low[0] <= a.high[0]} &
                                 int{a.low[1] <= b.high[1]} & int{b.low[1] <= a.high[1]} &
                                 int{a.low[2] <= b.high[2]} & int{b.low[2] <= a.high[2]});
    }
    void build(std::vector<Item>& items, const std::vector<Bounds>& bounds, int first, int last);

    template <class Visit>
    void within(int index, Visit& visit) const {
        const Node& node = nodes_[at(index)];
        if (node.right >= 0) {
            within(index + 1, visit);
            within(node.right, visit);
            between(index + 1, node.right, visit);
            return;
        }
        for (int i = node.first; i < node.last; ++i) {
            for (int k = i + 1; k < node.last; ++k) pair(i, k, visit);
        }
    }
    template <class Visit>
    void between(int a, int b, Visit& visit) const {
        const Node& na = nodes_[at(a)];
        const Node& nb = nodes_[at(b)];
        if (!meets(na.bounds, nb.bounds)) return;
        if (na.right < 0 && nb.right < 0) {
            for (int i = na.first; i < na.last; ++i) {
                if (!meets(bounds_[at(i)], nb.bounds)) continue;
                for (int k = nb.first; k < nb.last; ++k) pair(i, k, visit);
            }
            return;
        }
        const bool splitA =
            nb.right < 0 || (na.right >= 0 && na.last - na.first >= nb.last - nb.first);
        if (splitA) {
            between(a + 1, b, visit);
            between(na.right, b, visit);
        } else {
            between(a, b + 1, visit);
            between(a, nb.right, visit);
        }
    }
    template <class Visit>
    void pair(int a, int b, Visit& visit) const {
        if (meets(bounds_[at(a)], bounds_[at(b)])) visit(order_[at(a)], order_[at(b)]);
    }

    std::vector<int> order_;      ///< items in the order of the leaves
    std::vector<Bounds> bounds_;  ///< in that order
    std::vector<Node> nodes_;
};

}  // namespace ew
