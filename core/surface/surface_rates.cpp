// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/surface_rates.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/surface/bend_grid.h"

namespace ew {
namespace {

using OpenSubdiv::Bfr::Parameterization;

/// Samples are not everywhere; this much is kept in hand.
constexpr double kReserve = 1.1;
constexpr double kReserveIrregular = 1.25;
constexpr double kReserveAtPeaks = 1.35;
constexpr double kReserveUneven = 1.45;
constexpr double kReserveIrregularUneven = 1.6;
constexpr double kReserveFolded = 2.5;
constexpr double kReserveTried = 1.15;
constexpr double kReserveUnevenTried = 1.4;
/// How much farther than from the surface the pieces of a smooth edge may be from its curve, which
/// is along the surface.
constexpr double kAlongSurface = 10.0;
/// Beside an extraordinary point bends grow about as the root of the pieces that a side is cut
/// into.
constexpr double kPeakPower = 0.5;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// One cell is within the tolerance, whatever its diagonal.
bool isFlat(const Bend& b, double tolerance) {
    return std::abs(b.uu) + 2.0 * std::abs(b.uv) + std::abs(b.vv) <= 8.0 * tolerance;
}

/// Bends at the points of a square domain.
class BendField {
  public:
    explicit BendField(int grids) : side_(grids * kPerGrid), bends_(at(side_ * side_)) {}

    int side() const { return side_; }
    void put(const BendGrid& grid, int column, int row, double scale) {
        for (int k = 0; k < kPerGrid; ++k) {
            for (int i = 0; i < kPerGrid; ++i) {
                bends_[index(kPerGrid * column + i, kPerGrid * row + k)] =
                    grid.bend(i, k).scaled(scale);
            }
        }
    }
    void scaleCorner(std::size_t corner, double scale) {
        const int last = side_ - 1;
        const std::array<std::size_t, 4> corners{index(0, 0), index(last, 0), index(last, last),
                                                 index(0, last)};
        bends_[corners[corner]] = bends_[corners[corner]].scaled(scale);
    }

    bool flat(double tolerance) const {
        return std::all_of(bends_.begin(), bends_.end(),
                           [&](const Bend& b) { return isFlat(b, tolerance); });
    }

    /// The bends that decide: neither flat nor covered by others.
    std::vector<Bend> bends(double tolerance) const {
        std::vector<Bend> out;
        for (const Bend& bend : bends_) {
            if (isFlat(bend, tolerance)) continue;
            const auto covers = [&](const Bend& other) { return other.covers(bend); };
            if (std::any_of(out.begin(), out.end(), covers)) continue;
            std::erase_if(out, [&](const Bend& other) { return bend.covers(other); });
            out.push_back(bend);
        }
        return out;
    }

    /// Calls visit(bend), by the directions along an edge and away from it, for the half beside it.
    template <class Visit>
    void beside(int edge, Visit&& visit) const {
        const int half = (side_ - 1) / 2;
        const int first = edge == 1 || edge == 2 ? side_ - 1 - half : 0;
        for (int away = first; away <= first + half; ++away) {
            for (int along = 0; along < side_; ++along) {
                if (edge % 2 == 0) visit(bends_[index(along, away)]);
                if (edge % 2 == 1) visit(bends_[index(away, along)].turned());
            }
        }
    }

  private:
    static constexpr int kPerGrid = kBendCells + 1;
    std::size_t index(int i, int k) const { return at(i + side_ * k); }

