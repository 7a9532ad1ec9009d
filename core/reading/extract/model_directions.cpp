// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/extract/model_directions.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/tolerance.h"

namespace ew {

namespace {

std::vector<ModelDirection> collect(const ModelView& model, const std::set<int>& own) {
    std::vector<ModelDirection> known;
    const auto add = [&](const Vec3& d, ToolEdgeRule::Kind kind, int index, int other = -1) {
        const bool have = std::any_of(known.begin(), known.end(), [&](const ModelDirection& k) {
            return k.direction.cross(d).norm() < tol::kSolidDirection;
        });
        if (!have) known.push_back({d, kind, index, other});
    };
    const auto& solid = model.solid();
    const auto addAll = [&](const std::set<int>& some) {
        for (const int f : some) {
            add(model.plane(f).normal, ToolEdgeRule::Kind::AlongNormal, f);
        }
        for (const int f : some) {
            for (const int e : model.edgesOf(f)) {
                add(model.edgeDirection(e), ToolEdgeRule::Kind::AlongEdge, e);
            }
        }
    };
    addAll(own);
    std::set<int> around;
    for (const int f : own) {
        for (const int e : model.edgesOf(f)) {
            for (const int g : solid.edges()[static_cast<std::size_t>(e)].faces) {
                if (!own.contains(g)) around.insert(g);
            }
        }
    }
    addAll(around);
    for (const int f : own) {
        for (const int e : model.edgesOf(f)) {
            add(model.plane(f).normal.cross(model.edgeDirection(e)).normalized(),
                ToolEdgeRule::Kind::AcrossEdge, e, f);
        }
    }
    return known;
}

}  // namespace

const std::vector<ModelDirection>& directionsNear(const ModelView& model,
                                                  const std::vector<int>& faces) {
    const std::set<int> own(faces.begin(), faces.end());
    ModelView::DirectionMemo& memo = model.directionMemo();
    std::vector<int> key(own.begin(), own.end());
    const auto known = memo.find(key);
    if (known != memo.end()) return known->second;
    return memo.emplace(std::move(key), collect(model, own)).first->second;
}

}  // namespace ew
