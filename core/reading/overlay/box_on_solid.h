// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/edge_graph/build.h"
#include "core/reading/extract/joint_graph.h"
#include "core/reading/extract/model_view.h"
#include "core/reading/solve/placement_directions.h"
#include "core/reading/types/interpretation.h"
#include "core/tlib/matcher.h"

namespace ew {

/// A box laid over the ink on a solid: which line draws which of its edges.
struct LaidBox {
    std::shared_ptr<const JointGraph> joint;  ///< its corners; none is anchored
    JointReading reading;                     ///< edges that have ink, fitted to it
    GraphMatch match;
    FacePairs pairs;  ///< faces of the box that lie in faces of the solid
    Operation operation = Operation::Cut;
    bool betweenWalls = false;  ///< it fills the way from one wall of the solid to another
    double price = 0.0;         ///< of edges that would be seen and are bare; see RatedCandidate
    double strayPx = 0.0;  ///< length of the lines that no edge explains that would be seen [px]
};

struct BoxLayingOptions {
    Thresholds thresholds;
    double noisePx = 1.0;  ///< how far this hand's lines miss what they are meant to be, > 0
    std::size_t limit = 6;
};

/// Reads the ink on a solid from the whole to its parts: boxes that stand on a face or open in it,
/// along the directions of that face, are compared with all lines at once. Finds what the joint
/// graph misses where ends join wrongly; it needs no line to meet another.
///
/// Where the sides of a box may be is told by the lines along each of the three directions and by
/// the borders of the face; all combinations are rated by how far lines are from the edges that
/// would be seen, and by how much of those has no line.
/// \param entry  a box: convex, rectilinear, eight vertices.
/// \return the best, each different from the others by more than the hand's noise; nothing for more
/// than 80 lines. Cost: some ten thousand combinations a face, O(lines) each.
std::vector<LaidBox> layBoxes(const InkReading& ink, const ModelView& model,
                              const std::shared_ptr<const LibraryEntry>& entry,
                              const BoxLayingOptions& options);

/// Can layBoxes lay this template?
bool isBox(const LibraryEntry& entry);

}  // namespace ew
