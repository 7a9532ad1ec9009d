// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/box_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ew {

BoxTree::BoxTree(const std::vector<Box3>& boxes) {
    if (boxes.empty()) return;
    std::vector<Item> items;
    std::vector<Bounds> bounds;
    items.reserve(boxes.size());
    bounds.reserve(boxes.size());
    for (const Box3& box : boxes) {
        const Eigen::Vector3f center = box.center().cast<float>();
        items.push_back({{center.x(), center.y(), center.z()}, static_cast<int>(items.size())});
        bounds.push_back(boundsOf(box));
    }
    nodes_.reserve(boxes.size());
    build(items, bounds, 0, static_cast<int>(items.size()));
    order_.reserve(items.size());
    bounds_.reserve(items.size());
    for (const Item& item : items) {
        order_.push_back(item.item);
        bounds_.push_back(bounds[at(item.item)]);
    }
}

BoxTree::Bounds BoxTree::boundsOf(const Box3& box) {
    constexpr float kFar = std::numeric_limits<float>::infinity();
    constexpr double kMost = std::numeric_limits<float>::max();
    const auto single = [=](double x) { return static_cast<float>(std::clamp(x, -kMost, kMost)); };
    Bounds out;
    for (int k = 0; k < 3; ++k) {
        out.low[at(k)] = std::nextafter(single(box.min()[k]), -kFar);
        out.high[at(k)] = std::nextafter(single(box.max()[k]), kFar);
    }
    return out;
}

void BoxTree::build(std::vector<Item>& items, const std::vector<Bounds>& bounds, int first,
                    int last) {
    const auto index = nodes_.size();
    nodes_.emplace_back();
    Node node;
    node.first = first;
    node.last = last;
    node.bounds = bounds[at(items[at(first)].item)];
    std::array<float, 3> low = items[at(first)].center;
    std::array<float, 3> high = low;
    for (int i = first + 1; i < last; ++i) {
        const Item& item = items[at(i)];
        const Bounds& b = bounds[at(item.item)];
        for (std::size_t k = 0; k < 3; ++k) {
            node.bounds.low[k] = std::min(node.bounds.low[k], b.low[k]);
            node.bounds.high[k] = std::max(node.bounds.high[k], b.high[k]);
            low[k] = std::min(low[k], item.center[k]);
            high[k] = std::max(high[k], item.center[k]);
        }
    }
    if (last - first > kLeaf) {
        std::size_t axis = 0;
        for (const std::size_t k : {1U, 2U}) {
            if (high[k] - low[k] > high[axis] - low[axis]) axis = k;
        }
        const int middle = first + (last - first) / 2;
        std::nth_element(
            items.begin() + first, items.begin() + middle, items.begin() + last,
            [axis](const Item& a, const Item& b) { return a.center[axis] < b.center[axis]; });
        build(items, bounds, first, middle);
        node.right = static_cast<int>(nodes_.size());
        build(items, bounds, middle, last);
    }
    nodes_[index] = node;
}

}  // namespace ew
