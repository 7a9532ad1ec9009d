// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/edge_graph/canonical.h"
#include "core/edge_graph/faces.h"
#include "core/tlib/analysis.h"

namespace ew {

/// What of a template an aspect shows.
enum class AspectKind {
    Explicit,  ///< every edge that is visible of the body itself
    Mouth,     ///< only the outlines, on the solid, of the faces where a cut opens
    Cavity,    ///< the outline of that mouth, and the walls as they are seen through it
};

/// A 2D Edge Graph that a template can show: what is visible from one class of
/// directions.
struct Aspect {
    std::string name;  ///< "explicit-3": three visible faces
    AspectKind kind = AspectKind::Explicit;
    std::vector<int> mouth;   ///< faces that lie in faces of the solid, ascending; empty where
                              ///< explicit
    PlaneGraph graph;         ///< seen along directions[0], unit scale, y down
    std::vector<int> vertex;  ///< per graph vertex: template vertex, -1 for a T junction
    std::vector<int> edge;    ///< per graph edge: index into TemplateAnalysis::edges
    std::vector<int> visibleFaces;  ///< ascending
    std::vector<Vec3>
        directions;           ///< template frame, unit, from the eye into the scene; well apart
    bool edgeOn = false;      ///< some face is seen as a line: nobody sees it so, but people draw
                              ///< two faces of a body like that
    CanonicalForm form;       ///< of graph, with one walk only
    std::vector<bool> outer;  ///< per graph vertex: on the outline
};

/// Fills form and outer from graph.
void indexAspect(Aspect& aspect);

/// Derives the explicit aspects of a template by looking at its reference shape from all sides:
/// directions spread over the sphere, edges that others hide removed exactly (pieces split at
/// crossings and tested against the faces), equal graphs united. Views with fewer than two visible
/// faces, and views that do not hang together, are left out: no drawing in free space can be read
/// from them. Cost: a few ms for a template of 12 vertices; convex templates need no occlusion
/// test.
/// \paper{4.2.1}
std::vector<Aspect> explicitAspects(const Template& tmpl, const TemplateAnalysis& analysis);

/// The aspects of a convex template that show just two faces because all others are hidden or seen
/// edge-on ("edge-on-2"): front and top of a box, say.
std::vector<Aspect> edgeOnAspects(const Template& tmpl, const TemplateAnalysis& analysis);

/// Derives the implicit aspects that a cut shows: for every connected set of up to
/// four faces that can be seen together, their outlines alone (two faces or more, or the inside
/// would not be told), and, of convex templates, their common outline with the walls behind as far
/// as they are seen through it. Proportions matter to the latter, so the shape is looked at
/// stretched along the mouth's normal too. Cost: about 10 ms for a template of 12 edges.
/// \paper{4.2.2}
std::vector<Aspect> implicitAspects(const Template& tmpl, const TemplateAnalysis& analysis);

/// One view: the visible edges of the shape along a direction. Empty name where the view is
/// accidental (a face seen edge-on, a vertex over an edge).
Aspect viewAspect(const PolyhedronSpec& shape, const TemplateAnalysis& analysis,
                  const Vec3& direction);

}  // namespace ew
