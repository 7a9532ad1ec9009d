// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/modeling/model_directions.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/tolerance.h"

namespace ew {

std::vector<ModelDirection> directionsNear(const ModelView& model, const std::vector<int>& faces) {
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
        for (std::size_t e = 0; e < solid.edges().size(); ++e) {
            const auto& sides = solid.edges()[e].faces;
            if (!some.contains(sides[0]) && !some.contains(sides[1])) continue;
            add(model.edgeDirection(static_cast<int>(e)), ToolEdgeRule::Kind::AlongEdge,
                static_cast<int>(e));
        }
    };
    const std::set<int> own(faces.begin(), faces.end());
    addAll(own);
    std::set<int> around;
    for (const SolidEdge& e : solid.edges()) {
        for (std::size_t s = 0; s < 2; ++s) {
            if (own.contains(e.faces[s]) && !own.contains(e.faces[1 - s])) {
                around.insert(e.faces[1 - s]);
            }
        }
    }
    addAll(around);
    for (std::size_t e = 0; e < solid.edges().size(); ++e) {
        for (const int f : solid.edges()[e].faces) {
            if (!own.contains(f)) continue;
            const int ei = static_cast<int>(e);
            add(model.plane(f).normal.cross(model.edgeDirection(ei)).normalized(),
                ToolEdgeRule::Kind::AcrossEdge, ei, f);
        }
    }
    return known;
}

}  // namespace ew
