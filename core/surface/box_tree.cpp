// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/box_tree.h"

#include <algorithm>
#include <numeric>

namespace ew {

BoxTree::BoxTree(std::vector<Box3> boxes) : boxes_(std::move(boxes)) {
    order_.resize(boxes_.size());
    std::iota(order_.begin(), order_.end(), 0);
    if (order_.empty()) return;
    centers_.reserve(boxes_.size());
    for (const Box3& box : boxes_) centers_.push_back(box.center());
    nodes_.reserve(boxes_.size());
    build(0, static_cast<int>(order_.size()));
    centers_ = {};
}

void BoxTree::build(int first, int last) {
    const auto index = nodes_.size();
    nodes_.emplace_back();
    nodes_[index].first = first;
    nodes_[index].last = last;
    Box3 centers;
    for (int k = first; k < last; ++k) {
        nodes_[index].box.extend(boxes_[at(order_[at(k)])]);
        centers.extend(centers_[at(order_[at(k)])]);
    }
    if (last - first <= kLeaf) return;
    int axis = 0;
    centers.sizes().maxCoeff(&axis);
    const int middle = first + (last - first) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                     [&](int a, int b) { return centers_[at(a)][axis] < centers_[at(b)][axis]; });
    build(first, middle);
    nodes_[index].right = static_cast<int>(nodes_.size());
    build(middle, last);
}

}  // namespace ew
