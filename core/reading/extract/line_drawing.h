// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/edge_graph/edge_graph.h"
#include "core/edge_graph/faces.h"

namespace ew {

/// An Edge Graph as a drawing of faces: hidden lines are removed, so its regions are what
/// is seen of faces, and where a line ends on another one that goes straight on something is in
/// front of it. Directed edge 2e runs edges[e].ends[0] -> ends[1] of the graph, 2e + 1 back.
struct LineDrawing {
    struct Node {
        Vec2 at = Vec2::Zero();  ///< [px]
        std::vector<int> out;    ///< directed edges that leave, clockwise on the screen
        int stem = -1;           ///< T junction: the directed edge that leaves from the bar
    };
    struct Region {
        std::vector<int> loop;  ///< directed edges; the region is to one side of all of them
        std::vector<std::vector<int>> holes;  ///< outlines of parts that lie within it
        std::vector<int> corners;  ///< nodes of the loop at which its outline turns, in order
        double areaPx = 0.0;       ///< >= 0 [px^2]
        bool partly = false;       ///< some corner is a T junction whose stem is a line of it, so
                                   ///< that something hides a part of the face
    };

    std::vector<Node> nodes;      ///< as the graph's junctions
    std::vector<int> from;        ///< per directed edge: node
    std::vector<int> left;        ///< per directed edge: region whose loop it is on, -1 outside
    std::vector<Region> regions;  ///< bounded ones
    std::vector<int> outline;     ///< the outer loop of the widest connected part, directed edges

    static int twin(int d) { return d ^ 1; }
    int to(int d) const { return from[static_cast<std::size_t>(d ^ 1)]; }
    Vec2 vector(int d) const {
        return nodes[static_cast<std::size_t>(to(d))].at -
               nodes[static_cast<std::size_t>(from[static_cast<std::size_t>(d)])].at;
    }
    bool isT(int node) const { return nodes[static_cast<std::size_t>(node)].stem >= 0; }
    /// Least and greatest coordinates of the nodes, of which there is one [px].
    std::array<Vec2, 2> bounds() const;
    /// The corners of a loop [px].
    std::vector<Vec2> polygon(const std::vector<int>& loop) const;
    /// Does the line go straight on through this node, from one directed edge's end to the other?
    bool straightThrough(int in, int out) const;

    double straightDeg = 8.0;  ///< a turn of less is none
};

/// \param straightDeg  two lines of a junction that turn by less are one line [degrees].
LineDrawing lineDrawing(const EdgeGraph& graph, double straightDeg);

}  // namespace ew
