// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/interpret.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "core/base/words.h"
#include "core/edge_graph/build.h"
#include "core/reading/changed_ink.h"
#include "core/reading/evidence/hand_noise.h"
#include "core/reading/explain/causes.h"
#include "core/reading/explain/convergence.h"
#include "core/reading/propose/apart.h"
#include "core/reading/propose/cutting_plane.h"
#include "core/reading/propose/free_drawing.h"
#include "core/reading/propose/modification.h"
#include "core/reading/propose/profile.h"
#include "core/reading/propose/whole_drawing.h"
#include "core/reading/question.h"
#include "core/reading/score/candidates.h"
#include "core/reading/score/picture_evidence.h"
#include "core/reading/score/probability.h"
#include "core/reading/types/reading_params.h"
#include "core/solid/boolean.h"
#include "core/solid/solid.h"
#include "core/tlib/library_index.h"

namespace ew {
namespace {

/// Does a reading by templates say no more than that there is none, or offer only some that have
/// edges too many or too few? What it can tell better (a gap, a choice, a flat outline) is the
/// person's to mend.
bool foundNothing(const Interpretation& reading) {
    // That a corner is out of place is told better than an odd solid is made of it.
    if (reading.accepted || !reading.problem || reading.slip) return false;
    const Errc code = reading.problem->code;
    for (const Errc none : {Errc::NoMatch, Errc::NotParallel, Errc::NoSolution,
                            Errc::SeparateDrawings, Errc::SelfCrossing}) {
        if (code == none) return true;
    }
    if (code != Errc::Ambiguous || reading.candidates.empty()) return false;
    const Candidate& best = reading.candidates.front();
    return best.missingEdges > 0 || best.extraEdges > 0 || !best.unusedStrokes.empty();
}

/// What speaks against a template that was taken.
struct Doubt {
    bool contradicted = false;  ///< its picture is not the drawing
    bool detailed = false;      ///< lines are left inside its faces
    bool poor = false;          ///< its corners lie farther off than this hand's lines do, or it
                                ///< has edges more or fewer than were drawn
    bool hidden = false;        ///< its hidden edges are drawn, and not looked at
    bool any() const { return contradicted || detailed || poor || hidden; }
};

/// Views that are no parallel projection are not to be compared.
Doubt doubtOf(const InkReading& ink, const Interpretation& reading,
              const InterpretOptions& options) {
    Doubt doubt;
    const Candidate& c = reading.candidates[static_cast<std::size_t>(*reading.accepted)];
    if (c.depth != DepthRule::Orthographic) return doubt;
    const auto solid = Solid::fromSpec(c.spec);
    if (!solid) return doubt;
    const double noise = drawnNoisePx(reading.graph, ink);
    const double near = std::min(options.thresholds.distancePx,
                                 params::kLeastBesidePx + 3.0 * noise + 2.0 * c.residualPx);
    const PictureEvidence picture = pictureEvidence(ink, *solid, c.pose, options.camera, near);
    // Lines inside a face may be a window that was drawn on it, or a part of the solid; an edge of
    // the graph across a face is no window.
    doubt.hidden = picture.showsHidden();
    doubt.detailed = picture.detailPx > params::kMostDetail * picture.inkPx;
    doubt.contradicted = picture.contradiction() > params::kMostContradiction ||
                         (doubt.detailed && c.extraEdges > 0);
    doubt.poor = c.missingEdges > 0 || c.extraEdges > 0 ||
                 c.residualPx > params::kPoorFitNoises * noise + params::kPoorFitPx;
    return doubt;
}

void askAboutLines(Interpretation& reading) {
    const Candidate& c = reading.candidates[static_cast<std::size_t>(*reading.accepted)];
    const bool lacks = c.missingEdges > 0 && c.extraEdges == 0 && c.unusedStrokes.empty();
    askInstead(reading, lacks ? ", but only with edges that are not drawn"
                              : ", but only without some of the lines");
}

/// Would a body of its own run through one that is there?
bool runsThrough(const Candidate& c, const std::vector<Body>& bodies) {
    return std::any_of(bodies.begin(), bodies.end(), [&](const Body& body) {
        PolyhedronSpec spec = c.spec;
        const Mat3 toBody = body.pose.rotation.transpose();
        for (Vec3& v : spec.vertices) {
            v = toBody * (c.pose.toWorld(v) - body.pose.translation);
        }
        const auto solid = Solid::fromSpec(spec);
        if (!solid) return false;
        const auto common = combine(body.solid, *solid, BooleanKind::Intersect);
        return common || common.error().code == Errc::NoChange;  // all of the body
    });
}

Vec2 middleOf(const std::vector<Stroke>& strokes) {
    Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
    Vec2 high = -low;
    for (const Stroke& s : strokes) {
        for (const PenSample& p : s.samples) {
            low = low.cwiseMin(p.position);
            high = high.cwiseMax(p.position);
        }
    }
    return 0.5 * (low + high);
}

/// Is all that was drawn an outline on a face? Much ink is more than that.
bool isOutline(const std::vector<Stroke>& strokes, const InkReading& ink,
               const InterpretOptions& options) {
    constexpr std::size_t kMost = 24;
    if (ink.segments.size() > kMost) return false;
    const auto profile = readProfile(strokes, options, middleOf(strokes));
    return profile && profile->strokes.size() == strokes.size();
}

/// May strokes be a line across a solid? A drawing has more of them.
bool isCuttingLine(const std::vector<Stroke>& strokes) {
    constexpr std::size_t kMost = 4;
    return strokes.size() <= kMost;
}

/// A cut through a solid is never done unasked.
Interpretation offered(Interpretation split) {
    std::vector<Vec2> where;
    for (const Junction& j : split.graph.junctions) where.push_back(j.position);
    Repair use;
    use.kind = Repair::Kind::UseCandidate;
    use.candidate = *split.accepted;
    use.label = "Cut the solid in two";
    split.repairs = {std::move(use)};
    split.problem =
        Error{Errc::Ambiguous, "This line could cut the solid in two; choose it, or draw on.",
              std::move(where)};
    split.accepted.reset();
    return split;
}

/// Behind what strokes may mean as a change: a cut in two, where they may mean that.
void offerCut(const std::vector<Stroke>& strokes, const InterpretOptions& options,
              Interpretation& reading) {
    if (!isCuttingLine(strokes)) return;
    Interpretation split = readCuttingPlane(strokes, options);
    if (split.candidates.empty()) return;
    // Of many changes that it might be the last one gives way.
    const auto most = static_cast<std::size_t>(std::max(1, options.maxCandidates - 1));
    if (reading.candidates.size() > most) reading.candidates.resize(most);
    for (Candidate& c : split.candidates) {
        if (static_cast<int>(reading.candidates.size()) >= options.maxCandidates) return;
        c.junctionVertex.assign(reading.graph.junctions.size(), -1);
        reading.candidates.push_back(std::move(c));
    }
}

/// What speaks of another graph stands behind what a reading offers already.
void offerToo(std::vector<Candidate> others, int most, Interpretation& reading) {
    double left = 1.0;
    for (const Candidate& c : reading.candidates) left = std::max(0.0, left - c.probability);
    for (Candidate& c : others) {
        if (static_cast<int>(reading.candidates.size()) >= most) return;
        // Their costs are not comparable: they have what the others leave.
        c.probability *= left;
        // The candidates speak of another graph.
        c.junctionVertex.assign(reading.graph.junctions.size(), -1);
        reading.candidates.push_back(std::move(c));
    }
}

/// A template that does not fit well enough, and a solid that explains the drawing, but not without
/// doubt: what costs less is offered first. An unsteady hand's bends make many an odd solid.
Interpretation offerBoth(Interpretation reading, WholeReading whole, int most) {
    if (reading.candidates.empty()) return offeredWhole(std::move(whole));
    const double templates = reading.candidates.front().evidence.cost();
    if (templates > whole.candidates.front().evidence.cost()) {
        Interpretation out = offeredWhole(std::move(whole));
        offerToo(std::move(reading.candidates), most, out);
        return out;
    }
    offerToo(std::move(whole.candidates), most, reading);
    return reading;
}

/// Is the solid that explains the drawing as a whole what was taken, or merely less regular?
bool isAlike(const Candidate& taken, const Candidate& whole, const Doubt& doubt) {
    if (taken.templateId == whole.templateId) return true;
    return !doubt.contradicted && taken.spec.vertices.size() == whole.spec.vertices.size() &&
           taken.spec.faces.size() == whole.spec.faces.size();
}

/// What is read by its lines alone may taper as the drawing does, where that is in perspective.
void askAboutPerspective(const InkReading& ink, double distancePx, Interpretation& reading) {
    if (!reading.accepted) return;
    const Candidate& c = reading.candidates[static_cast<std::size_t>(*reading.accepted)];
    if (c.aspect != "region") return;
    // Three lines may converge by chance, as those of a hexagon's edges do.
    constexpr std::size_t kLeastLines = 4;
    const auto found = findConvergence(reading.graph, ink, distancePx, kLeastLines);
    if (!found) return;
    askInstead(reading, "");
    reading.problem = perspectiveError(*found);
}

/// One template, or the drawing as a whole. What has more lines than any template shows is read as
/// a whole first, and taken so where that explains next to all of them: looking for what may be
/// wrong with it takes long.
Interpretation readInFreeSpace(const InkReading& ink, const TemplateLibrary& library,
                               const InterpretOptions& options) {
    const bool any = options.templateId.empty();
    const std::size_t most = mostLines(library);
    std::optional<WholeReading> whole;
    if (any && ink.segments.size() > most) {
        whole = readWholeDrawing(ink, library, options);
        if (whole->clear && whole->graph.edges.size() > most && !whole->isKnown &&
            whole->residue <= params::kMostDetail) {
            return wholeOf(*std::move(whole));
        }
    }
    Interpretation out = readFreeDrawing(ink, library, options);
    if (!any) return out;
    const Doubt doubt = out.accepted ? doubtOf(ink, out, options) : Doubt{};
    if (!doubt.any() && !foundNothing(out)) return out;
    std::optional<Candidate> taken;
    if (out.accepted) taken = out.candidates[static_cast<std::size_t>(*out.accepted)];
    if (doubt.contradicted) askAboutLines(out);
    if (!whole) whole = readWholeDrawing(ink, library, options);
    if (whole->candidates.empty()) return out;
    // What was taken gives way only to what explains next to all of the lines.
    const bool explains = !taken || whole->residue <= params::kMostDetail;
    if (taken && isAlike(*taken, whole->candidates.front(), doubt)) {
        // With all lines the same solid is known better than without some.
        const bool better = whole->clear && explains && (taken->extraEdges > 0 || doubt.hidden);
        return better ? wholeOf(*std::move(whole)) : out;
    }
    if (whole->clear && explains) return wholeOf(*std::move(whole));
    // What has all of the ink is more than a reason why no template fits.
    if (!taken && !out.slip && whole->residue <= params::kMostDetail) {
        return offerBoth(std::move(out), *std::move(whole), options.maxCandidates);
    }
    // Who draws hidden lines means all other lines as edges, too.
    const bool partial = doubt.hidden && doubt.detailed;
    if (taken && (partial || (doubt.poor && explains))) askAboutLines(out);
    if (!taken || !explains) return out;
    // A template with lines on it stays what was taken; a solid that has them as edges, but not
    // without doubt, stands behind it.
    offerToo(std::move(whole->candidates), options.maxCandidates, out);
    return out;
}

ReadInk readingAlone(const TemplateLibrary& library, const InterpretOptions& options) {
    return [&](const InkReading& ink) {
        Interpretation read = readInFreeSpace(ink, library, options);
        askAboutPerspective(ink, options.thresholds.distancePx, read);
        return read;
    };
}

/// A drawing of bodies of their own.
/// \param changed  set where lines were cut off at their corners first.
Interpretation readCreation(const InkReading& ink, const TemplateLibrary& library,
                            const InterpretOptions& options, bool& changed) {
    const ReadInk alone = readingAlone(library, options);
    if (options.templateId.empty()) {
        if (auto bodies = readApart(ink, options, alone)) return *std::move(bodies);
    }
    // First, for guide lines enclose much that is none of the solid's faces.
    auto edges = readWithoutGuides(ink, library, options, alone);
    changed = edges.has_value();
    if (!changed) return alone(ink);
    askAboutPerspective(ink, options.thresholds.distancePx, *edges);
    return *std::move(edges);
}

/// Strokes that can be read, as a drawing in free space or a change of the solids that are there.
/// \param changed  set where lines were cut off at their corners first.
Interpretation readDrawing(const std::vector<Stroke>& strokes, const TemplateLibrary& library,
                           const InterpretOptions& options, bool& changed) {
    const InkReading ink = readInk(strokes, options.thresholds.distancePx);
    if (isCrowded(ink, options.thresholds.distancePx)) {
        Interpretation out;
        out.problem = Error{Errc::TooManyStrokes,
                            "There are more lines than the " + std::to_string(kMaxLines) +
                                " that are read at once; draw one solid at a time.",
                            {strokes.front().samples.front().position}};
        return out;
    }
    if (options.bodies.empty() || options.operation == Operation::Create) {
        return readCreation(ink, library, options, changed);
    }
    ModificationReading change = readModification(ink, library, options);
    if (!change.interpretation.candidates.empty() || options.operation != Operation::Auto) {
        if (!change.interpretation.accepted && options.operation == Operation::Auto) {
            offerCut(strokes, options, change.interpretation);
        }
        return std::move(change.interpretation);
    }
    Interpretation created = change.touches || change.redraws
                                 ? readFreeDrawing(ink, library, options)
                                 : readCreation(ink, library, options, changed);
    // Lines that meet the solid were hardly meant to be a body of their own.
    if (change.redraws || (change.touches && created.accepted)) {
        created.accepted.reset();
        created.problem = change.interpretation.problem;
    }
    if (created.accepted &&
        runsThrough(created.candidates[static_cast<std::size_t>(*created.accepted)],
                    options.bodies)) {
        askInstead(created, ", but it would run through the solid that is there");
    }
    if (!created.accepted && !change.redraws && isOutline(strokes, ink, options)) {
        created.problem = Error{Errc::FlatDrawing,
                                "This outline says where, not how deep; pull it (L), or draw one "
                                "line into the solid or out of it.",
                                {middleOf(strokes)}};
        return created;
    }
    if (created.candidates.empty() && !change.redraws && isCuttingLine(strokes)) {
        Interpretation split = readCuttingPlane(strokes, options);
        if (split.accepted) return offered(std::move(split));
    }
    return created;
}

/// What was told of more lines, or of one that is wrong, is the better answer.
bool mayBeGesture(const Interpretation& reading, const InterpretOptions& options) {
    if (!options.bodies.empty() && options.operation != Operation::Create) return false;
    if (reading.accepted || !reading.problem) return false;
    const auto open = {Errc::NoRegion, Errc::OpenEnd, Errc::FlatDrawing};
    return foundNothing(reading) ||
           std::find(open.begin(), open.end(), reading.problem->code) != open.end();
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
    if (options.operation == Operation::Split) {
        if (!options.bodies.empty()) return readCuttingPlane(strokes, options);
        out.problem = Error{Errc::OperationImpossible, "There is no solid to cut in two.", {}};
        return out;
    }
    bool changed = false;
    Interpretation reading = readDrawing(strokes, library, options, changed);
    const ReadAgain again = [&](const std::vector<Stroke>& others) {
        bool ignored = false;
        return readDrawing(others, library, options, ignored);
    };
    // Of lines that were cut in several ways no single one is the cause.
    if (!changed) findCause(strokes, library, options, again, reading);
    if (mayBeGesture(reading, options)) {
        const InkReading ink = readInk(strokes, options.thresholds.distancePx);
        if (auto gesture = readGesture(ink, options, readingAlone(library, options))) {
            reading = *std::move(gesture);
        }
    }
    if (!reading.accepted) tellProbabilitiesOfQuestion(reading.candidates);
    return reading;
}

}  // namespace ew
