// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/modeling/model_view.h"
#include "core/solid/exact_tool.h"

namespace ew {

/// A direction that the model has, and where from.
struct ModelDirection {
    Vec3 direction = Vec3::UnitX();  ///< unit, camera space
    ToolEdgeRule::Kind kind = ToolEdgeRule::Kind::AlongEdge;
    int index = -1;  ///< as in ToolEdgeRule
    int other = -1;
};

/// Directions of the edges and normals of some faces and of their neighbours, each once; those of
/// the faces themselves first. Last those that lie in one of these faces across one of its edges.
std::vector<ModelDirection> directionsNear(const ModelView& model, const std::vector<int>& faces);

}  // namespace ew
