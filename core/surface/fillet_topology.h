// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface.
#pragma once

#include <span>
#include <vector>

#include "core/base/vec.h"
#include "core/solid/solid.h"

namespace ew {

/// One side of an edge: runs along the loop of the face on its left.
struct FilletHalfEdge {
    int origin = -1;
    int face = -1;
    int edge = -1;  ///< of the solid
    int next = -1;  ///< in its loop
    int prev = -1;
    int twin = -1;
    Vec3 dir = Vec3::Zero();     ///< unit
    Vec3 inward = Vec3::Zero();  ///< unit, in the face, across the edge
    double length = 0.0;         ///< [mm]
    double angle = 0.0;          ///< of the face's sector at the origin [rad], 0..2 pi
};

/// The half-edges of a solid's planar faces. The sector of a face at one of its corners goes by the
/// half-edge that leaves the corner: it spans from there, counter-clockwise seen from outside, to
/// the edge of prev.
class FilletTopology {
  public:
    explicit FilletTopology(const Solid& solid);

    const Solid& solid() const { return solid_; }
    int halfCount() const { return static_cast<int>(half_.size()); }
    const FilletHalfEdge& half(int h) const { return half_[static_cast<std::size_t>(h)]; }
    const Vec3& position(int vertex) const {
        return solid_.vertices()[static_cast<std::size_t>(vertex)];
    }
    int target(int h) const { return half(half(h).twin).origin; }
    /// Half-edges that leave a vertex, counter-clockwise seen from outside.
    std::span<const int> ring(int vertex) const {
        const auto v = static_cast<std::size_t>(vertex);
        return {ring_.data() + ringStart_[v], ring_.data() + ringStart_[v + 1]};
    }
    /// The next one in the ring: the other end of the sector of h.
    int ccw(int h) const { return half(half(h).prev).twin; }
    /// The one before in the ring; h is the other end of its sector.
    int cw(int h) const { return half(half(h).twin).next; }
    /// One half-edge of an edge: the one along faces[0].
    int ofEdge(int edge) const { return ofEdge_[static_cast<std::size_t>(edge)]; }
    /// First half-edges of the loops of a face.
    std::span<const int> loops(int face) const {
        const auto f = static_cast<std::size_t>(face);
        return {loops_.data() + loopStart_[f], loops_.data() + loopStart_[f + 1]};
    }

  private:
    void addLoops();
    void link();
    void measure();
    void makeRings();

    Solid solid_;
    std::vector<FilletHalfEdge> half_;
    std::vector<int> loops_;
    std::vector<std::size_t> loopStart_{0};
    std::vector<int> ofEdge_;
    std::vector<int> ring_;
    std::vector<std::size_t> ringStart_{0};
};

/// Cosine of the angle between the two faces of an edge, on the side where a fillet goes.
double foldCosine(const FilletTopology& topology, int edge);

}  // namespace ew
