// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/reading/solve/rectilinear_fit.h"

namespace ew {

/// A rectilinear template as a camera at a finite distance saw it. A point X of camera space [px],
/// relative to the principal point, is seen at X.head<2>() / (1 + kappa * X.z() / kPerspectivePx).
struct PerspectivePicture {
    AffinePicture parallel;    ///< what a parallel projection along the same view shows [px]
    std::array<Vec3, 3> axes;  ///< camera space vectors of the three axes [px], perpendicular
    Vec2 principal;            ///< principal point: the middle of the drawing [px]
    double kappa = 0.0;        ///< strength, >= 0; 2 tan(half the view angle of kPerspectivePx)

    /// Where a vertex is seen, with its depth [px].
    Vec3 at(const RectilinearStructure& r, std::size_t vertex) const;
};

/// Width of the picture that kappa refers to [px].
inline constexpr double kPerspectivePx = 600.0;

/// Fits a perspective view of a rectilinear template to all drawn line ends at once: attitude,
/// lengths, plane positions, origin and strength, by Levenberg and Marquardt's method.
/// \param start  a parallel picture of the same drawing.
/// \param depths depths of its axes, e.g. of cornerDepths: which of the two Necker roots to follow.
/// \return nothing where it does not converge or the lines converge towards the eye. Cost: about
///         30 evaluations of all line ends for each of its ten or so parameters.
std::optional<PerspectivePicture> fitPerspective(const Sighting& sighting,
                                                 const TemplateAnalysis& analysis,
                                                 const AffinePicture& start,
                                                 const std::array<double, 3>& depths);

}  // namespace ew
