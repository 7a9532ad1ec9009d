// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/tlib/found_relations.h"

namespace ew {

/// How far relations settle a shape.
struct TemplateFreedom {
    int open = 0;               ///< ways in which instances differ besides place, attitude and size
    std::vector<bool> follows;  ///< per relation: it says nothing that faces being flat and the
                                ///< relations before it do not say
};

/// Counts to first order, at the reference shape: the rank of what flat faces and relations ask of
/// small moves of the vertices. A shape that is more regular than its relations can hide a freedom
/// in this way, or show one that ends at once. O(rows * V^2): 10 ms at 64 vertices.
/// \pre the template passes checkTemplate with these relations.
TemplateFreedom countFreedom(const PolyhedronSpec& shape,
                             const std::vector<FoundRelation>& relations);

}  // namespace ew
