// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/plane_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/tolerance.h"
#include "core/solid/validity.h"

namespace ew {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

/// The coordinate that all points of a face share to the bit, -1 where there is none.
int sharedAxis(const PolyhedronSpec& spec, const std::vector<int>& face) {
    for (int axis = 0; axis < 3; ++axis) {
        const double c = spec.vertices[idx(face[0])][axis];
        if (std::all_of(face.begin(), face.end(),
                        [&](int i) { return spec.vertices[idx(i)][axis] == c; })) {
            return axis;
        }
    }
    return -1;
}

double roundedTo(double value, double grid) { return std::round(value / grid) * grid; }

/// Scales the largest component to 1 and rounds the others.
Vec3 fewBits(const Vec3& normal) {
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    Vec3 out = normal / normal[axis];
    for (int k = 0; k < 3; ++k) out[k] = roundedTo(out[k], tol::kPlaneGrid);
    out[axis] = 1.0;
    return out;
}

struct Direction {
    Vec3 unit;    ///< of the first face that has it
    Vec3 normal;  ///< rounded
};

class Fitter {
  public:
    explicit Fitter(const PolyhedronSpec& spec) : spec_(spec), size_(sizeOf(spec.vertices)) {
        // A power of two, so that rounding to it only drops bits.
        grid_ = tol::kPlaneGrid * std::exp2(std::floor(std::log2(size_)));
        for (const Vec3& p : spec.vertices) {
            center_ += p / static_cast<double>(spec.vertices.size());
        }
    }

    std::vector<FittedPlane> run() {
        // Axis planes first: a face that is parallel to one but for rounding takes its direction.
        std::vector<std::size_t> order(spec_.faces.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::stable_partition(order.begin(), order.end(), [&](std::size_t f) {
            return sharedAxis(spec_, spec_.faces[f]) >= 0;
        });
        for (const std::size_t f : order) add(spec_.faces[f], static_cast<int>(f));
        for (FittedPlane& plane : planes_) {
            std::sort(plane.points.begin(), plane.points.end());
            plane.points.erase(std::unique(plane.points.begin(), plane.points.end()),
                               plane.points.end());
        }
        return std::move(planes_);
    }

  private:
    const Direction& directionOf(const Vec3& unit, int axis) {
        for (const Direction& d : directions_) {
            if (d.unit.cross(unit).norm() < tol::kParallelSine) return d;
        }
        directions_.push_back({unit, axis >= 0 ? Vec3(Vec3::Unit(axis)) : fewBits(unit)});
        return directions_.back();
    }

    void add(const std::vector<int>& face, int index) {
        const int axis = sharedAxis(spec_, face);
        const Vec3 unit = axis >= 0 ? Vec3(Vec3::Unit(axis)) : newellNormal(spec_.vertices, face);
        const Vec3 normal = directionOf(unit, axis).normal;
        // Measured from the middle of the solid: far from the origin, a rounding of the normal
        // would weigh more than the points.
        double middle = 0.0;
        for (const int i : face) {
            middle +=
                normal.dot(spec_.vertices[idx(i)] - center_) / static_cast<double>(face.size());
        }
        const double offset = axis >= 0 ? spec_.vertices[idx(face[0])][axis]
                                        : roundedTo(middle + normal.dot(center_), grid_);
        for (FittedPlane& plane : planes_) {
            if (plane.normal != normal) continue;
            if (std::abs(plane.offset - offset) > tol::kSamePlaneRelative * size_) continue;
            plane.points.insert(plane.points.end(), face.begin(), face.end());
            plane.faces.push_back(index);
            return;
        }
        planes_.push_back({normal, offset, axis, face, {index}});
    }

    const PolyhedronSpec& spec_;
    double size_;
    double grid_ = 0.0;
    Vec3 center_ = Vec3::Zero();
    std::vector<Direction> directions_;
    std::vector<FittedPlane> planes_;
};

}  // namespace

std::vector<FittedPlane> fitPlanes(const PolyhedronSpec& spec) { return Fitter(spec).run(); }

}  // namespace ew
