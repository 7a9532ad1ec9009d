// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "core/edge_graph/build.h"
#include "core/edge_graph/faces.h"
#include "core/reading/extract/model_view.h"

namespace ew {

/// A vertex of the joint graph of strokes and model.
struct JointNode {
    Vec2 px = Vec2::Zero();
    int modelVertex = -1;  ///< of the solid, where it is one
    int modelEdge = -1;    ///< of the solid, where it lies on one
    bool ink = false;      ///< a stroke ends or turns here
};

/// An edge of the joint graph.
struct JointEdge {
    std::array<int, 2> nodes{-1, -1};
    int modelEdge = -1;             ///< of the solid; -1: ink
    std::vector<LinePiece> pieces;  ///< ink: stretches of `lines`, in order
    double redrawn = 0.0;           ///< model: share of it that a stroke ran along
};

/// T-EXTRACT: the strokes, joined among themselves and with the visible edges of the
/// solid that they meet within the distance threshold. Model edges are cut at the meeting points;
/// only stretches on a short way between two of them are kept.
/// \paper{4.1.2}
struct JointGraph {
    std::vector<InkLine> lines;  ///< strokes that run along no model edge
    std::vector<JointNode> nodes;
    std::vector<JointEdge> edges;  ///< ink first
    std::size_t inkEdges = 0;
    std::vector<std::vector<int>> ways;  ///< edges, ascending: each way over model edges from one
                                         ///< place where strokes meet the solid to the next
    bool touches = false;                ///< some stroke meets the solid
    bool redraws = false;                ///< some stroke runs along a model edge
};

struct ExtractOptions {
    Thresholds thresholds;
    ReadingOptions reading;
    bool redraws = true;  ///< take strokes along model edges for those
};

JointGraph extractJointGraph(const InkReading& ink, const ModelView& model,
                             const ExtractOptions& options);

/// A part of the joint graph that has the shape of an aspect.
struct JointReading {
    EdgeGraph graph;
    std::vector<int> junctionNode;  ///< per junction: node of the joint graph
    std::vector<int> edgeModel;     ///< per edge: edge of the solid, -1 for ink
    double strayPx = 0.0;           ///< length of ink left out
    int modelEdges = 0;             ///< extracted edges used
    bool goesOn = false;            ///< an edge is one of the model that ink continues
};

/// Ways to close the strokes with extracted edges to a connected graph whose shape is known, those
/// that leave out the least ink first; at most `limit`. Best-first search: an open end of ink goes
/// on along a way over model edges or is left out, then further ways may join what is closed
/// already. Cost: at most some hundred choices of edges.
/// \paper{4.1.3}
std::vector<JointReading> closedReadings(const JointGraph& joint,
                                         const std::function<bool(const PlaneGraph&)>& known,
                                         double distancePx, std::size_t limit);

}  // namespace ew
