// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/edge_graph/build.h"
#include "core/reading/extract/model_view.h"
#include "core/stroke/stroke.h"

namespace ew {

/// A straight piece of ink in a frame.
struct BoxLine {
    int axis = -1;                ///< the axis that it runs along, -1 for none
    double offset = 0.0;          ///< across that axis on the screen, from the frame's origin [px]
    double from = 0.0, to = 0.0;  ///< along it, from < to [px]
    double length = 0.0;          ///< [px]
    double modelOff = 0.0;        ///< greatest distance from the nearest edge of the solid [px]
    const Segment* segment = nullptr;
};

/// Three perpendicular directions on a face of a solid, and the ink as it lies to them: axes 0 and
/// 1 lie in the face, axis 2 is its normal. Camera space, right-handed.
struct BoxFrame {
    int face = -1;
    Vec3 origin = Vec3::Zero();    ///< on the face [px]
    std::array<Vec3, 3> axis;      ///< unit
    std::array<Vec2, 3> screen;    ///< their directions on the screen, unit
    std::array<double, 3> seen{};  ///< px on the screen for a px along an axis, > 0
    std::array<std::array<double, 2>, 2> border{};  ///< of the face, along axes 0 and 1
    double sizePx = 1.0;                            ///< of the solid
    std::vector<BoxLine> lines;
    std::vector<std::array<Vec2, 2>> modelLines;  ///< edges of the solid that are seen near the ink

    /// How far going one px along `other` goes across `axis` on the screen, and along it.
    double across(std::size_t axis, std::size_t other) const;
    double along(std::size_t axis, std::size_t other) const;
    /// Unit vector on the screen across an axis: that in which BoxLine::offset grows.
    Vec2 acrossOf(std::size_t axis) const;
    /// Distance of a point near the ink from the nearest edge of the solid that is seen [px].
    double modelDistance(const Vec2& p) const;
    /// Where on the edge from a to b these lines begin and end.
    std::array<Vec2, 2> inked(const std::vector<std::size_t>& lines, const Vec2& a,
                              const Vec2& b) const;
    /// The edge from a to b, fitted to these lines.
    GraphEdge fitted(const std::vector<std::size_t>& lines, const Vec2& a, const Vec2& b) const;
};

/// Frames of the faces that ink lies on, by the directions of their edges; those with the most ink
/// first. Without faces whose normal or sides are seen next to end-on.
std::vector<BoxFrame> boxFrames(const InkReading& ink, const ModelView& model,
                                const Thresholds& thresholds, double noisePx);

}  // namespace ew
