// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/solid.
#pragma once

#include <cstdint>
#include <deque>
#include <unordered_map>
#include <vector>

#include "core/solid/exact_geometry.h"

namespace ew {

using Box3 = Eigen::AlignedBox3d;

/// Where a point lies in a solid.
struct Spot {
    enum class Kind { Outside, Inside, Facet, Edge, Vertex };
    Kind kind = Kind::Outside;
    int index = -1;  ///< facet or edge of the operand, vertex of the solid

    bool onSurface() const { return kind != Kind::Outside && kind != Kind::Inside; }
};

/// A polygon in one plane exactly: a face of the solid, or a triangle of a face that is planar
/// within tolerance only.
struct Facet {
    int face = -1;                     ///< of the solid
    const FaceLoops* loops = nullptr;  ///< vertices of the solid
    bool whole = true;                 ///< it is the face, not a triangle of it
    std::shared_ptr<const RPlane> plane;
    int sign = 1;  ///< +1 where the plane's normal points out of the solid
    Box3 box;
};

/// An edge between two facets.
struct OperandEdge {
    std::array<int, 2> ends{-1, -1};    ///< vertices of the solid
    std::array<int, 2> facets{-1, -1};  ///< facets[0] has it as ends[0] -> ends[1]
    bool convex = true;
    Box3 box;
};

/// One of the two solids of a boolean: what of it lies in the other one's box, exactly, and where
/// any point lies in it. Boxes hold their borders.
class Operand {
  public:
    /// \param reach  bounding box of the other solid.
    Operand(const Solid::Impl& solid, const Box3& reach);

    const Solid::Impl& solid() const { return solid_; }
    PointView point(int v) const {
        return {&solid_.surface.point(Mesh::VertexHandle(v)),
                solid_.vertices[static_cast<std::size_t>(v)]};
    }
    const Box3& reach() const { return reach_; }
    /// Facets whose box meets the reach; by face, in order.
    const std::vector<Facet>& facets() const { return facets_; }
    /// Edges of those facets whose box meets the reach.
    const std::vector<OperandEdge>& edges() const { return edges_; }
    /// Index into edges() of the edge between two vertices, -1 where it is out of reach.
    int edgeBetween(int a, int b) const;
    /// Per face of the solid: false where no facet of it is listed.
    bool isNear(int face) const { return near_[static_cast<std::size_t>(face)]; }
    /// Facets round a vertex (listed ones).
    const std::vector<int>& facetsAt(int vertex) const;
    /// The facets that hold a spot in their closure.
    std::vector<int> facetsOf(const Spot& spot) const;

    /// Where on the surface a point within the reach lies; Outside where it is not on it.
    Spot onSurface(const PointView& p) const;
    /// The same with Inside told from Outside.
    Spot locate(const PointView& p) const;
    /// Where in a facet a point of its plane lies; Outside where it is not in it.
    Spot inFacet(int facet, const PointView& p) const;

  private:
    void addFacet(int face, const FaceLoops& loops, bool whole);
    void listEdges();
    bool isInside(const PointView& p) const;

    const Solid::Impl& solid_;
    Box3 reach_;
    std::vector<Box3> faceBoxes_;
    std::vector<bool> near_;
    std::vector<Facet> facets_;
    std::deque<FaceLoops> triangles_;
    std::vector<OperandEdge> edges_;
    std::unordered_map<std::uint64_t, int> edgeAt_;
    std::unordered_map<int, std::vector<int>> facetsAt_;
};

}  // namespace ew
