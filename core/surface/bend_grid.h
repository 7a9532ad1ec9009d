// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface.
#pragma once

#include <array>
#include <cmath>
#include <span>

#include "core/base/vec.h"

namespace ew {

/// Second derivatives at a point, out of the tangent plane, with their signs.
struct Bend {
    double uu = 0.0;
    double uv = 0.0;
    double vv = 0.0;

    /// By the directions the other way round.
    Bend turned() const { return {vv, uv, uu}; }
    Bend scaled(double s) const { return {s * uu, s * uv, s * vv}; }
    /// Needs at least as many pieces as another, whatever these are, but for a few percent.
    bool covers(const Bend& o) const {
        constexpr double kNearly = 0.97;
        return std::abs(uu) >= kNearly * std::abs(o.uu) &&
               std::abs(uv) >= kNearly * std::abs(o.uv) &&
               std::abs(vv) >= kNearly * std::abs(o.vv) && (uu * vv >= 0.0 || o.uu * o.vv <= 0.0);
    }
};

inline constexpr int kBendCells = 4;  ///< points are one more a side
inline constexpr std::size_t kBendPoints = (kBendCells + 1) * (kBendCells + 1);

/// Points of a square domain and how the surface bends there.
class BendGrid {
  public:
    /// \param points  kBendPoints, row by row; they must stay.
    explicit BendGrid(std::span<const Vec3> points);

    const Bend& bend(int i, int k) const { return bends_[index(i, k)]; }

    /// Distance of points from the triangles of nu x nv cells, these being 1 or 2 each: what bends
    /// ask for is too much where they are not the same everywhere.
    /// \param points  of the same domain, row by row, `cells` + 1 a side; `cells` is even.
    double deviation(std::span<const Vec3> points, int cells, int nu, int nv) const;

    /// Points are spaced so unevenly that bends between them can be larger than at them.
    bool uneven() const { return uneven_; }
    /// The surface turns back within the domain.
    bool folded() const { return folded_; }

    /// Largest second derivative of a border curve, across the curve: how its points are spaced is
    /// no bend.
    /// \param side  0 (along u, v = 0) .. 3, counter-clockwise.
    double curve(int side) const;

  private:
    using Values = std::array<Vec3, kBendPoints>;

    static std::size_t index(int i, int k) {
        return static_cast<std::size_t>(i + (kBendCells + 1) * k);
    }

    std::span<const Vec3> points_;
    Values normals_;
    bool uneven_ = false;
    bool folded_ = false;
    std::array<Bend, kBendPoints> bends_;
};

}  // namespace ew
