// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/base/vec.h"

namespace ew {

/// A graph drawn with straight edges in the plane, as the matcher sees it: Edge Graphs and aspects
/// alike.
struct PlaneGraph {
    std::vector<Vec2> points;  ///< per vertex [px], y down
    std::vector<std::array<int, 2>> edges;
};

/// The rotation system of a plane graph. Directed edge 2e runs edges[e][0] -> edges[e][1], 2e+1
/// back.
struct RotationSystem {
    std::vector<int> origin;  ///< per directed edge: its first vertex
    std::vector<int>
        next;  ///< per directed edge: the next one around its origin, clockwise on the screen
    std::vector<int> prev;    ///< ... and counter-clockwise
    std::vector<int> degree;  ///< per vertex

    static int twin(int d) { return d ^ 1; }
    int target(int d) const { return origin[static_cast<std::size_t>(d ^ 1)]; }
    int directedCount() const { return static_cast<int>(origin.size()); }
};

RotationSystem rotationOf(const PlaneGraph& graph);

/// Faces of a plane graph as loops of directed edges, each with its signed area (positive where the
/// loop runs clockwise on the screen). The outer face has the other sign than the bounded ones.
struct PlaneFace {
    std::vector<int> loop;  ///< directed edges
    double area = 0.0;      ///< [px^2], signed
};
std::vector<PlaneFace> facesOf(const PlaneGraph& graph, const RotationSystem& rotation);

/// Which vertices lie on the outer face of a connected plane graph.
std::vector<bool> outerVertices(const PlaneGraph& graph);

}  // namespace ew
