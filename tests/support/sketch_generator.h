// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/camera.h"
#include "core/solid/polyhedron_spec.h"
#include "core/stroke/stroke.h"
#include "tests/support/random.h"
#include "tests/support/visible_edges.h"

namespace ew::test {

/// What a right answer to a drawing looks like.
struct GroundTruth {
    std::string templateId;
    int vertices = 0, edges = 0, faces = 0;  ///< of the solid, hidden ones included
    double volume = 0.0;                     ///< [mm^3]
    /// The three angles at the drawing's Y junction (a vertex whose three faces are all seen,
    /// every angle under 180) [degrees]; the most even one where there are several.
    std::optional<std::array<double, 3>> yAnglesDeg;
};

/// A drawing with the solid that it shows.
struct SketchCase {
    PolyhedronSpec spec;  ///< world coordinates [mm]
    OrthographicCamera camera;
    VisibleDrawing drawing;
    GroundTruth truth;
};

/// When a view counts as readable. A view that breaks a rule is drawn again from elsewhere: these
/// are drawings that no person could tell from another shape, whatever reads them. Pixel rules
/// stand a little over the default distance threshold (14 px), angle rules at or a little over the
/// default angle threshold (12 degrees), because within those thresholds two ends are one and two
/// lines are parallel by definition.
struct ReadabilityRules {
    double shortestEdgePx = 18.0;      ///< "short-edge": a visible edge is shorter
    double nearestJunctionsPx = 18.0;  ///< "near-junctions": two junctions are nearer (T junctions
                                       ///< and vertices alike)
    double nearestLinePx = 12.0;       ///< "near-line": a junction is nearer to an edge that does
                                       ///< not end there (a T junction's bar excepted)
    double sharpestDeg = 9.0;          ///< "sharp-corner": two edges of a junction enclose less
    double straightestDeg = 12.0;      ///< "straight-corner": where two edges meet alone, the line
                                       ///< turns by less, so that nobody sees a corner
    double frustumTaperDeg = 15.0;     ///< "looks-like-box": all visible slant edges of a frustum
                                       ///< are parallel within this
    int fewestFaces = 2;               ///< "few-faces": fewer faces are seen (frustum and box: 3)
    /// "no-notch": the reentrant corner of an L-prism is not seen.
};

/// How many views were tried and which rule threw out how many (the first one broken counts).
struct ReadabilityCounts {
    int tried = 0;
    std::map<std::string, int> rejected;

    int rejectedTotal() const;
    void add(const ReadabilityCounts& other);
};

/// The templates that randomSketch knows: cube, triangular-prism, triangular-pyramid,
/// wedge-frustum, l-prism.
const std::vector<std::string>& sketchTemplates();

/// A random instance of a template class seen by a random camera.
///
/// Shapes (before scaling): cube: a box with edge ratios 0.35 to 1. triangular-prism: right, base
/// angles 35 to 100 degrees, height 0.5 to 1.6 mean base edges, standing on its base or lying on a
/// side. triangular-pyramid: base angles 35 to 100 degrees, apex above the inside of the base, at
/// least 0.4 of the regular one's volume for its mean edge. wedge-frustum: base ratio 0.5 to 1, top
/// 0.3 to 0.75 of it, height 0.35 to 1.2. l-prism: notch 0.3 to 0.7 of either side, any of the 24
/// axis-aligned attitudes.
///
/// Camera: tilt 15 to 65 degrees above the horizon, any azimuth, 0.05 to 1 mm a px. The drawing's
/// bounding box diagonal is 150 to 500 px; its middle is the middle of a 1280 x 800 viewport.
///
/// \param id      one of sketchTemplates().
/// \param counts  added to where not null.
SketchCase randomSketch(const std::string& id, Random& random, ReadabilityCounts* counts = nullptr,
                        const ReadabilityRules& rules = {});

/// The first rule that a view breaks, empty where it is readable.
std::string unreadableBecause(const SketchCase& sketch, const ReadabilityRules& rules);

/// The strokes as a sketch script (docs/sketch-script.md) that replays to the same solid: camera,
/// thresholds, strokes with pressure and time, apply. Coordinates are written so that they read
/// back to the bit.
std::string sketchScriptText(const std::string& title, const OrthographicCamera& camera,
                             const Thresholds& thresholds, const std::vector<Stroke>& strokes);

}  // namespace ew::test
