// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/bend_grid.h"

#include <algorithm>

#include "core/surface/surface_diagonal.h"

namespace ew {
namespace {

constexpr int kCells = kBendCells;
using Rule = double[kCells + 1][kCells + 1];

/// Derivatives at point j of a row of five, in steps: exact for cubics, so for patches.
constexpr Rule kFirst = {{-20.0 / 12, 28.0 / 12, -6.0 / 12, -4.0 / 12, 2.0 / 12},
                         {-5.0 / 12, -2.0 / 12, 6.0 / 12, 2.0 / 12, -1.0 / 12},
                         {1.0 / 12, -8.0 / 12, 0.0, 8.0 / 12, -1.0 / 12},
                         {1.0 / 12, -2.0 / 12, -6.0 / 12, 2.0 / 12, 5.0 / 12},
                         {-2.0 / 12, 4.0 / 12, 6.0 / 12, -28.0 / 12, 20.0 / 12}};
constexpr Rule kSecond = {
    {2, -5, 4, -1, 0}, {1, -2, 1, 0, 0}, {0, 1, -2, 1, 0}, {0, 0, 1, -2, 1}, {0, -1, 4, -5, 2}};
constexpr double kPerSide = kCells * kCells;  ///< second derivatives by steps to those by the side

/// Where derivatives run so nearly along one line, as in corners of creases, their product is
/// noise.
constexpr double kLeastSine = 1e-4;

template <class Points>
std::array<Vec3, kBendPoints> apply(const Rule& rule, const Points& p, std::size_t step,
                                    std::size_t next) {
    std::array<Vec3, kBendPoints> out;
    for (std::size_t row = 0; row <= kCells; ++row) {
        const std::size_t first = row * next;
        for (std::size_t j = 0; j <= kCells; ++j) {
            Vec3 sum = rule[j][0] * p[first];
            for (std::size_t m = 1; m <= kCells; ++m) sum += rule[j][m] * p[first + m * step];
            out[first + j * step] = sum;
        }
    }
    return out;
}

template <class Points>
std::array<Vec3, kBendPoints> byU(const Rule& rule, const Points& p) {
    return apply(rule, p, 1, kCells + 1);
}
template <class Points>
std::array<Vec3, kBendPoints> byV(const Rule& rule, const Points& p) {
    return apply(rule, p, kCells + 1, 1);
}

/// Derivatives in some row are very different, in length.
bool differ(const std::array<Vec3, kBendPoints>& derivatives, std::size_t step, std::size_t next) {
    constexpr double kVery = 10.0;
    for (std::size_t row = 0; row <= kCells; ++row) {
        double least = derivatives[row * next].squaredNorm();
        double most = least;
        for (std::size_t j = 1; j <= kCells; ++j) {
            const double length = derivatives[row * next + j * step].squaredNorm();
            least = std::min(least, length);
            most = std::max(most, length);
        }
        if (most > kVery * kVery * least) return true;
    }
    return false;
}

using CellCorners = std::array<SurfacePoint, 4>;

/// Distance of the points of a cell from its two triangles' planes, each from its own.
template <class Points>
double cellDeviation(const CellCorners& corners, int across, int along, const Points& inside) {
    // Turned by a corner where the other diagonal is the better one.
    const std::size_t turn = turnsLess(corners[0], corners[2], corners[1], corners[3]) ? 0 : 1;
    const Vec3& a = corners[turn].position;
    const Vec3 diagonal = corners[turn + 2].position - a;
    const Vec3 right = (corners[turn + 1].position - a).cross(diagonal).normalized();
    const Vec3 left = diagonal.cross(corners[(turn + 3) % 4].position - a).normalized();
    double most = 0.0;
    for (int q = 0; q <= along; ++q) {
        for (int p = 0; p <= across; ++p) {
            const Vec3 offset = inside(p, q) - a;
            const int side = turn == 0 ? q * across - p * along : (across - p) * along - q * across;
            if (side <= 0) most = std::max(most, std::abs(right.dot(offset)));
            if (side >= 0) most = std::max(most, std::abs(left.dot(offset)));
        }
    }
    return most;
}

}  // namespace

BendGrid::BendGrid(std::span<const Vec3> points) : points_(points) {
    const auto du = byU(kFirst, points);
    const auto dv = byV(kFirst, points);
    const auto duu = byU(kSecond, points);
    const auto dvv = byV(kSecond, points);
    const auto duv = byV(kFirst, du);
    uneven_ = differ(du, 1, kCells + 1) || differ(dv, kCells + 1, 1);
    Vec3 middle = Vec3::Zero();
    for (std::size_t i = 0; i < kBendPoints; ++i) {
        normals_[i] = du[i].cross(dv[i]);
        middle += normals_[i];
    }
    middle.normalize();
    for (std::size_t i = 0; i < kBendPoints; ++i) {
        const double least = kLeastSine * kLeastSine * du[i].squaredNorm() * dv[i].squaredNorm();
        const double length = normals_[i].squaredNorm();
        normals_[i] = length > least ? Vec3(normals_[i] / std::sqrt(length)) : middle;
        folded_ = folded_ || normals_[i].dot(middle) < 0.0;
        const Vec3 n = kPerSide * normals_[i];
        bends_[i] = {n.dot(duu[i]), n.dot(duv[i]), n.dot(dvv[i])};
    }
}

double BendGrid::deviation(std::span<const Vec3> points, int cells, int nu, int nv) const {
    const int across = cells / nu;
    const int along = cells / nv;
    double most = 0.0;
    for (int k = 0; k < cells; k += along) {
        for (int i = 0; i < cells; i += across) {
            const auto end = [&](int a, int b) {
                const auto p = static_cast<std::size_t>(a + (cells + 1) * b);
                return SurfacePoint{points[p],
                                    normals_[index(a * kCells / cells, b * kCells / cells)]};
            };
            const CellCorners corners{end(i, k), end(i + across, k), end(i + across, k + along),
                                      end(i, k + along)};
            const auto inside = [&](int p, int q) -> const Vec3& {
                return points[static_cast<std::size_t>(i + p + (cells + 1) * (k + q))];
            };
            most = std::max(most, cellDeviation(corners, across, along, inside));
        }
    }
    return most;
}

double BendGrid::curve(int side) const {
    const auto on = [&](int m) {
        const std::array<std::size_t, 4> places{index(m, 0), index(kCells, m), index(m, kCells),
                                                index(0, m)};
        return places[static_cast<std::size_t>(side)];
    };
    double most = 0.0;
    for (std::size_t j = 0; j <= kCells; ++j) {
        Vec3 first = Vec3::Zero();
        Vec3 second = Vec3::Zero();
        for (int m = 0; m <= kCells; ++m) {
            const Vec3& p = points_[on(m)];
            first += kFirst[j][static_cast<std::size_t>(m)] * p;
            second += kSecond[j][static_cast<std::size_t>(m)] * p;
        }
        const Vec3 tangent = first.normalized();
        most = std::max(most, (second - second.dot(tangent) * tangent).norm());
    }
    return most * kPerSide;
}

}  // namespace ew
