// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "core/modeling/interpretation.h"
#include "core/modeling/sighting.h"

namespace ew {

/// A candidate with what decides between it and others.
struct RatedCandidate {
    Candidate candidate;
    double misfit = 0.0;  ///< squared distances of line ends over their variance, per line end
    double cost = 0.0;    ///< twice a negative log-likelihood plus prices; least is best
    bool withinThresholds =
        true;                  ///< parallels within the angle threshold, lines close to the solid
    double parallelDeg = 0.0;  ///< GraphMatch::parallelDeg
    std::shared_ptr<const LibraryEntry> entry;
    GraphMatch match;
    CameraPoints drawn;  ///< per template vertex: its picture and depth as fitted to the ink
};

/// How well the drawing was drawn, from the drawing itself: how far lines miss their common
/// junctions, and how much they wobble [px].
double drawingNoisePx(const EdgeGraph& graph);

/// What the choice between candidates needs to know besides the graph.
struct ReadingContext {
    const InterpretOptions& options;
    double noisePx = 1.0;  ///< how far lines of this hand miss what they are meant to meet
    double worthCost =
        std::numeric_limits<double>::infinity();  ///< dearer candidates need not be solved
};

/// All readings of one match: for a rectilinear template the closed form, else snapped and oblique;
/// for any other the general solver's most regular solid. Empty where no solid fits. \param
/// impossibleCorner  receives the drawn corner that breaks Perkins' law where that was the reason.
std::vector<RatedCandidate> readingsOf(const EdgeGraph& graph, const GraphMatch& match,
                                       const ReadingContext& context,
                                       std::optional<Vec2>& impossibleCorner);

/// The other readings that a template's file names (isosceles, right-angled, ...), for a match that
/// the general solver has read already. They keep the cost order of the default with a small price
/// each.
std::vector<RatedCandidate> namedReadings(const EdgeGraph& graph, const RatedCandidate& base,
                                          const ReadingContext& context);

}  // namespace ew
