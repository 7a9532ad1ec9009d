// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/surface_rates.h"

#include <algorithm>
#include <cmath>

namespace ew {
namespace {

using OpenSubdiv::Bfr::Parameterization;

constexpr int kCells = 4;  ///< samples are kCells + 1 a side

constexpr std::size_t kPoints = (kCells + 1) * (kCells + 1);

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Points of a square domain and how much the surface bends there.
class Grid {
  public:
    explicit Grid(std::span<const Vec3> points) : points_(points) {
        for (int k = 0; k <= kCells; ++k) {
            for (int i = 0; i <= kCells; ++i) measure(i, k);
        }
    }

    /// Second derivatives out of the tangent plane, largest over rows k0..k1 and columns i0..i1.
    Vec3 bend(int i0, int i1, int k0, int k1) const {
        Vec3 most = Vec3::Zero();
        for (int k = k0; k <= k1; ++k) {
            for (int i = i0; i <= i1; ++i) most = most.cwiseMax(bends_[index(i, k)]);
        }
        return most;
    }

    /// Second derivative of a border curve in all directions.
    double curve(int side) const {
        double most = 0.0;
        for (int j = 1; j < kCells; ++j) {
            const auto p = [&](int m) {
                switch (side) {
                    case 0:
                        return points_[index(m, 0)];
                    case 1:
                        return points_[index(kCells, m)];
                    case 2:
                        return points_[index(m, kCells)];
                    default:
                        return points_[index(0, m)];
                }
            };
            most = std::max(most, (p(j - 1) - 2.0 * p(j) + p(j + 1)).norm() * kCells * kCells);
        }
        return most;
    }

  private:
    static std::size_t index(int i, int k) { return at(i + (kCells + 1) * k); }
    static int inside(int i) { return std::clamp(i, 1, kCells - 1); }

    void measure(int i, int k) {
        const auto p = [&](int a, int b) -> const Vec3& { return points_[index(a, b)]; };
        const int ci = inside(i);
        const int ck = inside(k);
        const Vec3 du = p(ci + 1, k) - p(ci - 1, k);
        const Vec3 dv = p(i, ck + 1) - p(i, ck - 1);
        Vec3 n = du.cross(dv);
        const double length = n.norm();
        if (length > 0.0) n /= length;
        const double scale = kCells * kCells;
        bends_[index(i, k)] = Vec3(std::abs(n.dot(p(ci - 1, k) - 2.0 * p(ci, k) + p(ci + 1, k))),
                                   std::abs(n.dot(p(i, ck - 1) - 2.0 * p(i, ck) + p(i, ck + 1))),
                                   0.25 * std::abs(n.dot(p(ci + 1, ck + 1) - p(ci - 1, ck + 1) -
                                                         p(ci + 1, ck - 1) + p(ci - 1, ck - 1)))) *
                              scale;
    }

