// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/interpret.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "core/base/words.h"
#include "core/edge_graph/build.h"
#include "core/edge_graph/guide_lines.h"
#include "core/reading/evidence/hand_noise.h"
#include "core/reading/explain/causes.h"
#include "core/reading/explain/convergence.h"
#include "core/reading/propose/apart.h"
#include "core/reading/propose/cutting_plane.h"
#include "core/reading/propose/free_drawing.h"
#include "core/reading/propose/modification.h"
#include "core/reading/propose/profile.h"
#include "core/reading/propose/whole_drawing.h"
#include "core/reading/score/candidates.h"
#include "core/reading/score/picture_evidence.h"
#include "core/reading/score/probability.h"
#include "core/reading/types/reading_params.h"
#include "core/solid/boolean.h"
#include "core/solid/solid.h"
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

/// What was taken becomes a question.
/// \param but  what speaks against it, after "This could be a Cube"; may be empty.
void askInstead(Interpretation& reading, const std::string& but) {
    const auto best = static_cast<std::size_t>(*reading.accepted);
    const std::string name = withArticle(reading.candidates[best].templateName);
    Repair use;
    use.kind = Repair::Kind::UseCandidate;
    use.candidate = *reading.accepted;
    use.label = "Take it as " + name + " all the same";
    reading.repairs.push_back(std::move(use));
    std::vector<Vec2> where;
    for (const Junction& j : reading.graph.junctions) where.push_back(j.position);
    reading.problem =
        Error{Errc::Ambiguous, "This could be " + name + but + "; choose it, or draw on.",
              std::move(where)};
    reading.accepted.reset();
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

Interpretation wholeOf(WholeReading whole) {
    Interpretation read;
    read.graph = std::move(whole.graph);
    read.candidates = std::move(whole.candidates);
    read.accepted = 0;
    return read;
}

/// A solid that explains the drawing, but not without doubt.
Interpretation offeredWhole(WholeReading whole) {
    Interpretation read = wholeOf(std::move(whole));
    askInstead(read, "");
    return read;
}

/// A template with lines on it stays what was taken; a solid that has them as edges, but not
/// without doubt, stands behind it.
void offerToo(WholeReading whole, Interpretation& reading) {
    double left = 1.0;
    for (const Candidate& c : reading.candidates) left = std::max(0.0, left - c.probability);
    for (Candidate& c : whole.candidates) {
        // Their costs are not comparable: they have what the others leave.
        c.probability *= left;
        // The candidates speak of another graph.
        c.junctionVertex.assign(reading.graph.junctions.size(), -1);
        reading.candidates.push_back(std::move(c));
    }
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
        return offeredWhole(*std::move(whole));
    }
    // Who draws hidden lines means all other lines as edges, too.
    const bool partial = doubt.hidden && doubt.detailed;
    if (taken && (partial || (doubt.poor && explains))) askAboutLines(out);
    if (!taken || !explains) return out;
    offerToo(*std::move(whole), out);
    return out;
}

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
                           const InterpretOptions& options) {
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
        out.reading = readInFreeSpace(way.ink, library, options);
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

/// Lines that run past the corners, as guide lines do, read as the edges between these. What can
/// be trimmed to two solids at much the same cost is a question. Nothing where the drawing may
/// have other lines, too.
std::optional<Interpretation> readWithoutGuides(const InkReading& ink,
                                                const TemplateLibrary& library,
                                                const InterpretOptions& options) {
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
        TrimmedReading one = readTrimmed(way, library, options);
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

/// Strokes that can be read, as a drawing in free space or a change of the solids that are there.
/// \param trimmed  set where the lines were cut off at their corners first.
Interpretation readDrawing(const std::vector<Stroke>& strokes, const TemplateLibrary& library,
                           const InterpretOptions& options, bool& trimmed) {
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
        if (options.templateId.empty()) {
            const auto alone = [&](const InkReading& own) {
                Interpretation one = readInFreeSpace(own, library, options);
                askAboutPerspective(own, options.thresholds.distancePx, one);
                return one;
            };
            if (auto bodies = readApart(ink, options, alone)) return *std::move(bodies);
        }
        // First, for guide lines enclose much that is none of the solid's faces.
        auto edges = readWithoutGuides(ink, library, options);
        trimmed = edges.has_value();
        Interpretation created = edges ? *std::move(edges) : readInFreeSpace(ink, library, options);
        askAboutPerspective(ink, options.thresholds.distancePx, created);
        return created;
    }
    ModificationReading change = readModification(ink, library, options);
    if (!change.interpretation.candidates.empty() || options.operation != Operation::Auto) {
        if (!change.interpretation.accepted && options.operation == Operation::Auto) {
            offerCut(strokes, options, change.interpretation);
        }
        return std::move(change.interpretation);
    }
    Interpretation created = readFreeDrawing(ink, library, options);
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
    bool trimmed = false;
    Interpretation reading = readDrawing(strokes, library, options, trimmed);
    const ReadAgain again = [&](const std::vector<Stroke>& changed) {
        bool ignored = false;
        return readDrawing(changed, library, options, ignored);
    };
    // Of lines that were cut in several ways no single one is the cause.
    if (!trimmed) findCause(strokes, library, options, again, reading);
    if (!reading.accepted) tellProbabilitiesOfQuestion(reading.candidates);
    return reading;
}

}  // namespace ew
