// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/edge_graph/edge_graph.h"
#include "core/tlib/matcher.h"

namespace ew {

/// A template edge as it was drawn.
struct DrawnEdge {
    int edge = -1;  ///< TemplateAnalysis::edges
    std::array<int, 2> vertex{-1,
                              -1};  ///< template vertex at either end, -1: the edge goes on, hidden
    std::array<Vec2, 2> tips{Vec2::Zero(), Vec2::Zero()};  ///< ends of the fitted line [px]
    std::array<bool, 2> penEnd{true, true};                ///< GraphEdge::penEnd
    double length() const { return (tips[1] - tips[0]).norm(); }
    Vec2 direction() const { return (tips[1] - tips[0]).normalized(); }
};

/// What a match says was seen of a template.
struct Sighting {
    std::vector<DrawnEdge> edges;
    std::vector<Vec2> vertexPx;     ///< per template vertex: drawn position (where seen)
    std::vector<bool> seen;         ///< per template vertex
    std::vector<int> visibleFaces;  ///< template faces towards the eye
    double acrossPx = 1.0;          ///< spread of line ends across the line [px], weights the fits
    double alongPx = 4.0;           ///< ... and along it
    double sizePx = 1.0;            ///< diagonal of the drawing
    double doubt = 1.0;  ///< 0..1: how far regularity may overrule slight evidence; next to
                         ///< nothing where the drawing is exact
};

/// Weight of where a pen stopped, against where hands stop usually: where the drawing is exact the
/// lines say all, and stops are rounded by resampling.
double stopWeight(const Sighting& sighting);

Sighting sightingOf(const EdgeGraph& graph, const GraphMatch& match, double distancePx);

/// A solid's vertices in camera space: x right, y down, z away from the eye, all in px; x and y are
/// Sketch Plane px.
using CameraPoints = std::vector<Vec3>;

/// Root mean square distance of the drawn line ends from the projected template edges [px]
/// (across the edges only: where a hand stops says little).
double residualPx(const Sighting& sighting, const TemplateAnalysis& analysis,
                  const CameraPoints& points);

/// True where the template's visible faces, and only front-facing ones among them, look at the eye;
/// `mirrored` receives whether the points are a mirror image of the template (negative volume).
bool facesLookRight(const Template& tmpl, const Sighting& sighting, const CameraPoints& points,
                    bool& mirrored);

}  // namespace ew