    std::span<const Vec3> points_;
    std::array<Vec3, kPoints> bends_;
};

/// Pieces along u and v so that (uu / nu^2 + 2 uv / (nu nv) + vv / nv^2) / 8 <= tolerance, with the
/// fewest cells.
std::array<double, 2> pieces(const Vec3& bend, double tolerance) {
    const double limit = 8.0 * tolerance;
    const double ratio = std::clamp(
        std::sqrt((bend[0] + 1e-3 * bend[2]) / (bend[1] + 1e-3 * bend[2] + 1e-300)), 0.1, 10.0);
    const double a = (bend[0] + bend[2] * ratio) / limit;
    const double b = (bend[1] + bend[2] / ratio) / limit;
    if (2.0 * a <= 1.0 && 2.0 * b <= 1.0) return {1.0, 1.0};
    if (2.0 * b <= 1.0) return {std::sqrt(a / (1.0 - b)), 1.0};
    if (2.0 * a <= 1.0) return {1.0, std::sqrt(b / (1.0 - a))};
    return {std::sqrt(2.0 * a), std::sqrt(2.0 * b)};
}

/// Pieces along u for the same bound where there are nv along v already.
double piecesAlong(const Vec3& bend, double nv, double tolerance) {
    const double room = 8.0 * tolerance - bend[1] / (nv * nv);
    const double mixed = bend[2] / nv;
    // uu x^2 + 2 mixed x = room for the length x of a piece.
    const double root = std::sqrt(mixed * mixed + bend[0] * std::max(room, 0.0));
    return std::max(1.0, (mixed + root) / std::max(room, 1e-3 * tolerance));
}

double curvePieces(double bend, double tolerance) { return std::sqrt(bend / (8.0 * tolerance)); }

FaceRates quadRates(std::span<const Vec3> samples, double tolerance,
                    const std::vector<bool>& hard) {
    const Grid grid(samples);
    constexpr int kHalf = kCells / 2;
    FaceRates out;
    out.inner = pieces(grid.bend(0, kCells, 0, kCells), tolerance);
    // Rows beside an edge are as high as those inside.
    const double nu = std::ceil(out.inner[0]);
    const double nv = std::ceil(out.inner[1]);
    const auto turned = [](const Vec3& bend) { return Vec3(bend[1], bend[0], bend[2]); };
    out.edges = {piecesAlong(grid.bend(0, kCells, 0, kHalf), nv, tolerance),
                 piecesAlong(turned(grid.bend(kHalf, kCells, 0, kCells)), nu, tolerance),
                 piecesAlong(grid.bend(0, kCells, kHalf, kCells), nv, tolerance),
                 piecesAlong(turned(grid.bend(0, kHalf, 0, kCells)), nu, tolerance)};
    for (int k = 0; k < 4; ++k) {
        if (!hard[at(k)]) continue;
        out.edges[at(k)] = std::max(out.edges[at(k)], curvePieces(grid.curve(k), tolerance));
    }
    return out;
}

/// Triangles and polygons are cut alike in all directions.
FaceRates evenRates(double pieceCount, const std::vector<double>& curves,
                    const std::vector<bool>& hard, double tolerance) {
    FaceRates out;
    out.inner = {pieceCount, pieceCount};
    for (std::size_t k = 0; k < hard.size(); ++k) {
        const double curve = hard[k] ? curvePieces(curves[k], tolerance) : 0.0;
        out.edges.push_back(std::max(pieceCount, curve));
    }
    return out;
}

/// Edge lengths of the triangles that a corner's square domain is cut into, in its units, squared
/// and halved: the hypotenuse adds both directions.
double evenPieces(const Vec3& bend, double tolerance) {
    // The pattern's triangles are not all cut along the two directions measured.
    constexpr double kReserve = 1.1;
    return std::max(1.0,
                    std::sqrt(kReserve * (bend[0] + 2.0 * bend[2] + bend[1]) / (8.0 * tolerance)));
}

}  // namespace

std::vector<Vec2> rateSamples(const Parameterization& face) {
    std::vector<Vec2> out;
    const auto add = [&](const auto& place) {
        for (int k = 0; k <= kCells; ++k) {
            for (int i = 0; i <= kCells; ++i) {
                out.push_back(
                    place(static_cast<double>(i) / kCells, static_cast<double>(k) / kCells));
            }
        }
    };
    if (face.GetType() == Parameterization::QUAD) {
        add([](double s, double t) { return Vec2(s, t); });
        return out;
    }
    if (face.GetType() == Parameterization::TRI) {
        // A square at each corner, half the triangle's side long: it is folded along the triangle's
        // diagonal, each half stays inside.
        add([](double s, double t) { return Vec2(0.5 * s, 0.5 * t); });
        add([](double s, double t) { return Vec2(1.0 - 0.5 * s - 0.5 * t, 0.5 * s); });
        add([](double s, double t) { return Vec2(0.5 * t, 1.0 - 0.5 * s - 0.5 * t); });
        return out;
    }
    for (int k = 0; k < face.GetFaceSize(); ++k) {
        add([&](double s, double t) {
            const double sub[2] = {s, t};
            Vec2 uv;
            face.ConvertNormalizedSubFaceToCoord(k, sub, uv.data());
            return uv;
        });
    }
    return out;
}

FaceRates facePieces(const Parameterization& face, std::span<const Vec3> samples, bool regular,
                     double tolerance, const std::vector<bool>& hard) {
    // Samples miss the extreme bend by a little; this much is kept in hand.
    tolerance /= regular ? 1.15 : 1.3;
    if (face.GetType() == Parameterization::QUAD) return quadRates(samples, tolerance, hard);
    const int n = face.GetFaceSize();
    std::vector<double> curves(at(n), 0.0);
    double most = 1.0;
    for (int k = 0; k < n; ++k) {
        const Grid grid(samples.subspan(at(k) * kPoints, kPoints));
        // Derivatives by the half side are a quarter of those by the side.
        const Vec3 bend = 4.0 * grid.bend(0, kCells, 0, kCells);
        most = std::max(most, evenPieces(bend, tolerance));
        // A corner has its own edge along s and the one before along t.
        double& own = curves[at(k)];
        double& before = curves[at((k + n - 1) % n)];
        own = std::max(own, 4.0 * grid.curve(0));
        before = std::max(before, 4.0 * grid.curve(3));
    }
    return evenRates(most, curves, hard, tolerance);
}

}  // namespace ew
