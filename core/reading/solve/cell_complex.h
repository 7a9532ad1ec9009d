// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/base/vec.h"
#include "core/reading/solve/face_lift.h"

namespace ew {

/// A box cut by planes into convex cells. Facets of neighbours are the same facet: wherever a plane
/// cuts an edge, it cuts it in all of them.
class CellComplex {
  public:
    struct Facet {
        std::vector<int> loop;             ///< vertices, in order
        int plane = -1;                    ///< -1 on the border of the box
        std::array<int, 2> cells{-1, -1};  ///< on the positive and the negative side of the plane
    };

    /// \param low, high  the box.
    CellComplex(const Vec3& low, const Vec3& high);

    /// Planes and cells at most; more are refused.
    static constexpr int kMostPlanes = 48;
    static constexpr std::size_t kMostCells = 3000;

    /// Cuts all cells that lie on both sides of a plane.
    /// \param nearPx  vertices so near to the plane lie on it.
    /// \return false, and no use any more, where there are too many or they are too close.
    bool cut(const DrawnPlane& plane, double nearPx);

    const std::vector<Vec3>& vertices() const { return vertices_; }
    const std::vector<Facet>& facets() const { return facets_; }
    const std::vector<DrawnPlane>& planes() const { return planes_; }
    int cellCount() const { return static_cast<int>(sides_.size()); }

    /// The cell on these sides of the planes (bit k set: positive side of plane k), -1 for none.
    int cellAt(std::uint64_t sides) const;
    /// Is a cell on the positive side of a plane?
    bool isPositive(int cell, std::size_t plane) const {
        return (sides_[static_cast<std::size_t>(cell)] >> plane & 1U) != 0U;
    }
    double area(int facet) const;  ///< [px^2]

  private:
    int side(int vertex) const { return signs_[static_cast<std::size_t>(vertex)]; }
    bool splitFacets();
    bool splitCells();
    int cellSide(int cell) const;

    std::vector<DrawnPlane> planes_;
    std::vector<Vec3> vertices_;
    std::vector<Facet> facets_;
    std::vector<std::uint64_t> sides_;          ///< per cell
    std::vector<std::vector<int>> cellFacets_;  ///< per cell
    std::vector<signed char> signs_;            ///< per vertex, of the plane that is cutting
    mutable std::unordered_map<std::uint64_t, int> cells_;
};

}  // namespace ew
