// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/reading/extract/axis_frames.h"
#include "core/reading/extract/line_drawing.h"

namespace ew {

/// A plane of a drawing's space: normal . p = offset, p in camera space [px] (x right, y down, z
/// away from the eye).
struct DrawnPlane {
    Vec3 normal = Vec3::Zero();  ///< unit; z < 0 where it is a face that is seen
    double offset = 0.0;         ///< [px]

    /// Depth where a ray through a point of the picture meets it.
    double depthAt(const Vec2& p) const { return (offset - normal.head<2>().dot(p)) / normal.z(); }
};

/// What a line of a drawing is, if its faces are where they were found.
struct LiftedLine {
    int front = -1;       ///< region whose face has the edge; the nearer one of two
    bool shared = false;  ///< the faces to both sides meet in it
};

/// The faces that a drawing shows as planes in space. Parts that only hide one another, and are
/// joined by no edge that is seen, have depths of their own.
struct FaceLift {
    std::vector<DrawnPlane> faces;  ///< per region
    std::vector<int> axis;          ///< per region: axis that it is across, -1 for a slanted face
    std::vector<int> part;          ///< per region: faces joined by edges have one number, 0..
    int parts = 0;
    std::vector<LiftedLine> lines;  ///< per edge of the graph
    double worstPx = 0.0;  ///< farthest that the edge of two faces is from the line it was drawn as
};

/// Finds planes of the regions: those with lines along two axes are across the third, all others by
/// their lines and neighbours. Every line between two regions counts as an edge of both unless it
/// is the bar of a T junction or that contradicts most others: absolute deviations are made least.
/// O(iterations * regions^3).
/// \param spreadPx  standard deviation of a corner, per axis.
/// \return the planes as told, and, where two groups of faces hang together at one place only, the
///         same with the lower group before the other one there; none where some plane is not told.
std::vector<FaceLift> liftFaces(const LineDrawing& drawing, const AxisFrame& frame,
                                double spreadPx);

}  // namespace ew
