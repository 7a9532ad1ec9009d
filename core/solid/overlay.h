// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/solid.
#pragma once

#include <unordered_set>
#include <vector>

#include "core/solid/boolean.h"
#include "core/solid/operand.h"

namespace ew {

/// A side of a result's face: it runs from -> to with the face on its left, seen from outside.
struct FaceSide {
    int from = -1;  ///< point of the overlay
    int to = -1;
    FaceOrigin origin;
};

/// The sides of the result's faces in one plane with one sense (or in one face that is planar
/// within tolerance only).
struct SideGroup {
    std::shared_ptr<const RPlane> plane;
    int sign = 1;       ///< -1: the faces look against the plane's normal
    bool exact = true;  ///< all sides lie in the plane
    std::vector<FaceSide> sides;
};

/// The surface of the result near where the two solids can meet.
struct Overlay {
    std::vector<SideGroup> groups;
    std::vector<bool> targetReplaced;  ///< by face: what is left of it is in the groups
    std::vector<bool> toolReplaced;
    /// Points in which both surfaces meet and that may lie in the middle of a face of the result.
    std::vector<int> contacts;
    std::unordered_set<int> touched;   ///< points whose edges all are among the sides
    std::unordered_set<int> complete;  ///< ... and whose faces are, too
    int firstTool = 0;  ///< points are those of the target, of the tool (from here), and new ones
    int firstNew = 0;
    std::vector<OwnPoint> fresh;
    bool touchesInEdge = false;  ///< more than two faces of the result meet in an edge

    PointView point(int i, const Operand& target, const Operand& tool) const {
        if (i < firstTool) return target.point(i);
        if (i < firstNew) return tool.point(i - firstTool);
        return fresh[static_cast<std::size_t>(i - firstNew)].view();
    }
};

/// Computes the boolean in every plane by itself. Every line in which the two surfaces can meet is
/// cut into pieces between the points in which they do; a piece is a side of a face of the result
/// where the plane belongs to the result's surface on one side of it and not on the other. Whether
/// it does follows from the four wedges round the piece (two sides, above and below), so coplanar,
/// touching and identical parts need no case of their own.
Overlay overlay(const Operand& target, const Operand& tool, BooleanKind kind);

}  // namespace ew
