// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/interpret.h"

#include <algorithm>
#include <optional>

#include "core/edge_graph/build.h"
#include "core/reading/propose/free_drawing.h"
#include "core/reading/propose/modification.h"
#include "core/reading/propose/whole_drawing.h"
#include "core/tlib/library_index.h"

namespace ew {
namespace {

/// Most lines that any view of a template has.
std::size_t mostLines(const TemplateLibrary& library) {
    std::size_t most = 0;
    for (const auto& entry : library.index().entries) {
        for (const Aspect& a : entry->aspects) most = std::max(most, a.graph.edges.size());
    }
    return most;
}

/// Does a reading by templates say no more than that there is none, or offer only some that have
/// edges too many or too few? What it can tell better (a gap, a choice, a flat outline) is the
/// person's to mend.
bool foundNothing(const Interpretation& reading) {
    if (reading.accepted || !reading.problem) return false;
    const Errc code = reading.problem->code;
    if (code == Errc::NoMatch || code == Errc::NotParallel || code == Errc::NoSolution) return true;
    if (code != Errc::Ambiguous || reading.candidates.empty()) return false;
    const Candidate& best = reading.candidates.front();
    return best.missingEdges > 0 || best.extraEdges > 0 || !best.unusedStrokes.empty();
}

Interpretation wholeOf(WholeReading whole) {
    Interpretation read;
    read.graph = std::move(whole.graph);
    read.candidates = std::move(whole.candidates);
    read.accepted = 0;
    return read;
}

/// One template, or the drawing as a whole. What has more lines than any template shows is read as
/// a whole first: looking for what may be wrong with it takes long.
Interpretation readInFreeSpace(const InkReading& ink, const TemplateLibrary& library,
                               const InterpretOptions& options) {
    const bool any = options.templateId.empty();
    const std::size_t most = mostLines(library);
    std::optional<WholeReading> whole;
    if (any && ink.segments.size() > most) {
        whole = readWholeDrawing(ink, library, options);
        if (whole->clear && whole->graph.edges.size() > most && !whole->isKnown) {
            return wholeOf(*std::move(whole));
        }
    }
    Interpretation out = readFreeDrawing(ink, library, options);
    if (!any || !foundNothing(out)) return out;
    if (!whole) whole = readWholeDrawing(ink, library, options);
    return whole->clear ? wholeOf(*std::move(whole)) : out;
}

}  // namespace

Interpretation interpret(const std::vector<Stroke>& strokes, const TemplateLibrary& library,
                         const InterpretOptions& options) {
    Interpretation out;
    if (strokes.empty()) {
        out.problem = Error{Errc::EmptySketch, "Nothing is drawn yet.", {}};
        return out;
    }
    if (strokes.size() > kMaxPendingStrokes) {
        out.problem = Error{Errc::TooManyStrokes,
                            "There are " + std::to_string(strokes.size()) + " strokes; at most " +
                                std::to_string(kMaxPendingStrokes) + " are read at once.",
                            {}};
        return out;
    }
    for (const Stroke& s : strokes) {
        if (auto ok = validateStroke(s); !ok) {
            out.problem = ok.error();
            return out;
        }
    }
    if (!options.templateId.empty() && library.find(options.templateId) < 0) {
        out.problem = Error{Errc::UnknownTemplate,
                            "There is no template \"" + options.templateId + "\" in the library.",
                            {}};
        return out;
    }
    const InkReading ink = readInk(strokes, options.thresholds.distancePx);
    if (isCrowded(ink, options.thresholds.distancePx)) {
        out.problem = Error{Errc::TooManyStrokes,
                            "There are more lines than the " + std::to_string(kMaxLines) +
                                " that are read at once; draw one solid at a time.",
                            {strokes.front().samples.front().position}};
        return out;
    }
    if (options.bodies.empty() || options.operation == Operation::Create) {
        return readInFreeSpace(ink, library, options);
    }
    ModificationReading change = readModification(ink, library, options);
    if (!change.interpretation.candidates.empty() || options.operation != Operation::Auto) {
        return std::move(change.interpretation);
    }
    Interpretation created = readFreeDrawing(ink, library, options);
    // Lines that meet the solid were hardly meant to be a body of their own.
    if (change.redraws || (change.touches && created.accepted)) {
        created.accepted.reset();
        created.problem = change.interpretation.problem;
    }
    return created;
}

}  // namespace ew
