// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/surface_evaluator.h"

#include <algorithm>
#include <cmath>

#include "core/base/tolerance.h"
#include "core/surface/surface_rates.h"

namespace ew {
namespace {

using OpenSubdiv::Bfr::Parameterization;

/// Weights are worth the work of finding them where so many faces share them.
constexpr int kFewUses = 4;
constexpr std::size_t kMostWeights = std::size_t{8} << 20U;  // 64 MiB

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Vec3 unitNormal(const Vec3& du, const Vec3& dv) {
    const Vec3 normal = du.cross(dv);
    const double length = normal.squaredNorm();
    constexpr double kSine = tol::kNoNormalSine * tol::kNoNormalSine;
    const bool flat = length <= kSine * du.squaredNorm() * dv.squaredNorm();
    return flat ? Vec3(Vec3::Zero()) : Vec3(normal / std::sqrt(length));
}

}  // namespace

SurfaceEvaluator::SurfaceEvaluator(const ControlCage& cage, const CageEdges& edges,
                                   SubdivisionScheme scheme, LimitSurface surface)
    : cage_(cage),
      scheme_(scheme),
      surface_(std::move(surface)),
      classes_(cage, edges),
      control_(at(classes_.count())),
      sampleWeights_(at(classes_.count())),
      regular_(at(classes_.count()), false),
      budget_(kMostWeights) {}

Parameterization SurfaceEvaluator::parameterization(int face) const {
    return {scheme_ == SubdivisionScheme::Loop ? OpenSubdiv::Sdc::SCHEME_LOOP
                                               : OpenSubdiv::Sdc::SCHEME_CATMARK,
            static_cast<int>(cage_.mesh.outline(face).size())};
}

bool SurfaceEvaluator::inPlane(int face, double distance) const {
    const Vec3 normal = loopAreaVector(cage_.mesh.points, cage_.mesh.outline(face)).normalized();
    const Vec3& origin = cage_.mesh.point(cage_.mesh.outline(face)[0]);
    const auto hull = classes_.hull(face);
    return std::all_of(hull.begin(), hull.end(), [&](int i) {
        return std::abs(normal.dot(cage_.mesh.point(i) - origin)) <= distance;
    });
}

/// Where the control points of a class are in the hulls of its faces.
/// \pre the face is selected.
bool SurfaceEvaluator::learn(int face) {
    std::vector<int>& places = control_[at(classes_.of(face))];
    if (!places.empty()) return true;
    surface_.controlPoints(places);
    const auto hull = classes_.hull(face);
    for (int& place : places) {
        const auto it = std::find(hull.begin(), hull.end(), place);
        if (it == hull.end()) return false;
        place = static_cast<int>(it - hull.begin());
    }
    return true;
}

void SurfaceEvaluator::gather(int face) {
    const auto hull = classes_.hull(face);
    points_.clear();
    for (const int place : control_[at(classes_.of(face))]) {
        const Vec3& p = cage_.mesh.point(hull[at(place)]);
        points_.emplace_back(p.x(), p.y(), p.z(), 0.0);
    }
}

void SurfaceEvaluator::begin(int face, const std::vector<Vec2>& coords, PointWeights& weights) {
    face_ = face;
    coords_ = &coords;
    weights_ = &weights;
    ready_ = false;
}

/// Leaves none where they are not worth it.
bool SurfaceEvaluator::makeWeights() {
    if (!weights_->values.empty() || weights_->uses < kFewUses) return true;
    if (!surface_.select(face_) || !learn(face_)) return false;
    const std::size_t n = control_[at(classes_.of(face_))].size();
    const std::size_t size = 3 * n * coords_->size();
    if (size > budget_) return true;
    budget_ -= size;
    weights_->values.resize(size);
    double* w = weights_->values.data();
    for (const Vec2& c : *coords_) {
        surface_.weights(c.x(), c.y(), w, w + n, w + 2 * n);
        w += 3 * n;
    }
    return true;
}

bool SurfaceEvaluator::evaluate(std::size_t i, Vec3& position, Vec3& normal) {
    if (!ready_) {
        if (!makeWeights()) return false;
        if (weights_->values.empty()) {
            if (!surface_.select(face_)) return false;
        } else {
            gather(face_);
        }
        ready_ = true;
    }
    if (weights_->values.empty()) {
        Vec3 du;
        Vec3 dv;
        surface_.evaluate((*coords_)[i].x(), (*coords_)[i].y(), position, du, dv);
        normal = unitNormal(du, dv);
        return true;
    }
    const std::size_t n = points_.size();
    const double* w = weights_->values.data() + 3 * n * i;
    Point4 p = Point4::Zero();
    Point4 du = Point4::Zero();
    Point4 dv = Point4::Zero();
    for (std::size_t k = 0; k < n; ++k) {
        p += w[k] * points_[k];
        du += w[n + k] * points_[k];
        dv += w[2 * n + k] * points_[k];
    }
    position = p.head<3>();
    normal = unitNormal(du.head<3>(), dv.head<3>());
    return true;
}

const std::vector<Vec2>& SurfaceEvaluator::samples(int face, bool regular) {
    const int corners = static_cast<int>(cage_.mesh.outline(face).size());
    std::vector<Vec2>& out = samples_[{corners, regular}];
    if (out.empty()) out = rateSamples(parameterization(face), regular);
    return out;
}

SurfaceEvaluator::Samples SurfaceEvaluator::measure(int face) {
    const int index = classes_.of(face);
    if (classes_.size(index) < kFewUses) {
        if (!surface_.selectCoarse(face)) return {};
        const std::vector<Vec2>& coords = samples(face, surface_.regular());
        measured_.resize(coords.size());
        for (std::size_t i = 0; i < coords.size(); ++i) {
            measured_[i] = surface_.position(coords[i].x(), coords[i].y());
        }
        return {measured_, surface_.regular()};
    }
    std::vector<double>& weights = sampleWeights_[at(index)];
    if (weights.empty()) {
        if (!surface_.selectCoarse(face) || !learn(face)) return {};
        regular_[at(index)] = surface_.regular();
        const std::vector<Vec2>& coords = samples(face, surface_.regular());
        const std::size_t n = control_[at(index)].size();
        weights.resize(n * coords.size());
        for (std::size_t i = 0; i < coords.size(); ++i) {
            surface_.weights(coords[i].x(), coords[i].y(), weights.data() + n * i);
        }
    }
    gather(face);
    measured_.resize(samples(face, regular_[at(index)]).size());
    const double* w = weights.data();
    for (Vec3& out : measured_) {
        Point4 p = Point4::Zero();
        for (const Point4& point : points_) p += *w++ * point;
        out = p.head<3>();
    }
    return {measured_, regular_[at(index)]};
}

}  // namespace ew
