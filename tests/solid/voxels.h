// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <ostream>
#include <vector>

#include "core/solid/boolean.h"

namespace ew::test {

/// A box with integer corners.
struct IntBox {
    std::array<int, 3> low{};
    std::array<int, 3> high{};
};

/// What a person counts on a solid.
struct SurfaceCounts {
    int volume = 0;  ///< unit cells
    int vertices = 0, edges = 0, faces = 0, shells = 0, genus = 0;
    bool touchesInEdge = false;   ///< the surface is no 2-manifold at an edge
    bool touchesInPoint = false;  ///< ... at a point, where it is one at all edges
    bool operator==(const SurfaceCounts&) const = default;
};

std::ostream& operator<<(std::ostream& out, const SurfaceCounts& c);

/// A solid of unit cells: the oracle for booleans of boxes. It knows nothing of planes or
/// polygons; everything is counted on the cells round lattice edges and points.
class Voxels {
  public:
    static constexpr int kSize = 12;  ///< coordinates 0..11 can be occupied

    bool at(int x, int y, int z) const;
    void combine(const IntBox& box, BooleanKind kind);
    bool empty() const;
    bool operator==(const Voxels&) const = default;
    SurfaceCounts counts() const;

  private:
    std::vector<bool> cells_ = std::vector<bool>(kSize * kSize * kSize, false);
};

}  // namespace ew::test
