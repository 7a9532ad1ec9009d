// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/score/planes_price.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/reading/types/reading_params.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

double slantsPrice(const PlaneModel& model) {
    const auto free = std::count_if(
        model.normals.begin(), model.normals.end(),
        [](const PlaneModel::Normal& n) { return n.kind == PlaneModel::Normal::Kind::Free; });
    return params::kSlantedFacesCost *
           static_cast<double>(model.angles.size() + static_cast<std::size_t>(free));
}

double planesPrice(const PlaneModel& model) {
    std::vector<bool> offset(model.offsets.size(), false);
    std::vector<bool> normal(model.normals.size(), false);
    std::vector<bool> angle(model.angles.size(), false);
    const auto looksHere = [&](const PlaneModel::Face& f) {
        const PlaneModel::Normal& n = model.normals[at(f.normal)];
        return f.sense * (model.bodyToCamera * model.direction(n)).z() < 0.0;
    };
    double cost = slantsPrice(model);
    for (const PlaneModel::Face& f : model.faces) {
        if (!looksHere(f)) continue;
        offset[at(f.offset)] = true;
        normal[at(f.normal)] = true;
        const int a = model.normals[at(f.normal)].angle;
        if (a >= 0) angle[at(a)] = true;
    }
    using Kind = PlaneModel::Normal::Kind;
    for (std::size_t k = 0; k < model.normals.size(); ++k) {
        const PlaneModel::Normal& n = model.normals[k];
        if (n.kind == Kind::Free && !normal[k]) cost -= 2.0 * params::kFreedomCost;
    }
    for (const bool seen : angle) {
        if (!seen) cost -= params::kFreedomCost;
    }
    for (const PlaneModel::Face& f : model.faces) {
        if (offset[at(f.offset)]) continue;
        offset[at(f.offset)] = true;
        const PlaneModel::Normal& n = model.normals[at(f.normal)];
        const bool alike = normal[at(f.normal)] || n.kind == Kind::Fixed;
        const bool mirrored = n.kind == Kind::Turn && angle[at(n.angle)];
        cost -= params::kFreedomCost;
        cost += alike ? params::kParallelPlaneCost
                      : (mirrored ? params::kMirrorPlaneCost : params::kNewPlaneCost);
    }
    return cost;
}

}  // namespace ew
