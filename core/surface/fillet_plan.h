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
        Arc,    ///< both filleted: the strips end square to their edges, where the strips on their
                ///< other sides begin, and the face is rounded between them
    };
    Kind kind = Kind::Bare;
    bool keepsCorner = false;  ///< the solid's corner stays a corner of the face
    double firstOwn = 0.0;     ///< position along h = firstOwn * s(h) + firstOther * s(g)
    double firstOther = 0.0;   ///< in an arc of the edge before h, as firstBeside() says
    double lastOwn = 0.0;      ///< position along g = lastOwn * s(g) + lastOther * s(h)
    double lastOther = 0.0;
};

/// Where the sides of two filleted edges of a face meet, by the angle between the edges: position
/// along either one = own * its setback + other * that of the other one.
struct MiterWeights {
    double own = 0.0;
    double other = 0.0;
};
MiterWeights miterWeights(double angle);

/// Whether two strips go round the end of a third one at the sector between them, as on a bent
/// tube, with these setbacks: where they lie in a reflex corner of the face and where, at a corner
/// of three edges that are all convex or all concave, the third one's setback is the largest.
/// \param setbacks  by edge, > 0 where filleted.
bool goesRound(const FilletTopology& topology, int h, const std::vector<double>& setbacks);

/// The combinatorial half of the fillet: which edges are filleted and what every sector becomes.
class FilletPlan {
  public:
    /// \param filleted  by edge of the solid.
    /// \param styles    by vertex.
    /// \param taper     by vertex, setbacks between a strip's end and the corner where tapered.
    /// \param arcs      by half-edge, whether its sector may be an arc.
    FilletPlan(const FilletTopology& topology, std::vector<bool> filleted,
               std::vector<CornerStyle> styles, std::vector<double> taper,
               const std::vector<bool>& arcs);

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

    /// Half-edges whose setbacks the other weights of a sector are for.
    int firstBeside(int h) const {
        return sector(h).kind == FilletSector::Kind::Arc ? topology_.cw(h) : topology_.ccw(h);
    }
    int lastBeside(int h) const {
        const bool arc = sector(h).kind == FilletSector::Kind::Arc;
        return arc ? topology_.ccw(topology_.ccw(h)) : h;
    }

    /// Where the strip or the sharp rest of h begins, on the face of h: along h, as position().
    double start(int h, const std::vector<double>& setbacks) const;
    /// The same on the other face of the edge.
    double startAcross(int h, const std::vector<double>& setbacks) const;

  private:
    void planSector(int h);
    void planVertex(int vertex);
    void planArcs(int vertex, const std::vector<bool>& arcs);
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
