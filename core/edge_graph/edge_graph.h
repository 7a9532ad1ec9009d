// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/base/vec.h"

namespace ew {

/// Where an edge of the graph comes from.
enum class EdgeOrigin { Stroke, Model };

/// A vertex of the Edge Graph.
struct Junction {
    Vec2 position = Vec2::Zero();  ///< [Sketch Plane px]
};

/// An edge of the Edge Graph, with the ink that it came from.
struct GraphEdge {
    std::array<int, 2> ends{-1, -1};  ///< junction indices
    EdgeOrigin origin = EdgeOrigin::Stroke;
    std::array<Vec2, 2> tips{Vec2::Zero(), Vec2::Zero()};  ///< fitted line at either end [px]
    std::array<bool, 2> penEnd{
        true, true};           ///< a pen end or corner is there; false where the line runs on
    std::vector<int> strokes;  ///< indices of the pending strokes that drew it
    double inkPx = 0.0;        ///< length of ink that supports it [px]
    double wobblePx = 0.0;     ///< rms distance of that ink to the fitted line [px]
};

/// Why something was dropped from the graph.
/// \paper{4.1.3}
enum class NoiseKind { Dot, Scribble, Curve, Stray, Overshoot, ModelEdge };

/// A stroke, or a part of one, that is not in the graph.
struct NoiseItem {
    NoiseKind kind = NoiseKind::Stray;
    int stroke = -1;             ///< index of the pending stroke, -1 for a model edge
    std::vector<Vec2> polyline;  ///< what to draw as dropped [px]
};

/// A stroke end that meets nothing within the distance threshold although it points at something.
struct OpenEnd {
    Vec2 tip = Vec2::Zero();     ///< [px]
    Vec2 target = Vec2::Zero();  ///< where it should have met [px]
    double gapPx = 0.0;          ///< distance of the two [px], > the distance threshold
    int edge = -1;               ///< index into EdgeGraph::dangling
};

/// A drawn line that is attached at one end only.
struct DanglingEdge {
    std::array<Vec2, 2> ends{Vec2::Zero(), Vec2::Zero()};  ///< [px]; ends[0] is attached
    int junction = -1;  ///< junction of ends[0], -1 where that was dropped
    std::vector<int> strokes;
};

/// The 2D Edge Graph: a plane graph on the Sketch Plane. Edges meet in junctions
/// only; every edge borders a closed region. Junction and edge order is deterministic but has
/// no meaning.
/// \paper{4.1}
struct EdgeGraph {
    std::vector<Junction> junctions;
    std::vector<GraphEdge> edges;
    std::vector<NoiseItem> noise;
    std::vector<DanglingEdge> dangling;
    std::vector<OpenEnd> openEnds;

    bool empty() const { return edges.empty(); }
};

}  // namespace ew
