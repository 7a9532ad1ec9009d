// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/base/camera.h"
#include "core/solid/polyhedron_spec.h"
#include "tests/support/hand_model.h"

namespace ew::test {

/// An edge of a polyhedron with its two faces; `faces[0]` runs ends[0] -> ends[1].
struct SpecEdge {
    std::array<int, 2> ends{-1, -1};
    std::array<int, 2> faces{-1, -1};
};

/// The edges of a closed, oriented polyhedron, in the order in which its faces name them.
std::vector<SpecEdge> specEdges(const PolyhedronSpec& spec);

/// Signed volume of a closed, oriented polyhedron [cubic units]; positive where faces are
/// counter-clockwise from outside.
double specVolume(const PolyhedronSpec& spec);

/// Outward unit normal of a face (Newell's method).
Vec3 specFaceNormal(const PolyhedronSpec& spec, std::size_t face);

/// A visible piece of an edge.
struct VisibleEdge {
    Line2 line;                           ///< [Sketch Plane px]
    int edge = -1;                        ///< index into specEdges()
    std::array<int, 2> vertices{-1, -1};  ///< vertex at either end, -1 where it is a T junction
};

/// A line drawing with hidden lines removed.
struct VisibleDrawing {
    std::vector<VisibleEdge> edges;
    std::vector<int> vertices;     ///< vertices at which a visible edge ends, ascending
    std::vector<Vec2> tJunctions;  ///< ends of edges that run behind something [px]
    std::vector<int> faces;        ///< faces that border a visible edge and face the eye, ascending

    std::vector<Line2> lines() const;
};

/// Hidden-line removal of one polyhedron, convex or not, in general position: no face is seen
/// edge-on, no vertex lies on the projection of an edge that it does not end. Edges are split where
/// their projections cross and the middle of every piece is tested against every face; visible
/// pieces that follow one another are one edge again. O(E^2 F).
VisibleDrawing visibleEdges(const PolyhedronSpec& spec, const OrthographicCamera& camera);

}  // namespace ew::test