    int side_;
    std::vector<Bend> bends_;
};

/// Largest distance between a quadratic function and its linear interpolation in a triangle, whose
/// sides have these second differences: it is at the middle of a side or, where the function is
/// definite and the triangle acute in its metric, at the centre of the circumcircle.
double triangleError(double a, double b, double c) {
    const double half = 0.5 * (a + b - c);
    const double area = a * b - half * half;
    const double most = std::max({std::abs(a), std::abs(b), std::abs(c)});
    const bool acute = area > 0.0 && 2.0 * most < std::abs(a + b + c);
    return 0.125 * (acute ? std::abs(a * b * c) / area : most);
}

/// The same in a cell of this size, which is cut along the better diagonal.
double cellError(const Bend& bend, double u, double v) {
    const double a = bend.uu * u * u;
    const double b = bend.vv * v * v;
    const double m = 2.0 * bend.uv * u * v;
    return std::min(triangleError(a, b, a + b + m), triangleError(a, b, a + b - m));
}

double worstCell(const std::vector<Bend>& bends, double nu, double nv) {
    double most = 0.0;
    for (const Bend& bend : bends) most = std::max(most, cellError(bend, 1.0 / nu, 1.0 / nv));
    return most;
}

/// How much farther the triangles of cells can be from the surface where they are cut along the
/// wrong diagonals, as in rows between edges that are cut otherwise.
double stitchFactor(const std::vector<Bend>& bends, double nu, double nv) {
    double most = 0.0;
    for (const Bend& bend : bends) {
        const double a = bend.uu / (nu * nu);
        const double b = bend.vv / (nv * nv);
        const double m = 2.0 * bend.uv / (nu * nv);
        most = std::max({most, triangleError(a, b, a + b + m), triangleError(a, b, a + b - m)});
    }
    const double best = worstCell(bends, nu, nv);
    return best > 0.0 ? most / best : 1.0;
}

/// Least whole number of pieces along u where there are nv along v; `most` where even so many are
/// not enough.
double fewest(const std::vector<Bend>& bends, double nv, double most, double tolerance) {
    if (worstCell(bends, 1.0, nv) <= tolerance) return 1.0;
    double low = 1.0;
    double high = most;
    while (high - low > 1.0) {
        const double middle = std::floor(0.5 * (low + high));
        (worstCell(bends, middle, nv) <= tolerance ? high : low) = middle;
    }
    return high;
}

/// Pieces along u and v with which no cell is farther than the tolerance from the surface, with
/// the fewest cells.
std::array<double, 2> piecesByBend(const std::vector<Bend>& bends, double tolerance) {
    Bend most;
    for (const Bend& b : bends) {
        most.uu = std::max(most.uu, std::abs(b.uu));
        most.uv = std::max(most.uv, std::abs(b.uv));
        most.vv = std::max(most.vv, std::abs(b.vv));
    }
    // Cells as long as the bend asks for; an error is as the square of the size.
    constexpr double kLongest = 30.0;
    const double mixed = 1e-3 * most.uv + 1e-300;
    const double ratio =
        std::clamp(std::sqrt((most.uu + mixed) / (most.vv + mixed)), 1.0 / kLongest, kLongest);
    const double root = std::sqrt(ratio);
    const double size = std::sqrt(worstCell(bends, root, 1.0 / root) / tolerance);
    const double nu = std::max(1.0, size * root);
    const double nv = std::max(1.0, size / root);
    constexpr double kMany = 12.0;
    if (std::min(nu, nv) > kMany) return {std::ceil(nu), std::ceil(nv)};
    // Few pieces along one side: whole numbers differ much.
    const bool fewAlongV = nv <= nu;
    const double few = fewAlongV ? nv : nu;
    std::vector<Bend> turned;
    if (!fewAlongV) {
        for (const Bend& b : bends) turned.push_back(b.turned());
    }
    const std::vector<Bend>& sideways = fewAlongV ? bends : turned;
    std::array<double, 2> best{};
    double cells = std::numeric_limits<double>::infinity();
    const double first = std::max(1.0, std::floor(0.7 * few));
    for (double n = first; n <= std::ceil(1.2 * few); n += 1.0) {
        const double limit = std::min(4.0 * std::max(nu, nv) + 4.0, cells / n);
        const double m = fewest(sideways, n, std::ceil(limit), tolerance);
        if (m * n >= cells || worstCell(sideways, m, n) > tolerance) continue;
        cells = m * n;
        best = {m, n};
    }
    if (!std::isfinite(cells)) return {std::ceil(nu), std::ceil(nv)};
    return fewAlongV ? best : std::array<double, 2>{best[1], best[0]};
}

/// Pieces along u and v.
/// \param few  tells whether nu x nv cells, 1 or 2 each, are near enough.
template <class Few>
std::array<double, 2> pieces(const std::vector<Bend>& bends, double tolerance, const Few& few) {
    if (worstCell(bends, 1.0, 1.0) <= tolerance) return {1.0, 1.0};
    constexpr double kWorthTrying = 4.0;
    const auto tryThem = [&](int nu, int nv) {
        return worstCell(bends, nu, nv) <= kWorthTrying * tolerance && few(nu, nv);
    };
    if (tryThem(1, 1)) return {1.0, 1.0};
    const auto out = piecesByBend(bends, tolerance);
    if (out[0] * out[1] <= 2.0) return out;
    if (tryThem(2, 1)) return {2.0, 1.0};
    if (tryThem(1, 2)) return {1.0, 2.0};
    if (out[0] * out[1] > 4.0 && tryThem(2, 2)) return {2.0, 2.0};
    return out;
}

/// Pieces along an edge, where the row beside it is one of n and its triangles are cut along either
/// diagonal.
double edgePieces(const BendField& field, int edge, double n, double tolerance) {
    double most = 1.0;
    field.beside(edge, [&](const Bend& bend) {
        if (isFlat(bend, tolerance)) return;
        const double room = 8.0 * tolerance - std::abs(bend.vv) / (n * n);
        const double mixed = std::abs(bend.uv) / n;
        // |uu| x^2 + 2 mixed x = room for the length x of a piece.
        const double root = std::sqrt(mixed * mixed + std::abs(bend.uu) * std::max(room, 0.0));
        most = std::max(most, (mixed + root) / std::max(room, 1e-3 * tolerance));
    });
    return most;
}

double curvePieces(double bend, double tolerance) { return std::sqrt(bend / (8.0 * tolerance)); }

/// A quadrangle's samples as grids: all of it and, where it is sampled twice as densely, its
/// quarters.
class QuadSamples {
  public:
    explicit QuadSamples(std::span<const Vec3> points)
        : points_(points), dense_(points.size() > kBendPoints) {
        if (dense_) pick(0, 0, 2, whole_);
    }

