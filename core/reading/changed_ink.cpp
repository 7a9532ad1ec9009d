// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/changed_ink.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/edge_graph/guide_lines.h"
#include "core/reading/propose/gesture.h"
#include "core/reading/propose/whole_drawing.h"
#include "core/reading/question.h"
#include "core/reading/types/reading_params.h"
#include "core/solid/solid.h"
#include "core/tlib/library_index.h"

namespace ew {
namespace {

bool isSameSolid(const Candidate& a, const Candidate& b) {
    const auto first = Solid::fromSpec(a.spec);
    const auto second = Solid::fromSpec(b.spec);
    return first && second && first->vertices().size() == second->vertices().size() &&
           first->edges().size() == second->edges().size() &&
           std::abs(first->volume() / second->volume() - 1.0) < params::kSameVolume;
}

/// Does a solid leave strokes aside that are lines?
bool leavesLines(const InkReading& ink, const Candidate& c) {
    return std::any_of(c.unusedStrokes.begin(), c.unusedStrokes.end(), [&](int stroke) {
        return std::any_of(ink.segments.begin(), ink.segments.end(),
                           [stroke](const Segment& s) { return s.stroke == stroke; });
    });
}

/// One way to trim guide lines, read.
struct TrimmedReading {
    Interpretation reading;
    std::optional<Candidate> taken;  ///< a solid that has all lines that are left
    double cost = 0.0;               ///< of trimming and solid, in the unit of Evidence::cost
    bool doubtful = false;           ///< some line is no edge, or lines that run wild made a corner
};

/// Lines that were cut in the wrong place may make corners of four edges and more. An apex is one
/// such corner; two are doubtful.
bool hasOddCorners(const Candidate& c) {
    const auto solid = Solid::fromSpec(c.spec);
    if (!solid) return true;
    std::vector<int> edges(solid->vertices().size(), 0);
    for (const auto& e : solid->edges()) {
        for (const int v : e.ends) ++edges[static_cast<std::size_t>(v)];
    }
    return std::count_if(edges.begin(), edges.end(), [](int n) { return n > 3; }) > 1;
}

TrimmedReading readTrimmed(const TrimmedInk& way, const TemplateLibrary& library,
                           const InterpretOptions& options, const ReadInk& alone) {
    constexpr double kTrimmingCost = 10.0;
    TrimmedReading out;
    if (way.ink.segments.size() > mostLines(library)) {
        // No template shows so many lines.
        WholeReading whole = readWholeDrawing(way.ink, library, options);
        const bool taken = whole.clear && whole.residue <= params::kMostDetail;
        if (!whole.candidates.empty()) {
            out.reading = taken ? wholeOf(std::move(whole)) : offeredWhole(std::move(whole));
        }
    } else {
        out.reading = alone(way.ink);
    }
    for (Candidate& c : out.reading.candidates) {
        c.notes.emplace_back("Lines that run past the corners were taken for guide lines.");
    }
    if (out.reading.accepted) {
        const Candidate& c =
            out.reading.candidates[static_cast<std::size_t>(*out.reading.accepted)];
        const bool whole = c.missingEdges == 0 && c.extraEdges == 0;
        if (whole && !leavesLines(way.ink, c)) out.taken = c;
        out.cost = c.evidence.cost() + kTrimmingCost * way.cost;
        out.doubtful = hasOddCorners(c) || !way.dropped.empty();
    }
    for (Candidate& c : out.reading.candidates) {
        c.unusedStrokes.insert(c.unusedStrokes.end(), way.dropped.begin(), way.dropped.end());
        std::sort(c.unusedStrokes.begin(), c.unusedStrokes.end());
    }
    std::vector<NoiseItem>& noise = out.reading.graph.noise;
    noise.insert(noise.end(), way.tails.begin(), way.tails.end());
    return out;
}

}  // namespace

std::optional<Interpretation> readWithoutGuides(const InkReading& ink,
                                                const TemplateLibrary& library,
                                                const InterpretOptions& options,
                                                const ReadInk& alone) {
    constexpr std::size_t kMostWays = 4;
    constexpr double kFarOff = 1.0;     // in the unit of TrimmedInk::cost
    constexpr double kAllGuides = 0.7;  // share of the lines
    const auto ways = trimGuideLines(ink, options.thresholds.distancePx, kMostWays);
    std::vector<TrimmedReading> read;
    std::optional<Interpretation> refused;
    double least = std::numeric_limits<double>::infinity();
    for (const TrimmedInk& way : ways) {
        const bool agree = read.size() > 1 && isSameSolid(*read[0].taken, *read[1].taken);
        if (agree || way.cost > least + kFarOff) break;
        TrimmedReading one = readTrimmed(way, library, options, alone);
        if (one.taken) {
            least = std::min(least, way.cost);
            read.push_back(std::move(one));
        } else if (!refused && !one.reading.accepted && one.reading.problem) {
            refused = std::move(one.reading);
        }
    }
    if (read.empty()) {
        if (!refused || ways.front().share < kAllGuides) return std::nullopt;
        return refused;
    }
    std::stable_sort(read.begin(), read.end(),
                     [](const auto& a, const auto& b) { return a.cost < b.cost; });
    TrimmedReading& best = read.front();
    const bool rivalled = std::any_of(read.begin() + 1, read.end(), [&](const auto& other) {
        return other.cost < best.cost + params::kWholeMargin &&
               !isSameSolid(*other.taken, *best.taken);
    });
    if (rivalled || best.doubtful) askInstead(best.reading, "");
    return std::move(best.reading);
}

std::optional<Interpretation> readGesture(const InkReading& ink, const InterpretOptions& options,
                                          const ReadInk& alone) {
    for (const CompletedInk& whole : completedGestures(ink, options.thresholds.distancePx)) {
        Interpretation read = alone(whole.ink);
        if (!read.accepted) continue;
        const Candidate& c = read.candidates[static_cast<std::size_t>(*read.accepted)];
        if (c.missingEdges > 0 || c.extraEdges > 0) continue;
        for (Candidate& offered : read.candidates) {
            offered.notes.push_back(std::to_string(whole.added) +
                                    " edges that were not drawn were added.");
        }
        askInstead(read, " of these lengths");
        return read;
    }
    return std::nullopt;
}

}  // namespace ew
