// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "core/edge_graph/build.h"
#include "core/reading/evidence/sighting.h"
#include "core/reading/score/slips.h"
#include "core/reading/types/interpretation.h"

namespace ew {

/// A candidate with what decides between it and others.
struct RatedCandidate {
    Candidate candidate;
    double misfit = 0.0;  ///< squared distances of line ends over their variance, per line end
    double cost = 0.0;    ///< twice a negative log-likelihood plus prices; least is best
    bool withinThresholds =
        true;                  ///< parallels within the angle threshold, lines close to the solid
    double parallelDeg = 0.0;  ///< GraphMatch::parallelDeg
    int parameters = 0;        ///< freedoms of its picture
    bool outline = false;      ///< laid over the ink as a whole, not told by line ends
    bool interrupted = false;  ///< some edge has a stretch without ink: lines inside its faces are
                               ///< no detail then, they belong to another shape
    std::shared_ptr<const LibraryEntry> entry;
    GraphMatch match;
    std::shared_ptr<const EdgeGraph> graph;  ///< what was matched
    CameraPoints drawn;  ///< per template vertex: its picture and depth as fitted to the ink
};

/// How well the drawing was drawn, from the drawing itself: how far lines miss their common
/// junctions, and how much they wobble [px].
double drawingNoisePx(const EdgeGraph& graph);
/// The same or, where that is more, what the wobble of the lines tells of the hand [px].
double drawnNoisePx(const EdgeGraph& graph, const InkReading& ink);

/// Standard deviation per axis of a drawn corner from where it is meant to be [px], shared by all
/// lines that meet there: 1.7% of the mean line, 2 px at least, and no less than its line ends miss
/// each other. A hand places corners by eye, so
/// lines that are ruled straight and meet to the pixel do not make it smaller (measured on boxes:
/// `sigma_corner` of two levels of noise, whole polyhedra by designers).
double cornerSpread(const InkReading& ink, double distancePx, double noisePx);

/// What the choice between candidates needs to know besides the graph.
struct ReadingContext {
    const InterpretOptions& options;
    double noisePx = 1.0;   ///< how far lines of this hand miss what they are meant to meet
    double cornerPx = 0.0;  ///< how far its corners lie from where they are meant; see cornerSpread
    double worthCost =
        std::numeric_limits<double>::infinity();  ///< dearer candidates need not be solved
};

/// All readings of one match: for a rectilinear template the closed form, else snapped and oblique;
/// for any other the general solver's most regular solid. Empty where no solid fits.
/// \param slips  receives what the drawing would be of, were it drawn right in one place.
/// \paper{5.1}
std::vector<RatedCandidate> readingsOf(const EdgeGraph& graph, const GraphMatch& match,
                                       const ReadingContext& context, std::vector<Slip>& slips);

/// Adds the other readings that the best candidate's template names in its file (isosceles,
/// right-angled, ...). They keep the cost order of the default with a small price each.
/// \param candidates  best first.
void addNamedReadings(std::vector<RatedCandidate>& candidates, const ReadingContext& context);

}  // namespace ew
