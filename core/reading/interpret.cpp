// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/interpret.h"

#include "core/edge_graph/build.h"
#include "core/reading/propose/free_drawing.h"
#include "core/reading/propose/modification.h"

namespace ew {

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
        return readFreeDrawing(ink, library, options);
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
