// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/tolerance.h"
#include "core/surface/fillet_build.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

struct Ball {
    Vec3 center;
    double radius;
};

class Patch {
  public:
    Patch(PolyMesh& mesh, std::span<const PatchSide> sides)
        : mesh_(mesh),
          sides_(sides),
          count_(static_cast<int>(sides.size())),
          segments_(static_cast<int>(sides[0].ids.size()) - 1),
          half_(segments_ / 2),
          grids_(sides.size()) {}

    void fill() {
        findBall();
        findMiddle();
        const bool even = segments_ % 2 == 0;
        if (even) center_ = mesh_.addPoint(onBall(middle_));
        for (int i = 0; i < count_; ++i) makeGrid(i);
        for (int i = 0; i < count_; ++i) addGrid(i);
        if (even) return;
        for (int i = 0; i < count_; ++i) addSeam(i);
        std::vector<int> ring;
        for (int i = 0; i < count_; ++i) ring.push_back(id(i, half_, half_));
        mesh_.addFace(ring);
    }

  private:
    const PatchSide& side(int i) const { return sides_[at((i + count_) % count_)]; }
    const Vec3& sidePoint(int i, int k) const { return mesh_.point(side(i).ids[at(k)]); }
    int id(int i, int p, int q) const {
        return grids_[at((i + count_) % count_)][at(p * (half_ + 1) + q)];
    }

    /// The ball that touches all strips, if there is one.
    void findBall() {
        const PatchSide& first = sides_[0];
        const double slack = tol::kFilletSamePoint * first.radius;
        for (const PatchSide& s : sides_) {
            if (!s.square || s.convex != first.convex) return;
            if (std::abs(s.radius - first.radius) > slack) return;
            if ((s.center - first.center).norm() > slack) return;
        }
        ball_ = Ball{first.center, first.radius};
    }

    Vec3 onBall(const Vec3& p) const {
        if (!ball_) return p;
        return ball_->center + ball_->radius * (p - ball_->center).normalized();
    }

    void findMiddle() {
        Vec3 middles = Vec3::Zero();
        Vec3 corners = Vec3::Zero();
        for (int i = 0; i < count_; ++i) {
            middles += side(i).middle;
            corners += sidePoint(i, 0);
        }
        middles /= count_;
        corners /= count_;
        // The middle of a bilinear Coons patch for four sides; for three, what puts it on the
        // sphere for the corner of a cube.
        const double bulge = count_ == 3 ? 0.768 : 1.0;
        middle_ = middles + bulge * (middles - corners);
        normal_ = Vec3::Zero();
        for (int i = 0; i < count_; ++i) {
            normal_ += (side(i).middle - middles).cross(side(i + 1).middle - middles);
        }
        const double length = normal_.norm();
        if (length > 0.0) normal_ /= length;
    }

    /// From the middle of side i (t = 0) to the middle of the patch (t = 1), leaving the strip and
    /// arriving at the middle without a bend.
    Vec3 spoke(int i, double t) const {
        const Vec3& from = side(i).middle;
        const Vec3 chord = middle_ - from;
        const double reach = chord.norm() / 3.0;
        Vec3 arriving = chord - normal_ * normal_.dot(chord);
        const double length = arriving.norm();
        arriving = length > 0.0 ? Vec3(arriving * (reach / length)) : Vec3(Vec3::Zero());
        const Vec3 b1 = from + reach * side(i).inward;
        const Vec3 b2 = middle_ - arriving;
        const double s = 1.0 - t;
        return s * s * s * from + 3.0 * s * s * t * b1 + 3.0 * s * t * t * b2 + t * t * t * middle_;
    }

    /// A bilinearly blended Coons patch between corner i, the middles of its two sides, and the
    /// middle; u runs along side i, v back along the side before.
    Vec3 place(int i, int p, int q) const {
        const double u = 2.0 * p / segments_;
        const double v = 2.0 * q / segments_;
        const Vec3& corner = sidePoint(i, 0);
        const Vec3 ruled = (1.0 - v) * sidePoint(i, p) + v * spoke(i - 1, u) +
                           (1.0 - u) * sidePoint(i - 1, segments_ - q) + u * spoke(i, v);
        const Vec3 bilinear = (1.0 - u) * (1.0 - v) * corner + u * (1.0 - v) * side(i).middle +
                              (1.0 - u) * v * side(i - 1).middle + u * v * middle_;
        return onBall(ruled - bilinear);
    }

    void makeGrid(int i) {
        const bool even = segments_ % 2 == 0;
        auto& grid = grids_[at(i)];
        grid.resize(at((half_ + 1) * (half_ + 1)));
        for (int p = 0; p <= half_; ++p) {
            for (int q = 0; q <= half_; ++q) {
                int& point = grid[at(p * (half_ + 1) + q)];
                if (q == 0) {
                    point = side(i).ids[at(p)];
                } else if (p == 0) {
                    point = side(i - 1).ids[at(segments_ - q)];
                } else if (even && p == half_ && q == half_) {
                    point = center_;
                } else if (even && q == half_ && i > 0) {
                    point = id(i - 1, half_, p);  // the spoke that both share
                } else if (even && p == half_ && i == count_ - 1) {
                    point = id(0, q, half_);
                } else {
                    point = mesh_.addPoint(place(i, p, q));
                }
            }
        }
    }

    void addGrid(int i) {
        for (int p = 0; p < half_; ++p) {
            for (int q = 0; q < half_; ++q) {
                mesh_.addFace({id(i, p, q), id(i, p + 1, q), id(i, p + 1, q + 1), id(i, p, q + 1)});
            }
        }
    }

    void addSeam(int i) {
        for (int q = 0; q < half_; ++q) {
            mesh_.addFace({id(i, half_, q), id(i + 1, q, half_), id(i + 1, q + 1, half_),
                           id(i, half_, q + 1)});
        }
    }

    PolyMesh& mesh_;
    std::span<const PatchSide> sides_;
    int count_;
    int segments_;
    int half_;
    std::vector<std::vector<int>> grids_;
    std::optional<Ball> ball_;
    Vec3 middle_ = Vec3::Zero();
    Vec3 normal_ = Vec3::Zero();
    int center_ = -1;
};

}  // namespace

void addCornerPatch(PolyMesh& mesh, std::span<const PatchSide> sides) { Patch(mesh, sides).fill(); }

std::array<double, 2> arcWeights(double foldCosine, double t) {
    // The arc turns by the supplement of the angle between the faces.
    const double turn = std::acos(std::clamp(-foldCosine, -1.0, 1.0));
    if (turn < tol::kFilletArcAngle) return {1.0 - t, t};
    const double center = 1.0 / (1.0 + foldCosine);
    const double w0 = std::sin((1.0 - t) * turn) / std::sin(turn);
    const double w1 = std::sin(t * turn) / std::sin(turn);
    return {center + w0 * (1.0 - center) - w1 * center, center - w0 * center + w1 * (1.0 - center)};
}

}  // namespace ew
