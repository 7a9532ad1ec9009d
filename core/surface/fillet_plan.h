// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface.
#pragma once

#include <vector>

#include "core/surface/fillet_topology.h"

namespace ew {

/// How far a corner falls back where the finer construction would not be embedded.
enum class CornerStyle {
    Patch,  ///< strips meet each other, the corner is rounded
    Apex,   ///< strips end at the same places, the faces between them run to the solid's corner
    Taper,  ///< every strip ends by itself some setbacks away and runs to the solid's corner
};

/// What becomes of the sector of one face at one corner. Where the sector's first edge (h) and its
/// second one (g, the next counter-clockwise) are cut back, the positions are linear in their
/// setbacks; 0 is the setback of an edge that stays sharp.
struct FilletSector {
    enum class Kind {
        Bare,   ///< both edges sharp
        Miter,  ///< both filleted, their sides meet in one point
        Step,   ///< both filleted and nearly in one line: two points on the bisector
        Cut,    ///< one filleted, its side meets the line of the sharp one
        End,    ///< each side ends by itself, the solid's corner lies between
    };
    Kind kind = Kind::Bare;
    bool keepsCorner = false;  ///< the solid's corner stays a corner of the face
    double firstOwn = 0.0;     ///< position along h = firstOwn * s(h) + firstOther * s(g)
    double firstOther = 0.0;
    double lastOwn = 0.0;  ///< position along g = lastOwn * s(g) + lastOther * s(h)
    double lastOther = 0.0;
};

/// The combinatorial half of the fillet: which edges are filleted and what every sector becomes.
class FilletPlan {
  public:
    /// \param filleted  by edge of the solid.
    /// \param styles    by vertex.
    /// \param taper     by vertex, setbacks between a strip's end and the corner where tapered.
    FilletPlan(const FilletTopology& topology, std::vector<bool> filleted,
               std::vector<CornerStyle> styles, std::vector<double> taper);

    const FilletTopology& topology() const { return topology_; }
    bool filleted(int h) const {
        return filleted_[static_cast<std::size_t>(topology_.half(h).edge)];
    }
    const FilletSector& sector(int h) const { return sectors_[static_cast<std::size_t>(h)]; }
    int filletedAt(int vertex) const { return count_[static_cast<std::size_t>(vertex)]; }
    /// One filleted edge among two sharp ones, whose strip ends in the face between these.
    bool isCap(int vertex) const { return cap_[static_cast<std::size_t>(vertex)]; }
    bool keepsCorner(int vertex) const { return kept_[static_cast<std::size_t>(vertex)]; }
    CornerStyle style(int vertex) const { return styles_[static_cast<std::size_t>(vertex)]; }

    /// Where the strip or the sharp rest of h begins, on the face of h: along h, as position().
    double start(int h, const std::vector<double>& setbacks) const;
    /// The same on the other face of the edge.
    double startAcross(int h, const std::vector<double>& setbacks) const;

  private:
    void planSector(int h);
    void planVertex(int vertex);
    double setback(int h, const std::vector<double>& setbacks) const {
        return setbacks[static_cast<std::size_t>(topology_.half(h).edge)];
    }

    const FilletTopology& topology_;
    std::vector<bool> filleted_;
    std::vector<CornerStyle> styles_;
    std::vector<double> taper_;
    std::vector<FilletSector> sectors_;
    std::vector<int> count_;
    std::vector<bool> cap_;
    std::vector<bool> kept_;
};

}  // namespace ew
