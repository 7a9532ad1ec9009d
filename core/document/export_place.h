// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "core/base/vec.h"

namespace ew {

/// The box round points.
struct Extent {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
    Vec3 high = -low;

    void add(std::span<const Vec3> points);
    /// Longest side [mm], 0 without points.
    double size() const;
    /// Largest coordinate, without its sign [mm], 0 without points.
    double reach() const;
};

/// Where the origin of a mesh file is put, so that single precision holds what is in this box: the
/// world's origin where that is near enough, else a round place in the middle of the box.
Vec3 fileOrigin(const Extent& extent);

/// The same points from the fileOrigin of their box.
std::vector<Vec3> atOwnOrigin(std::span<const Vec3> points);

}  // namespace ew
