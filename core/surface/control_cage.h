// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "core/base/result.h"
#include "core/surface/fillet.h"

namespace ew {

enum class SubdivisionScheme { CatmullClark, Loop };

/// Sharpness from here on is infinite, as in OpenSubdiv: the surface keeps the edge for ever.
inline constexpr double kInfiniteSharpness = 10.0;

struct CreaseEdge {
    int from = -1;
    int to = -1;
    double sharpness = 0.0;
};
struct SharpPoint {
    int point = -1;
    double sharpness = 0.0;
};

/// What subdivision starts from: polygons without holes, closed, and how sharp their edges and
/// corners are to stay.
struct ControlCage {
    PolyMesh mesh;
    std::vector<int> origin;          ///< by face: the face of the filleted cage that it is part of
    std::vector<CreaseEdge> creases;  ///< edges of the mesh; what is not listed is smooth
    std::vector<SharpPoint> corners;  ///< points of the mesh
};

struct ControlOptions {
    SubdivisionScheme scheme = SubdivisionScheme::CatmullClark;
    std::vector<double> edgeSharpness;  ///< by edge of the solid, for what is left of edges that
                                        ///< were not filleted: 0 smooth .. kInfiniteSharpness;
                                        ///< empty: all of them infinitely sharp
    bool sharpCorners = false;          ///< what is left of the solid's corners stays where it is
    double supportRatio = 0.25;  ///< 0, or up to 1: distance of the support loop inside planar
                                 ///< faces from their strips, in setbacks of the narrowest strip
                                 ///< there. The surface is flat inside the loop; 0: no loops
};

/// Makes the control cage: planar faces beside strips get two support loops, and rows across the
/// strips near their ends keep the corners of the loops in place; faces with holes and faces that
/// are not convex are split into convex quadrangles and triangles; for Loop all is triangles.
/// Errors: BadValue for sharpness or ratio out of range (NaN included) or a list of the wrong
/// length.
/// \paper{6.1}
Result<ControlCage> controlCage(const FilletedCage& cage, const ControlOptions& options);

}  // namespace ew
