// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/export_place.h"

#include <algorithm>
#include <cmath>

#include "core/base/tolerance.h"

namespace ew {

void Extent::add(std::span<const Vec3> points) {
    for (const Vec3& p : points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
}

double Extent::size() const {
    const double longest = (high - low).maxCoeff();
    return std::isfinite(longest) ? std::max(longest, 0.0) : 0.0;
}

double Extent::reach() const {
    const double farthest = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
    return std::isfinite(farthest) ? farthest : 0.0;
}

Vec3 fileOrigin(const Extent& extent) {
    const double size = extent.size();
    if (size == 0.0 || extent.reach() <= tol::kFarFromOrigin * size) return Vec3::Zero();
    const double step = std::pow(10.0, std::floor(std::log10(size)));
    const Vec3 middle = (extent.low + extent.high) / 2.0;
    return (middle / step).array().round().matrix() * step;
}

std::vector<Vec3> atOwnOrigin(std::span<const Vec3> points) {
    Extent extent;
    extent.add(points);
    const Vec3 origin = fileOrigin(extent);
    std::vector<Vec3> out(points.begin(), points.end());
    for (Vec3& p : out) p -= origin;
    return out;
}

}  // namespace ew
