// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/base/result.h"
#include "core/solid/solid.h"

namespace ew {

/// What a face of a tool has in common with the solid that the tool is made for, exactly. Several
/// rules may speak of one face. Indices are those of the target's edges(), faces(), vertices().
struct ToolFaceRule {
    enum class Kind {
        InFace,          ///< lies in the plane of the target's face `index`
        ParallelToFace,  ///< parallel to it
        NormalToEdge,    ///< perpendicular to the target's edge `index`
        AlongEdge,       ///< parallel to the target's edge `index`
        AlongNormal,     ///< perpendicular to the target's face `index`
        ThroughVertex,   ///< its plane goes through the target's vertex `index`
    };
    int face = -1;  ///< of ToolSpec::shape
    Kind kind = Kind::InFace;
    int index = -1;
};

/// Where a vertex of a tool lies on the target, exactly.
struct ToolVertexRule {
    enum class Kind {
        AtVertex,         ///< is the target's vertex `index`
        OnEdge,           ///< on the line of the target's edge `index`
        OnFace,           ///< on the plane of the target's face `index`
        BetweenVertices,  ///< is vertex `index` + t * (vertex `other` - vertex `index`)
    };
    int vertex = -1;  ///< of ToolSpec::shape
    Kind kind = Kind::AtVertex;
    int index = -1;
    int other = -1;
    double t = 0.0;  ///< any finite number: a corner may lie beyond the two
};

/// An edge of the tool that runs exactly in a direction of the target, in which both its faces then
/// lie.
struct ToolEdgeRule {
    enum class Kind {
        AlongEdge,    ///< parallel to the target's edge `index`
        AlongNormal,  ///< perpendicular to the target's face `index`
        AcrossEdge,   ///< perpendicular to the target's edge `index`, in its face `other`
    };
    std::array<int, 2> ends{-1, -1};  ///< vertices of ToolSpec::shape
    Kind kind = Kind::AlongNormal;
    int index = -1;
    int other = -1;
};

/// A body to add to a solid or to cut out of it: its shape in doubles, in the target's frame, and
/// what of it is exact. What no rule speaks of stays where the doubles say, up to a rounding.
struct ToolSpec {
    PolyhedronSpec shape;
    std::vector<ToolFaceRule> faces;
    std::vector<ToolVertexRule> vertices;
    std::vector<ToolEdgeRule> edges;
    /// Adds rules for what the doubles show within tol::kThinnestRelative of the size, as far as
    /// they do not contradict the others: faces in a plane of the target or parallel to one (sine
    /// up to tol::kToolSnap), corners on its corners.
    bool snap = false;
};

/// Makes the tool's exact solid. Faces come out planar exactly and obey their rules exactly; faces
/// of the shape that are parallel or in one plane (within 1e-9) stay so, and of faces along one
/// direction those that are perpendicular do.
///
/// Points and planes are fixed one after the other, each bound by what was fixed before, as in
/// Solid::fromSpec; a box or prism, whose corners have three faces, always works, a pyramid takes
/// its apex as it is. Faces and vertices keep their order.
/// Errors: BadValue for an index that does not exist, Contradiction (the message names the face or
/// corner) where no shape within tol::kToolMove obeys all rules, and those of Solid::fromSpec.
/// \paper{5.2.2}
Result<Solid> makeTool(const Solid& target, const ToolSpec& spec);

}  // namespace ew
