// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "core/base/vec.h"

namespace ew {

using Box3 = Eigen::AlignedBox3d;

/// A tree of boxes (median splits of the centres) over numbered items. O(n log n) to build.
class BoxTree {
  public:
    BoxTree() = default;
    explicit BoxTree(std::vector<Box3> boxes);

    bool empty() const { return order_.empty(); }

    /// Calls visit(item) for every item whose box meets `box`.
    template <class Visit>
    void overlapping(const Box3& box, Visit&& visit) const {
        if (empty()) return;
        std::array<int, kDepth> stack{0};
        int top = 1;
        while (top > 0) {
            const Node& node = nodes_[static_cast<std::size_t>(stack[at(--top)])];
            if (!meets(node.box, box)) continue;
            if (node.right >= 0) {
                stack[at(top++)] = node.right;
                stack[at(top++)] = static_cast<int>(&node - nodes_.data()) + 1;
                continue;
            }
            for (int k = node.first; k < node.last; ++k) {
                const int item = order_[at(k)];
                if (meets(boxes_[at(item)], box)) visit(item);
            }
        }
    }

    /// Calls visit(a, b), once in one order, for every two items whose boxes meet.
    template <class Visit>
    void overlappingPairs(Visit&& visit) const {
        if (!empty()) within(0, visit);
    }

  private:
    struct Node {
        Box3 box;
        int right = -1;  ///< second child, the first one follows its parent; -1 in a leaf
        int first = 0;
        int last = 0;
    };
    static constexpr int kDepth = 128;  ///< median splits of 2^31 items need 32 levels
    static constexpr int kLeaf = 4;

    static std::size_t at(int i) { return static_cast<std::size_t>(i); }
    static bool meets(const Box3& a, const Box3& b) {
        return (a.min().array() <= b.max().array()).all() &&
               (b.min().array() <= a.max().array()).all();
    }
    void build(int first, int last);

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
            for (int k = i + 1; k < node.last; ++k) pair(order_[at(i)], order_[at(k)], visit);
        }
    }
    template <class Visit>
    void between(int a, int b, Visit& visit) const {
        const Node& na = nodes_[at(a)];
        const Node& nb = nodes_[at(b)];
        if (!meets(na.box, nb.box)) return;
        if (na.right < 0 && nb.right < 0) {
            for (int i = na.first; i < na.last; ++i) {
                if (!meets(boxes_[at(order_[at(i)])], nb.box)) continue;
                for (int k = nb.first; k < nb.last; ++k) pair(order_[at(i)], order_[at(k)], visit);
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
        if (meets(boxes_[at(a)], boxes_[at(b)])) visit(a, b);
    }

    std::vector<Box3> boxes_;
    std::vector<Vec3> centers_;  ///< while building only
    std::vector<int> order_;
    std::vector<Node> nodes_;
};

}  // namespace ew
