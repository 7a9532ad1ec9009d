// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/solid.
#pragma once

#include <array>
#include <vector>

#include "core/base/vec.h"

namespace ew {

/// A uniform grid over a picture; every cell lists the things that may lie in it.
class ViewGrid {
  public:
    ViewGrid() = default;
    /// \param margin  what is entered is grown by this [px].
    ViewGrid(const Eigen::AlignedBox2d& area, std::size_t wantedCells, double margin);

    void add(int item, const std::array<Vec2, 3>& triangle);
    void add(int item, const std::array<Vec2, 2>& segment);
    /// Call once after everything was added.
    void finish();

    struct Range {
        const int* first = nullptr;
        const int* last = nullptr;
        const int* begin() const { return first; }
        const int* end() const { return last; }
    };
    /// Items of the cell that holds the point; none outside of the area.
    Range at(const Vec2& p) const;
    /// Calls visit(Range) for every cell that the segment touches.
    template <class Visit>
    void along(const std::array<Vec2, 2>& segment, const Visit& visit) const {
        rows(segment.data(), 2, [&](int row, int first, int last) {
            for (int c = first; c <= last; ++c) visit(cell(row * columns_ + c));
        });
    }

  private:
    /// Calls visit(row, first column, last column) for the cells that the hull of the points
    /// touches.
    template <class Visit>
    void rows(const Vec2* points, std::size_t count, const Visit& visit) const {
        double low = points[0].y();
        double high = low;
        for (std::size_t i = 1; i < count; ++i) {
            low = std::min(low, points[i].y());
            high = std::max(high, points[i].y());
        }
        const int top = rowOf(low - margin_);
        const int bottom = rowOf(high + margin_);
        for (int row = top; row <= bottom; ++row) {
            const double y0 = area_.min().y() + row * cellSize_ - margin_;
            const double y1 = y0 + cellSize_ + 2.0 * margin_;
            double left = area_.max().x();
            double right = area_.min().x();
            bool any = false;
            for (std::size_t i = 0; i < count; ++i) {
                const Vec2& a = points[i];
                const Vec2& b = points[(i + 1) % count];
                double t0 = 0.0;
                double t1 = 1.0;
                if (!clip(a.y(), b.y(), y0, y1, t0, t1)) continue;
                any = true;
                for (const double t : {t0, t1}) {
                    const double x = a.x() + t * (b.x() - a.x());
                    left = std::min(left, x);
                    right = std::max(right, x);
                }
            }
            if (any) visit(row, columnOf(left - margin_), columnOf(right + margin_));
        }
    }
    static bool clip(double a, double b, double low, double high, double& t0, double& t1) {
        if (std::max(a, b) < low || std::min(a, b) > high) return false;
        if (a == b) return true;
        const double s = (low - a) / (b - a);
        const double e = (high - a) / (b - a);
        t0 = std::max(0.0, std::min(s, e));
        t1 = std::min(1.0, std::max(s, e));
        return t0 <= t1;
    }
    int rowOf(double y) const { return clamped((y - area_.min().y()) / cellSize_, rows_); }
    int columnOf(double x) const { return clamped((x - area_.min().x()) / cellSize_, columns_); }
    static int clamped(double at, int count) {
        return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(count - 1)));
    }
    Range cell(int index) const;
    void enter(int item, const Vec2* points, std::size_t count);

    Eigen::AlignedBox2d area_;
    double cellSize_ = 1.0;
    double margin_ = 0.0;
    int rows_ = 1;
    int columns_ = 1;
    std::vector<std::array<int, 2>> entries_;  ///< cell, item
    std::vector<int> first_;                   ///< by cell, and one more
    std::vector<int> items_;
};

}  // namespace ew
