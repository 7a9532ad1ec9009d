// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/view_grid.h"

#include <algorithm>
#include <cmath>

namespace ew {

ViewGrid::ViewGrid(const Eigen::AlignedBox2d& area, std::size_t wantedCells, double margin)
    : area_(area), margin_(margin) {
    const Vec2 size = area.sizes().cwiseMax(1e-300);
    const double cells = static_cast<double>(std::max<std::size_t>(wantedCells, 1));
    // Square cells; a picture that is a mere line gets a row of them.
    cellSize_ = std::max(std::sqrt(size.x() * size.y() / cells), size.maxCoeff() / cells);
    columns_ = static_cast<int>(std::ceil(size.x() / cellSize_)) + 1;
    rows_ = static_cast<int>(std::ceil(size.y() / cellSize_)) + 1;
}

void ViewGrid::add(int item, const std::array<Vec2, 3>& triangle) {
    enter(item, triangle.data(), 3);
}

void ViewGrid::add(int item, const std::array<Vec2, 2>& segment) { enter(item, segment.data(), 2); }

void ViewGrid::enter(int item, const Vec2* points, std::size_t count) {
    rows(points, count, [&](int row, int first, int last) {
        for (int c = first; c <= last; ++c) entries_.push_back({row * columns_ + c, item});
    });
}

void ViewGrid::finish() {
    first_.assign(static_cast<std::size_t>(rows_ * columns_) + 1, 0);
    for (const auto& [c, item] : entries_) ++first_[static_cast<std::size_t>(c) + 1];
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    items_.resize(entries_.size());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (const auto& [c, item] : entries_) {
        items_[static_cast<std::size_t>(next[static_cast<std::size_t>(c)]++)] = item;
    }
    entries_ = {};
}

ViewGrid::Range ViewGrid::cell(int index) const {
    const auto c = static_cast<std::size_t>(index);
    return {items_.data() + first_[c], items_.data() + first_[c + 1]};
}

ViewGrid::Range ViewGrid::at(const Vec2& p) const {
    if (first_.empty() || area_.exteriorDistance(p) > margin_) return {};
    return cell(rowOf(p.y()) * columns_ + columnOf(p.x()));
}

}  // namespace ew
