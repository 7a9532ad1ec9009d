// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/edge_graph/faces.h"

namespace ew {

/// One way to walk a plane graph that gives its canonical code.
struct CanonicalWalk {
    std::vector<int> vertices;  ///< in order of the walk
    bool mirrored = false;      ///< the walk turns counter-clockwise
};

/// The canonical code of a connected plane graph: equal codes exactly where two graphs are the same
/// up to a map of the sphere onto itself that may mirror.
struct CanonicalForm {
    std::string code;
    std::vector<CanonicalWalk> walks;  ///< every walk with this code: one an automorphism
};

/// A walk is fixed by its first directed edge and its sense of rotation, because the rotation
/// around every junction does the rest; the code is the least over all 4 E walks. O(E^2); empty for
/// graphs that are not connected or have no edge.
CanonicalForm canonicalForm(const PlaneGraph& graph);

/// A cheap invariant: equal for graphs of equal code.
std::size_t graphSignature(const PlaneGraph& graph);

}  // namespace ew
