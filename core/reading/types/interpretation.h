// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/camera.h"
#include "core/base/result.h"
#include "core/edge_graph/edge_graph.h"
#include "core/solid/polyhedron_spec.h"
#include "core/solid/solid.h"
#include "core/stroke/stroke.h"
#include "core/tlib/library.h"

namespace ew {

enum class Operation { Auto, Create, Add, Cut, Split };
/// "auto", "create", "add", "cut", "split".
std::string_view operationName(Operation op);

/// How the depth of a candidate was found.
enum class DepthRule {
    Orthographic,  ///< the drawing is a parallel projection; equations (1) to (13) or the solver
    Snapped,  ///< as Orthographic, after the ink was moved to the nearest drawing with a solution
    Oblique,  ///< front face true, depth = k times the drawn length
    Perspective,  ///< the drawing is what an eye at a finite distance sees
};

/// What speaks for and against a candidate, in units of twice a negative log-likelihood: the less,
/// the better. Comparable within one way of reading (free space, change of a solid).
struct Evidence {
    double fit = 0.0;       ///< drawn line ends that miss the picture of its edges
    double stray = 0.0;     ///< ink that it does not explain
    double bare = 0.0;      ///< its edges that were not drawn
    double freedoms = 0.0;  ///< what it could have been fitted with
    double prior = 0.0;     ///< what is unusual about it; what is usual has none
    double cost() const { return fit + stray + bare + freedoms + prior; }
};

/// One match with one interpretation, with the solid it makes.
struct Candidate {
    std::string templateId;
    std::string templateName;
    std::string aspect;  ///< e.g. "explicit-3": the number counts visible faces
    Operation operation = Operation::Create;
    DepthRule depth = DepthRule::Orthographic;
    std::string readingId;    ///< "default", a TemplateReading's id, "oblique", "perspective"
    std::string readingName;  ///< shown to people
    double score = 0.0;       ///< 0..1, 1 is a perfect fit
    Evidence evidence;
    double probability = 0.0;         ///< 0..1: that it is what was meant
    double residualPx = 0.0;          ///< rms distance of junctions to the solid's projection
    std::vector<int> junctionVertex;  ///< per junction of the graph: template vertex or -1
    int missingEdges = 0;             ///< visible template edges that were not drawn
    int extraEdges = 0;               ///< graph edges left unexplained
    std::vector<std::string> notes;   ///< sentences: what was assumed, e.g. a closed freedom
    PolyhedronSpec spec;              ///< the solid, or what is added or cut; body frame [mm]
    Pose pose;                        ///< body frame -> world
    int body = -1;                   ///< Add, Cut, Split: which of InterpretOptions::bodies changes
    std::optional<Solid> result;     ///< ... and what it becomes; of a Split the larger part
    std::optional<Solid> rest;       ///< of a Split the smaller part
    double obliqueFactor = 0.0;      ///< k, 0 unless depth == Oblique
    std::vector<int> unusedStrokes;  ///< pending strokes that it does not explain: they stay
};

/// What a one-click repair would do to the pending strokes or the thresholds.
struct Repair {
    enum class Kind {
        JoinEnds,
        DropStrokes,
        Redraw,  ///< drops `strokes` and draws `lines` in their place
        RaiseDistance,
        RaiseAngle,
        UseCandidate
    };
    Kind kind = Kind::JoinEnds;
    std::string label;         ///< for the button, e.g. "Join these ends"
    Vec2 from = Vec2::Zero();  ///< JoinEnds: the tip [px]
    Vec2 to = Vec2::Zero();    ///< JoinEnds: where it goes [px]
    std::vector<int>
        strokes;  ///< DropStrokes, Redraw: pending stroke indices; JoinEnds: the stroke to extend
    std::vector<std::array<Vec2, 2>> lines;  ///< Redraw [px]
    double value = 0.0;                      ///< RaiseDistance [px], RaiseAngle [degrees]
    int candidate = -1;                      ///< UseCandidate
};

/// What is marked in the viewport and in the graph panel.
struct Culprit {
    enum class Kind {
        OpenEnd,
        ExtraEdge,
        BadJunction,
        ImpossibleCorner,
        NotParallel,
        Stray,
        Crossing
    };
    Kind kind = Kind::OpenEnd;
    Vec2 at = Vec2::Zero();  ///< [px]
    Vec2 to = Vec2::Zero();  ///< OpenEnd: where it should meet; else = at
    std::string label;       ///< short, e.g. "gap 19 px, threshold 14 px"
    int junction = -1;       ///< of the graph, or -1
    int edge = -1;           ///< of the graph, or -1
};

/// The nearest template where nothing matched.
struct NearestTemplate {
    std::string templateId;
    std::string templateName;
    std::string aspect;
    std::vector<std::array<Vec2, 2>> missing;  ///< where edges are missing [px]
    std::vector<int> extra;                    ///< graph edges too many
};

/// Everything that was read from the pending strokes.
struct Interpretation {
    EdgeGraph graph;
    std::vector<Candidate> candidates;  ///< best first, at most InterpretOptions::maxCandidates
    std::optional<int> accepted;        ///< set where the best is clear enough to take by itself
    std::optional<Error> problem;       ///< set where `accepted` is not: why
    std::vector<Culprit> culprits;
    std::vector<Repair> repairs;
    std::optional<NearestTemplate> nearest;
    bool slip = false;  ///< all but one corner is the picture of a plainer shape than any candidate
};

struct InterpretOptions {
    Thresholds thresholds;
    OrthographicCamera camera;
    Operation operation = Operation::Auto;
    std::string templateId;      ///< only this template where not empty
    double obliqueFactor = 0.5;  ///< k of the oblique reading, 0.1..2
    int maxCandidates = 6;
    std::vector<Body> bodies;  ///< the solids that are there already
};

}  // namespace ew
