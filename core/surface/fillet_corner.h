// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/surface/fillet.h"

namespace ew {

/// A run of boundary points of a corner's hole.
struct HoleSide {
    enum class Kind { Straight, Strip, Arc };
    std::span<const int> ids;
    int half = -1;  ///< the filleted half-edge whose strip ends here, the one whose sector has the
                    ///< arc, -1 for a straight side
    Kind kind = Kind::Straight;
};

/// A run of edges of the mesh along which a sharp edge of the solid goes on.
void addSharpEnd(FilletedCage& cage, std::span<const int> run, int edge);

/// Flat faces from the solid's corner to every strip end.
/// \param apex   point of the corner.
/// \param sharp  an edge at the corner that stays sharp, -1 where there is none.
void addFans(FilletedCage& cage, int apex, std::vector<HoleSide> sides, int sharp);

/// Faces between two strip ends, rung by rung. Where the ends are one, a miter goes on along the
/// sharp edge.
void addBridge(FilletedCage& cage, std::span<const HoleSide> sides, int sharp);

/// One face where the hole is flat, else triangles around its middle.
void addPolygon(PolyMesh& mesh, std::span<const HoleSide> sides);

/// How a face goes round one of its corners, from the side of one filleted edge to that of the
/// next: an arc in the face's plane that touches both sides, of a circle where it begins and ends
/// equally far away.
struct FaceArc {
    Vec3 corner = Vec3::Zero();
    std::array<Vec3, 2> along;    ///< unit, of the two edges, away from the corner
    std::array<Vec3, 2> inward;   ///< unit, in the face, across the edges
    std::array<double, 2> start;  ///< along each edge where its strip ends [mm]
    std::array<double, 2> setback;
    double angle = 0.0;  ///< of the face between the edges [rad]

    /// \param t  0 at the first edge's side, 1 at the second one's.
    Vec3 at(double t) const;
};

/// A corner where two strips go round the end of a third one.
struct SweptCorner {
    Vec3 corner = Vec3::Zero();
    std::array<Vec3, 2> starts;  ///< on the two edges, where the strips end, from the corner [mm]
    std::span<const int> first;  ///< the sides of the hole, one after the other: the first strip's
    std::span<const int> arc;    ///< the face's
    std::span<const int> last;   ///< the second strip's
    std::span<const int> third;  ///< that of the strip between them
};

/// A grid of quadrangles: the profile of the strips is moved along the arc in which the third
/// strip's surface meets the face's plane. A part of a torus where all is at right angles and of
/// one setback.
/// \pre starts are ahead of the corner.
void addSweptPatch(PolyMesh& mesh, const SweptCorner& corner);

}  // namespace ew
