// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/mesh_reading.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "core/base/tolerance.h"
#include "core/surface/side_key.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// By point: the first one, in the order of coordinates, that has the same coordinates.
std::vector<int> mergedPoints(std::span<const Eigen::Vector3f> points) {
    std::vector<int> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    const auto before = [&](int a, int b) {
        const Eigen::Vector3f& p = points[at(a)];
        const Eigen::Vector3f& q = points[at(b)];
        return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
    };
    std::sort(order.begin(), order.end(), before);
    std::vector<int> out(points.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        const bool same = k > 0 && points[at(order[k])] == points[at(order[k - 1])];
        out[at(order[k])] = same ? out[at(order[k - 1])] : order[k];
    }
    return out;
}

/// Higher over its longest side than single precision can tell.
bool hasArea(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c) {
    const Vec3 p = a.cast<double>();
    const Vec3 q = b.cast<double>();
    const Vec3 r = c.cast<double>();
    const double longest = std::max({(q - p).norm(), (r - q).norm(), (p - r).norm()});
    const double step =
        tol::kSingleStep *
        std::max({a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff(), c.cwiseAbs().maxCoeff()});
    return (q - p).cross(r - p).norm() > step * longest;
}

/// A side that is run along twice in one direction, or once with nothing on the other side.
std::size_t unmatched(std::vector<std::uint64_t>& sides) {
    std::sort(sides.begin(), sides.end());
    std::size_t count = 0;
    for (std::size_t k = 0; k < sides.size();) {
        const std::uint64_t side = sides[k];
        const std::size_t first = k;
        while (k < sides.size() && sides[k] == side) ++k;
        const auto from = static_cast<int>(side >> 32U);
        const auto to = static_cast<int>(side & 0xffffffffU);
        const bool once = k == first + 1;
        const auto back = std::equal_range(sides.begin(), sides.end(), sideKey(to, from));
        const auto backs = back.second - back.first;
        // An edge is counted where it is met first.
        if ((!once || backs != 1) && (from < to || backs == 0)) ++count;
    }
    return count;
}

}  // namespace

ReadingFaults faultsWhenRead(std::span<const Eigen::Vector3f> points,
                             std::span<const std::array<int, 3>> triangles) {
    const std::vector<int> point = mergedPoints(points);
    ReadingFaults out;
    std::vector<std::uint64_t> sides;
    sides.reserve(3 * triangles.size());
    for (const auto& t : triangles) {
        if (!hasArea(points[at(t[0])], points[at(t[1])], points[at(t[2])])) ++out.withoutArea;
        for (std::size_t k = 0; k < 3; ++k) {
            const int from = point[at(t[k])];
            const int to = point[at(t[(k + 1) % 3])];
            if (from != to) sides.push_back(sideKey(from, to));
        }
    }
    out.openEdges = unmatched(sides);
    return out;
}

}  // namespace ew
