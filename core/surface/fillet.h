// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/solid/solid.h"
#include "core/surface/poly_mesh.h"

namespace ew {

inline constexpr int kMaxFilletSegments = 16;

/// One edge to be filleted.
struct FilletChoice {
    int edge = -1;         ///< index into Solid::edges()
    double setback = 1.0;  ///< distance, in each of the two faces, from the edge to where the strip
                           ///< begins [mm], > 0. On a right-angled edge it is the radius of the
                           ///< rolling ball; setbackForRadius() converts for others
};

struct FilletOptions {
    std::vector<FilletChoice> edges;  ///< each edge at most once, at least one
    int segments = 1;                 ///< flat pieces across a strip, 1..kMaxFilletSegments; 1 is a
                                      ///< chamfer, more follow the arc that touches both faces
};

/// What a face of a filleted cage comes from.
struct CageOrigin {
    enum class Kind { Face, Strip, Corner };
    Kind kind = Kind::Face;
    int index = -1;  ///< face, edge or vertex of the solid
    bool operator==(const CageOrigin&) const = default;
};

/// An edge whose setback did not fit.
struct FilletClamp {
    int edge = -1;
    double requested = 0.0;   ///< [mm]
    double used = 0.0;        ///< [mm], 0 where the edge had to stay sharp
    int limitingEdge = -1;    ///< the edge that left no more room, -1 where it is no edge
    int limitingVertex = -1;  ///< the corner that left no more room, -1 where it is none
};

/// What is left of an edge of the solid that was not filleted.
struct CageSharpEdge {
    int from = -1;  ///< points of the mesh
    int to = -1;
    int edge = -1;  ///< of the solid
};

/// The polyhedron after the fillet operation: closed, 2-manifold, oriented, free of
/// self-intersection.
struct FilletedCage {
    PolyMesh mesh;                          ///< body frame [mm]
    std::vector<CageOrigin> origins;        ///< by face of the mesh
    std::vector<CageSharpEdge> sharpEdges;  ///< in the order of the edges
    std::vector<CageSharpEdge> sharpEnds;   ///< edges of the mesh, at the ends of strips, along
                                            ///< which a sharp edge goes on; `edge` names that one
    std::vector<int> vertexPoints;  ///< by vertex of the solid: its point, -1 where it is cut away
    std::vector<double> setbacks;   ///< by edge of the solid [mm], 0 where it is sharp
    std::vector<FilletClamp> clamped;  ///< in the order of the edges; empty where all fit
};

/// The fillet operation (contract in docs/algorithms.md). Every chosen edge becomes
/// a strip of `segments` flat quadrangles whose sides lie in its two faces, parallel to the edge at
/// the setback; where chosen edges meet, the corner becomes one flat face or a patch of faces, and
/// where a strip ends among unchosen edges, it runs into the face that it meets or ends in a flat
/// face. With more than one segment, two strips go round the end of a third one that is of the
/// other kind (convex, concave) or has the largest setback, and the face between them is rounded.
/// Unchosen edges stay on their lines and planar faces in their planes.
///
/// Setbacks that do not fit are clamped edge by edge, in the manner of water filling: all grow from
/// zero at one rate, and an edge stops where it would use up an edge or run into another one of the
/// same face, while the others go on. Where something else is in the way (a wall that the strip
/// would run into), the edges concerned are made smaller until the result passes the check.
/// tol::kFilletRest of the room is always left.
///
/// The mesh is a function of the solid and the options; no edge chosen twice.
/// Errors: NoEdge where none is chosen; BadValue for an edge that does not exist or is chosen
/// twice, a setback that is not finite or not positive, segments out of range.
/// O(n log n) in the number of faces made, the final check included.
/// \paper{6.2}
Result<FilletedCage> fillet(const Solid& solid, const FilletOptions& options);

/// The solid's own surface as a cage: what fillet() would make of no edge at all.
FilletedCage sharpCage(const Solid& solid);

/// Setback at which the strip of an edge is an arc of this radius, and back. [mm]
/// \pre edge exists.
double setbackForRadius(const Solid& solid, int edge, double radius);
double radiusForSetback(const Solid& solid, int edge, double setback);

}  // namespace ew
