// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/reading/types/interpretation.h"
#include "core/stroke/stroke.h"

namespace ew {

/// A closed outline that was drawn on a face: it says where something is to come out of the solid
/// or go into it, and leaves open how far.
struct Profile {
    int body = -1;
    int face = -1;
    std::vector<Vec3> corners;  ///< body frame, in the plane of the face but for rounding,
                                ///< counter-clockwise from outside [mm]
    bool round = false;         ///< a circle, as a regular polygon of kRoundSides
    std::vector<int> strokes;   ///< indices of those it was drawn by
};

/// Sides that stand for a circle.
inline constexpr int kRoundSides = 48;

/// The outline round a point of a face. Its edges take the directions of the face's edges, square
/// to them or parallel, where they are meant to (Thresholds::angleDeg), and lie on an edge of the
/// face where they run along it; a closed curve is the circle in the plane of the face that it is
/// the picture of.
/// Errors: NoSurface (no face is seen there), NoRegion (no outline runs round the point),
/// OperationImpossible (it leaves the face), CurvedStroke (a closed curve that is no circle on the
/// face).
/// \param inside  the point [px of the strokes' Sketch Plane].
/// \pre the strokes pass validateStroke().
Result<Profile> readProfile(const std::vector<Stroke>& strokes, const InterpretOptions& options,
                            const Vec2& inside);

}  // namespace ew