    BendGrid whole() const { return BendGrid(dense_ ? std::span<const Vec3>(whole_) : points_); }

    /// \pre sampled twice as densely.
    BendField quarters() const {
        BendField out(2);
        std::array<Vec3, kBendPoints> quarter;
        for (int row = 0; row < 2; ++row) {
            for (int column = 0; column < 2; ++column) {
                pick(column * kBendCells, row * kBendCells, 1, quarter);
                // Derivatives by the half side are a quarter of those by the side.
                out.put(BendGrid(quarter), column, row, 4.0);
            }
        }
        return out;
    }

  private:
    void pick(int i0, int k0, int step, std::array<Vec3, kBendPoints>& out) const {
        auto to = out.begin();
        for (int k = 0; k <= kBendCells; ++k) {
            for (int i = 0; i <= kBendCells; ++i) {
                *to++ = points_[at(i0 + step * i + (2 * kBendCells + 1) * (k0 + step * k))];
            }
        }
    }

    std::span<const Vec3> points_;
    bool dense_;
    std::array<Vec3, kBendPoints> whole_{};
};

/// How much the bend at an extraordinary point is more than sampled, where a side is cut into n.
double peakFactor(double n) {
    constexpr double kSampled = 2.0 * kBendCells;
    return std::pow(std::max(1.0, n / kSampled), kPeakPower);
}

bool hasPeak(const FaceSamples& face) {
    return std::find(face.peaks.begin(), face.peaks.end(), true) != face.peaks.end();
}

double reserve(const FaceSamples& face, const BendGrid& grid) {
    if (grid.folded()) return kReserveFolded;
    if (face.regular) return grid.uneven() ? kReserveUneven : kReserve;
    if (grid.uneven()) return kReserveIrregularUneven;
    return hasPeak(face) ? kReserveAtPeaks : kReserveIrregular;
}

/// Pieces inside a quadrangle that one cell does not do for.
void divide(const FaceSamples& face, const BendGrid& grid, double tolerance, BendField& field,
            FaceRates& out) {
    const double tried =
        tolerance * reserve(face, grid) / (grid.uneven() ? kReserveUnevenTried : kReserveTried);
    const auto few = [&](int nu, int nv) {
        const int cells = face.points.size() > kBendPoints ? 2 * kBendCells : kBendCells;
        return !grid.folded() && grid.deviation(face.points, cells, nu, nv) <= tried;
    };
    std::vector<Bend> bends = field.bends(tolerance);
    out.inner = pieces(bends, tolerance, few);
    const double peak = peakFactor(std::max(out.inner[0], out.inner[1]));
    if (peak > 1.0 && hasPeak(face)) {
        for (std::size_t k = 0; k < 4; ++k) {
            if (face.peaks[k]) field.scaleCorner(k, peak);
        }
        bends = field.bends(tolerance);
        out.inner = pieces(bends, tolerance, few);
    }
    constexpr double kMostStitched = 2.0;
    const double more =
        std::sqrt(std::min(kMostStitched, stitchFactor(bends, out.inner[0], out.inner[1])));
    out.stitched = {std::round(more * out.inner[0]), std::round(more * out.inner[1])};
}

FaceRates quadRates(const FaceSamples& face, double tolerance) {
    const QuadSamples samples(face.points);
    const BendGrid grid = samples.whole();
    tolerance /= reserve(face, grid);
    FaceRates out;
    out.inner = out.stitched = {1.0, 1.0};
    out.edges.assign(4, 1.0);
    // So little bend is none between the points either.
    constexpr double kNone = 0.02;
    BendField field(1);
    field.put(grid, 0, 0, 1.0);
    bool flat = field.flat(kNone * tolerance);
    if (!flat) {
        if (face.points.size() > kBendPoints) field = samples.quarters();
        flat = field.flat(tolerance);
    }
    if (!flat) divide(face, grid, tolerance, field, out);
    for (int side = 0; side < 4; ++side) {
        double& rate = out.edges[at(side)];
        // Rows beside an edge are as high as those inside. Where the edge is cut as they are, its
        // cells are like theirs.
        const double along = out.inner[side % 2 == 0 ? 0 : 1];
        const double away = out.inner[side % 2 == 0 ? 1 : 0];
        if (!flat) rate = std::min(edgePieces(field, side, away, tolerance), along);
        if (!flat || face.hard[at(side)]) {
            const double room = face.hard[at(side)] ? tolerance : kAlongSurface * tolerance;
            rate = std::max(rate, curvePieces(grid.curve(side), room));
        }
    }
    return out;
}

/// Edge lengths of the triangles that a corner's square domain is cut into, in its units, squared
/// and halved: the hypotenuse adds both directions.
double evenPieces(const std::vector<Bend>& bends, double tolerance) {
    // The pattern's triangles are not all cut along the two directions measured.
    constexpr double kOtherWays = 1.1;
    double most = 0.0;
    for (const Bend& b : bends) {
        most = std::max(most, std::abs(b.uu) + 2.0 * std::abs(b.uv) + std::abs(b.vv));
    }
    return std::max(1.0, std::sqrt(kOtherWays * most / (8.0 * tolerance)));
}

/// Triangles and polygons are cut alike in all directions.
FaceRates evenRates(const FaceSamples& face, std::size_t corners, double tolerance) {
    std::vector<double> curves(corners, 0.0);
    double most = 1.0;
    for (std::size_t k = 0; k < corners; ++k) {
        const BendGrid grid(face.points.subspan(k * kBendPoints, kBendPoints));
        BendField field(1);
        // Derivatives by the half side are a quarter of those by the side.
        field.put(grid, 0, 0, 4.0);
        double pieceCount = evenPieces(field.bends(tolerance), tolerance);
        const double peak = peakFactor(pieceCount);
        if (peak > 1.0) {
            // Round the middle of a polygon there are as many faces as it has corners.
            if (corners > 4) field.scaleCorner(2, peak);
            if (face.peaks[k]) field.scaleCorner(0, peak);
            pieceCount = evenPieces(field.bends(tolerance), tolerance);
        }
        most = std::max(most, pieceCount);
        // A corner has its own edge along s and the one before along t.
        double& own = curves[k];
        double& before = curves[(k + corners - 1) % corners];
        own = std::max(own, 4.0 * grid.curve(0));
        before = std::max(before, 4.0 * grid.curve(3));
    }
    FaceRates out;
    out.inner = {most, most};
    out.stitched = out.inner;
    for (std::size_t k = 0; k < corners; ++k) {
        out.edges.push_back(std::max(most, face.hard[k] ? curvePieces(curves[k], tolerance) : 0.0));
    }
    return out;
}

}  // namespace

std::vector<Vec2> rateSamples(const Parameterization& face, bool regular) {
    std::vector<Vec2> out;
    const auto add = [&](int cells, const auto& place) {
        for (int k = 0; k <= cells; ++k) {
            for (int i = 0; i <= cells; ++i) {
                out.push_back(
                    place(static_cast<double>(i) / cells, static_cast<double>(k) / cells));
            }
        }
    };
    if (face.GetType() == Parameterization::QUAD) {
        add(regular ? kBendCells : 2 * kBendCells, [](double s, double t) { return Vec2(s, t); });
        return out;
    }
    if (face.GetType() == Parameterization::TRI) {
        // A square at each corner, half the triangle's side long: it is folded along the triangle's
        // diagonal, each half stays inside.
        add(kBendCells, [](double s, double t) { return Vec2(0.5 * s, 0.5 * t); });
        add(kBendCells, [](double s, double t) { return Vec2(1.0 - 0.5 * s - 0.5 * t, 0.5 * s); });
        add(kBendCells, [](double s, double t) { return Vec2(0.5 * t, 1.0 - 0.5 * s - 0.5 * t); });
        return out;
    }
    for (int k = 0; k < face.GetFaceSize(); ++k) {
        add(kBendCells, [&](double s, double t) {
            const double sub[2] = {s, t};
            Vec2 uv;
            face.ConvertNormalizedSubFaceToCoord(k, sub, uv.data());
            return uv;
        });
    }
    return out;
}

FaceRates facePieces(const Parameterization& face, const FaceSamples& samples, double tolerance) {
    if (face.GetType() == Parameterization::QUAD) return quadRates(samples, tolerance);
    const double kept = samples.regular    ? kReserve
                        : hasPeak(samples) ? kReserveAtPeaks
                                           : kReserveIrregular;
    return evenRates(samples, at(face.GetFaceSize()), tolerance / kept);
}

}  // namespace ew
