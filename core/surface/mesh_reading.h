// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "core/base/vec.h"

namespace ew {

/// What is wrong with triangles in the eyes of a program that reads them in single precision and
/// knows points by their coordinates alone, as a slicer reads an STL file.
struct ReadingFaults {
    std::size_t withoutArea = 0;  ///< triangles no higher over their longest side than a step of
                                  ///< single precision at that place
    std::size_t openEdges = 0;    ///< edges that are not between exactly two triangles which run
                                  ///< along them in opposite directions

    bool none() const { return withoutArea == 0 && openEdges == 0; }
    bool operator==(const ReadingFaults&) const = default;
};

/// Reads the triangles as such a program does: points with the same coordinates are one point.
/// \param points     as they are written; every coordinate finite.
/// \param triangles  indices into points, within range.
/// O(n log n); needs no more memory than the mesh itself.
ReadingFaults faultsWhenRead(std::span<const Eigen::Vector3f> points,
                             std::span<const std::array<int, 3>> triangles);

}  // namespace ew
