// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/reading/evidence/sighting.h"

namespace ew {

/// The drawing of a rectilinear template as an affine picture: vertex v is seen at
/// origin + sum over the axes of position[axis][plane of v] * axes[axis].
struct AffinePicture {
    Vec2 origin = Vec2::Zero();  ///< [px]
    std::array<Vec2, 3> axes;    ///< drawn axis vectors q_i [px]
    std::array<std::vector<double>, 3>
        position;  ///< per axis and plane, in units of the axis vector
    std::array<double, 3> angleSpread{0, 0,
                                      0};  ///< standard deviation of each axis' direction [rad]
    int unseenPlanes = 0;                  ///< planes placed after the reference shape

    Vec2 at(const RectilinearStructure& r, std::size_t vertex) const;
};

/// The picture of every vertex; no depths.
CameraPoints picturePoints(const AffinePicture& picture, const RectilinearStructure& r);

/// Fits the whole drawing first: least squares over all drawn line ends at once, each precise
/// across its line and loose along it.
/// \return nothing where the drawing does not determine the three axes.
std::optional<AffinePicture> fitAffine(const Sighting& sighting, const TemplateAnalysis& analysis);

/// Depths of three mutually perpendicular axes from their picture, the paper's equations (1) to
/// (13) in camera space: with D_jk = q_j . q_k, |t_i| = sqrt(-D12 D23 D31) / |D_jk| and t_i t_j =
/// -D_ij. The other Necker root is the negative of all three.
/// \return nothing where there is no real root (Perkins' law is broken).
/// \paper{5.1}
std::optional<std::array<double, 3>> cornerDepths(const std::array<Vec2, 3>& axes);

/// Which of the three angles is nearest to 90 degrees, and how far from it the drawing may say it
/// is.
struct CriticalAngle {
    int axis = 0;            ///< the axis opposite: the angle is between the other two
    double offDeg = 0.0;     ///< distance of the angle from 90 degrees, >= 0
    double spreadDeg = 0.0;  ///< standard deviation of that angle
};
CriticalAngle criticalAngle(const AffinePicture& picture);

/// The nearest picture that has a solution: the critical angle is turned to the other side of 90
/// degrees by `marginDeg`, the shorter of its two axes turning more. `movedPx` receives how far ink
/// moves.
AffinePicture snapToSolvable(const AffinePicture& picture, double marginDeg, double& movedPx);

/// Vertices in camera space for axis depths t.
CameraPoints liftPicture(const AffinePicture& picture, const RectilinearStructure& r,
                         const std::array<double, 3>& depths);

/// The oblique reading: the two axes of the critical angle are taken as perpendicular and parallel
/// to the Sketch Plane, the third as pointing straight away with depth = factor times its drawn
/// length. `movedPx` receives how far ink moves to make the front face true.
struct ObliqueBody {
    std::array<Vec3, 3> axes;  ///< camera space [px], mutually perpendicular
    int depthAxis = 0;
};
ObliqueBody obliqueAxes(const AffinePicture& picture, double factor, double& movedPx);

}  // namespace ew
