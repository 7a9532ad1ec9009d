// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/solid/solid.h"

namespace ew {

/// What is made of a target and a tool: their union, the target without the tool, their common
/// part.
enum class BooleanKind { Add, Cut, Intersect };

/// Where a face comes from.
struct FaceOrigin {
    bool fromTool = false;
    int face = -1;  ///< of the target or of the tool
    bool operator==(const FaceOrigin&) const = default;
};

/// What happened, for the person and for what is attached to faces and edges.
struct BooleanReport {
    int shells = 0;        ///< of the result
    int genus = 0;         ///< of the result
    int shellsBefore = 0;  ///< of the target
    /// Per face of the result. A face that several faces were merged into names the first one of
    /// the target (or, without any, of the tool); a face that was split is named by every part.
    std::vector<FaceOrigin> faceOrigin;
    /// Per face of the result: the target's face has the very same outline.
    std::vector<bool> faceUnchanged;
};

struct BooleanOutcome {
    Solid solid;
    BooleanReport report;
};

/// Exact boolean of two solids in one frame. Coplanar neighbours are one face in the result, no
/// vertex lies on a straight edge; a face with holes is one face. The result passed the validity
/// check of docs/design.md. The same input gives the same result, bit by bit.
///
/// Vertices and faces of the target that are left come first, in their order, then those of the
/// tool and new ones.
///
/// Several shells are allowed: an Add of a separate body, a Cut that severs (see the report).
/// Errors: NoChange (the result would be the target), NothingLeft, TouchesInEdge and TouchesInPoint
/// (the result would touch itself there only), Sliver (the result would all but touch itself: a
/// wall, gap or step thinner than tol::kThinnestRelative of its size that the target did not have;
/// or the tool misses something by a rounding error, tol::kSliverRelative), TooLarge for
/// coordinates longer than tol::kMaxExactBits. Cost: O(faces) plus the work where the two boxes
/// overlap.
/// \paper{5.2.2}
Result<BooleanOutcome> combine(const Solid& target, const Solid& tool, BooleanKind kind);

}  // namespace ew
