// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/base/camera.h"
#include "core/base/result.h"
#include "core/stroke/stroke.h"

namespace ew {

/// A point of a curve on triangles.
struct MappedPoint {
    Vec3 position = Vec3::Zero();  ///< [mm]
    Vec3 normal = Vec3::Zero();    ///< unit, of the triangle, towards the eye of the stroke
    int triangle = -1;
    Vec3 barycentric = Vec3::Zero();  ///< of the triangle's corners, sum 1
    double pressure = 1.0;            ///< 0..1, for the width
};

/// A piece of a stroke that lies on the surface without a gap. Consecutive points lie on one
/// triangle (or, where the stroke goes through a corner, on two that meet there, a sixty-fourth of
/// a pixel apart), so the straight lines between them follow the surface.
struct MappedCurve {
    int stroke = -1;                  ///< index of the stroke that it is a piece of
    std::vector<MappedPoint> points;  ///< one for a dot, else two or more
};

struct MappedStrokes {
    std::vector<MappedCurve> curves;  ///< in the order of the strokes and along each
    std::vector<int> missed;          ///< strokes with no surface under any part of them
};

/// Triangles made ready for many strokes through one camera: projected, and sorted by place. Keep
/// it while the camera and the triangles stay as they are. O(n log n) to make.
/// \paper{7.1}
class StrokeCanvas {
  public:
    /// Errors: those of OrthographicCamera::validate; BadValue for positions that are not finite or
    /// indices out of range.
    static Result<StrokeCanvas> create(std::span<const Vec3> positions,
                                       std::span<const std::array<int, 3>> triangles,
                                       const OrthographicCamera& camera);

    /// Projects strokes along the view onto what is seen of the surface. Curves follow the surface:
    /// they have a point wherever the stroke crosses an edge of a triangle, and end at silhouettes
    /// and where another part of the surface comes in front; what follows is another curve.
    /// \param strokes  Sketch Plane px of the camera.
    /// Errors: those of validateStroke; EmptySketch without strokes; NoSurface where no stroke has
    /// any surface under it. O(crossed triangles + length in px, times log n).
    Result<MappedStrokes> map(const std::vector<Stroke>& strokes) const;

    struct Impl;

  private:
    explicit StrokeCanvas(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
    std::shared_ptr<const Impl> impl_;
};

}  // namespace ew
