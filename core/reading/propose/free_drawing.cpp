// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/free_drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/base/tolerance.h"
#include "core/edge_graph/build.h"
#include "core/edge_graph/canonical.h"
#include "core/edge_graph/edit.h"
#include "core/edge_graph/repair.h"
#include "core/reading/evidence/hand_noise.h"
#include "core/reading/evidence/ink_extent.h"
#include "core/reading/evidence/reading_price.h"
#include "core/reading/evidence/reading_tolerances.h"
#include "core/reading/explain/diagnose.h"
#include "core/reading/overlay/box_on_solid.h"
#include "core/reading/overlay/outline_reading.h"
#include "core/reading/score/candidates.h"
#include "core/reading/score/graph_reading.h"
#include "core/reading/score/ink_shares.h"
#include "core/reading/score/probability.h"
#include "core/reading/score/rivals.h"
#include "core/reading/types/reading_params.h"
#include "core/tlib/matcher.h"

namespace ew {
namespace {

class Pipeline {
  public:
    Pipeline(const InkReading& ink, const TemplateLibrary& library, const InterpretOptions& options)
        : library_(library),
          options_(options),
          ink_(ink),
          spreadPx_(std::max(tol::kSpreadPerWobble * ink_.wobblePx,
                             tol::kSpreadPerWobble / tol::kMissPerWobble *
                                 endSpread(ink_.segments, options.thresholds.distancePx))) {}

    Interpretation run() {
        buildReadings();
        context_.noisePx = commonNoise();
        context_.cornerPx = cornerSpread(ink_, options_.thresholds.distancePx, context_.noisePx);
        drawn_ = readings_;
        for (GraphReading& r : readings_) match(r, false);
        std::size_t best = 0;
        for (std::size_t i = 1; i < readings_.size(); ++i) {
            if (better(readings_[i], readings_[best])) best = i;
        }
        GraphReading chosen = readings_[best];
        const bool wasClear = chosen.clear;
        if (!chosen.clear || fitsPoorly(chosen.candidates.front())) tryOutlines(chosen, true);
        if (!chosen.clear || chosen.candidates.front().misfit > tol::kDoubtfulMisfit ||
            (!wasClear && rivalOf(chosen) != nullptr)) {
            tryRepairs(chosen);
            tryImperfect(chosen);
        }
        if (wasClear && !isBox(*chosen.candidates.front().entry)) tryOutlines(chosen, false);
        addRival(chosen);
        return conclude(chosen);
    }

  private:
    /// All graphs that the reading options lead to, each once.
    void buildReadings() {
        std::set<std::string> known;
        std::vector<ReadingOptions> ways = readingOptions();
        // Ruled lines meet where they end; what else is near is another place.
        if (ink_.wobblePx < tol::kRuledPx) ways.push_back({0.25, 0.4, 0.1});
        for (std::size_t i = 0; i < ways.size(); ++i) {
            for (EdgeGraph& graph :
                 buildEdgeGraphs(ink_, options_.thresholds.distancePx, ways[i])) {
                GraphReading r = read(std::move(graph));
                if (i > 0) r.price += tol::kSecondLookCost;
                const std::string key = canonicalForm(planeGraph(r.graph)).code + "/" +
                                        std::to_string(static_cast<int>(r.price));
                if (known.insert(key).second) readings_.push_back(std::move(r));
            }
        }
    }

    /// How far this hand's lines miss, told by the graph in which they miss least: a wrong graph
    /// makes a good hand look bad.
    double commonNoise() const {
        double noise = std::numeric_limits<double>::infinity();
        for (const GraphReading& r : readings_) {
            if (!r.graph.empty()) noise = std::min(noise, drawingNoisePx(r.graph));
        }
        const double hand = handNoisePx(ink_);
        return std::isfinite(noise) ? std::max(noise, hand) : std::max(1.0, hand);
    }

    GraphReading read(EdgeGraph graph) const {
        GraphReading r;
        const double distance = options_.thresholds.distancePx;
        std::vector<EdgeGraph> parts = connectedParts(graph);
        r.graph = std::move(parts.front());
        const double size = graphExtent(r.graph);
        for (std::size_t p = 1; p < parts.size(); ++p) {
            // A little closed loop beside the drawing is a slip of the pen, not a second drawing.
            if (graphExtent(parts[p]) > 0.2 * size) {
                r.otherParts.push_back(std::move(parts[p]));
            } else {
                for (const GraphEdge& e : parts[p].edges) {
                    r.graph.noise.push_back({NoiseKind::Stray,
                                             e.strokes.empty() ? -1 : e.strokes.front(),
                                             {e.tips[0], e.tips[1]}});
                }
            }
        }
        r.strayPrice = strayPrice(r.graph, distance);
        r.price = r.strayPrice + bentPrice(r.graph, ink_.wobblePx);
        return r;
    }

    void match(GraphReading& r, bool allowMissing) {
        MatchOptions m;
        m.distancePx = options_.thresholds.distancePx;
        m.templateId = options_.templateId;
        m.spreadPx = spreadPx_;
        m.allowMissing = allowMissing;
        std::vector<GraphMatch> found = matchGraph(r.graph, library_.index(), m);
        std::erase_if(found, [&](const GraphMatch& g) {
            return g.parallelDeg > options_.thresholds.angleDeg + 25;
        });
        if (found.size() > 8) found.resize(8);
        // Closed forms first: what they explain well the solver need not try.
        std::stable_partition(found.begin(), found.end(), [](const GraphMatch& g) {
            return g.entry->analysis.rectilinear.has_value();
        });
        for (const GraphMatch& g : found) addReadings(r, g);
        sortCandidates(r.candidates);
        judge(r);
    }

    void addReadings(GraphReading& r, const GraphMatch& match, bool interrupted = false) {
        context_.worthCost = worthCost_ - r.price;
        const auto graph = std::make_shared<const EdgeGraph>(r.graph);
        const std::size_t slipsBefore = r.slips.size();
        std::vector<RatedCandidate> read = readingsOf(r.graph, match, context_, r.slips);
        const double usual = isBox(*match.entry) ? 0.0 : tol::kBoxesAreUsual;
        for (std::size_t i = slipsBefore; i < r.slips.size(); ++i) {
            r.slips[i].cost += r.price + usual;
        }
        for (RatedCandidate& c : read) {
            c.candidate.extraEdges = r.extraEdges;
            c.interrupted = interrupted || match.aspect->edgeOn;
            c.graph = graph;
            c.cost += usual;
            if (match.aspect->edgeOn) c.cost += params::kEdgeOnCost;
            c.candidate.evidence.stray =
                r.price + std::max(0.0, unexplainedPrice(c) - r.strayPrice);
            c.cost += c.candidate.evidence.stray;
            if (r.extraEdges > 0) c.candidate.notes.emplace_back("One line too many was left out.");
            if (c.withinThresholds)
                worthCost_ = std::min(worthCost_, c.cost + 2 * tol::kClearMargin);
            r.candidates.push_back(std::move(c));
        }
    }

    /// Does the best candidate of a reading by outline leave little enough ink aside, and bare of
    /// ink little enough of its edges, to be taken by itself?
    bool outlineTells(const GraphReading& r) const {
        const RatedCandidate& best = r.candidates.front();
        // A careless hand retraces an edge farther off than its ends tell. A window or a label
        // says nothing against the solid.
        InkShares beside = shares(best, 1.0);
        if (!best.interrupted) beside.detail = 0.0;
        return r.price + (1 + tol::kBesideOutline) * priceOf(beside, 1.0) <=
               tol::kOutlineTells * (static_cast<double>(best.match.edge.size()) - 2.0);
    }

    /// A steady hand's ends say what they mean; a gap of it is to be told, not bridged.
    bool isSteady() const { return spreadPx_ < kUnsteadySpread * options_.thresholds.distancePx; }

    /// Aspects laid over the ink: where line ends joined wrongly, or lines that are none of the
    /// solid's cut its edges, the outline may still tell.
    /// \param all  every template, and also in the directions of the ink.
    void tryOutlines(GraphReading& best, bool all) {
        if (best.clear && isSteady()) return;
        const double distance = options_.thresholds.distancePx;
        const OutlineOptions o{
            distance, std::max(tol::kTurnExcuse * distance, tol::kTurnSpreads * spreadPx_), all};
        for (const auto& entry : library_.index().entries) {
            if (!options_.templateId.empty() && entry->tmpl.id != options_.templateId) continue;
            if (!all && !entry->analysis.rectilinear) continue;
            for (OutlineReading& laid : readingsByOutline(ink_, entry, o)) {
                const double gap = laid.widestGapPx;
                GraphReading r = readOutline(laid, best);
                if (r.candidates.empty()) continue;
                if (!r.clear || (isSteady() && gap > distance)) {
                    offered_.push_back(r);
                    if (!isSteady()) readings_.push_back(std::move(r));
                    continue;
                }
                if (better(r, best)) best = r;
                readings_.push_back(std::move(r));
            }
        }
    }

    GraphReading readOutline(OutlineReading& laid, const GraphReading& best) {
        GraphReading r;
        r.graph = std::move(laid.graph);
        r.graph.noise = ink_.noise;
        r.otherParts = best.otherParts;
        r.price = tol::kSecondLookCost + bentPrice(r.graph, ink_.wobblePx) +
                  tol::kExtraEdgeCost * laid.barePx / (4.0 * options_.thresholds.distancePx);
        addReadings(r, laid.match, laid.widestGapPx > options_.thresholds.distancePx);
        std::erase_if(r.candidates, [&](const RatedCandidate& c) { return leavesTooMuch(c); });
        // Ink beside an outline that was laid over it was drawn for something.
        for (RatedCandidate& c : r.candidates) {
            c.cost += tol::kBesideOutline * unexplainedPrice(c);
            c.outline = true;
        }
        sortCandidates(r.candidates);
        judge(r);
        r.clear = r.clear && outlineTells(r);
        return r;
    }

    /// Small corrections of the graph, as far as this hand's errors suggest them.
    void tryRepairs(GraphReading& best) {
        const double distance = options_.thresholds.distancePx;
        RepairOptions o;
        o.distancePx = distance;
        o.spreadPx = std::clamp(spreadPx_, 0.5, 0.5 * distance);
        const LibraryIndex& index = library_.index();
        o.known = [&index](const PlaneGraph& shape) {
            const CanonicalForm form = canonicalForm(shape);
            return !form.code.empty() && index.byCode.contains(form.code);
        };
        std::vector<GraphDraft> drafts;
        for (const DraftOptions& d : draftOptions()) {
            if (o.spreadPx < d.leastSpread * distance) continue;
            drafts.push_back(draftEdgeGraph(ink_, distance, d.reading));
            drafts.back().price = d.price;
        }
        // A crowded sheet is no rough drawing of one thing; the work for a state grows with the
        // square of its vertices.
        std::erase_if(drafts, [](const GraphDraft& d) { return d.raw.vertices.size() > 60; });
        for (const GraphDraft& d : drafts) {
            const std::size_t n = d.raw.vertices.size();
            o.maxStates = std::min(o.maxStates, 800000 / (n * n + 1));
        }
        for (RepairedGraph& repaired : repairedGraphs(ink_, drafts, o)) {
            GraphReading r = read(std::move(repaired.graph));
            r.extraEdges = repaired.dropped;
            r.price += repaired.price;
            match(r, false);
            if (r.candidates.empty()) continue;
            if (better(r, best)) best = r;
            readings_.push_back(std::move(r));
        }
    }

    /// \param share  how near ink must be to an edge [distance thresholds].
    InkShares shares(const RatedCandidate& c, double share = 0.5) const {
        return shareInk(ink_, c, nearPx(share), options_.thresholds.distancePx);
    }
    double nearPx(double share) const {
        const double distance = options_.thresholds.distancePx;
        // Whose lines end far from each other draws them beside where they are meant, too.
        const bool careless = context_.cornerPx > params::kCarelessCorner * distance;
        const double hand =
            careless ? std::hypot(context_.noisePx, context_.cornerPx) : context_.noisePx;
        return std::min(distance, std::max(share * distance, 3.0 * hand));
    }

    /// How near to an edge ink runs that was drawn for it. What a steady hand draws beside an edge
    /// is something else.
    double meantPx(const RatedCandidate& c) const {
        if (!isSteady()) return options_.thresholds.distancePx;
        const double hand = std::hypot(context_.noisePx, c.candidate.residualPx);
        return std::min(options_.thresholds.distancePx, params::kLeastBesidePx + 3.0 * hand);
    }

    /// Price of ink that runs along no edge of this candidate.
    double unexplainedPrice(const RatedCandidate& c, double share = 0.5) const {
        return priceOf(shares(c, share), c.interrupted ? 1.0 : params::kDetailShare);
    }

    double priceOf(const InkShares& ink, double detailShare) const {
        return tol::kExtraEdgeCost *
               (ink.stray + detailShare * ink.detail + params::kHiddenShare * ink.hidden) /
               (4.0 * options_.thresholds.distancePx);
    }

    /// Does this candidate leave more of the ink aside than a slip of the pen? The fewer edges
    /// it shows, the less it says that they fit.
    bool leavesTooMuch(const RatedCandidate& c) const {
        const InkShares ink = shares(c);
        const auto edges = static_cast<double>(c.match.aspect->graph.edges.size());
        const double limit =
            std::min(tol::kMostUnexplained, tol::kUnexplainedPerEdge * (edges - 2.0));
        const double beside = ink.stray + (c.interrupted ? ink.detail : 0.0);
        return beside > limit * (ink.edges + beside);
    }

    /// An edge too many or too few: each edge left out in turn, then aspects with one edge less.
    void tryImperfect(GraphReading& best) {
        std::size_t tried = 0;
        for (const GraphReading& base : readings_) {
            if (base.graph.edges.size() > 30 || base.graph.edges.size() < 5) continue;
            if (++tried > 3) break;
            for (std::size_t e = 0; e < base.graph.edges.size(); ++e) {
                GraphReading r;
                r.graph = withoutEdges(base.graph, {static_cast<int>(e)});
                if (r.graph.edges.size() < 5) continue;
                r.otherParts = base.otherParts;
                r.price = base.price + tol::kExtraEdgeCost;
                r.extraEdges = 1;
                match(r, false);
                if (better(r, best)) best = std::move(r);
            }
            GraphReading r;
            r.graph = base.graph;
            r.otherParts = base.otherParts;
            r.price = base.price;
            match(r, true);
            if (better(r, best)) best = std::move(r);
        }
    }

    /// Other graphs' candidates compete too: a different solid that explains the ink as well makes
    /// the choice the person's.
    const RatedCandidate* rivalOf(const GraphReading& best) const {
        if (best.candidates.empty()) return nullptr;
        const RatedCandidate& first = best.candidates.front();
        const RatedCandidate* rival = nullptr;
        for (const std::vector<GraphReading>* some : {&readings_, &offered_}) {
            for (const GraphReading& r : *some) {
                for (const RatedCandidate& other : r.candidates) {
                    if (isRival(first, other) && (rival == nullptr || other.cost < rival->cost)) {
                        rival = &other;
                    }
                }
            }
        }
        return rival;
    }

    void addRival(GraphReading& best) const {
        const RatedCandidate* other = rivalOf(best);
        if (other == nullptr) return;
        best.ambiguous = true;
        best.clear = false;
        RatedCandidate rival = *other;
        // Of two that fit poorly the plainer one is the better guess.
        if (rival.parameters < best.candidates.front().parameters &&
            (fitsPoorly(best.candidates.front()) || rival.match.aspect->edgeOn)) {
            rival.cost = std::min(rival.cost, best.candidates.front().cost - 1.0);
            rival.withinThresholds = true;
        }
        best.candidates.push_back(std::move(rival));
        sortCandidates(best.candidates);
    }

    /// Is there ink that the best candidate explains as missing although a line was begun there?
    static bool blockedByOpenEnd(const GraphReading& r) {
        if (r.candidates.empty() || r.graph.openEnds.empty()) return false;
        const RatedCandidate& best = r.candidates.front();
        return best.candidate.missingEdges > 0 || best.outline;
    }

    /// Is all that was drawn one outline? No solid is seen so; that it could be one from some side
    /// is no reason to make it.
    bool isFlat() const {
        const auto curved = [](const NoiseItem& n) { return n.kind == NoiseKind::Curve; };
        if (std::any_of(ink_.noise.begin(), ink_.noise.end(), curved)) return false;
        const auto open = [](const GraphReading& r) {
            return !r.otherParts.empty() || (!r.graph.empty() && !isOneOutline(r.graph)) ||
                   !r.graph.dangling.empty();
        };
        return std::none_of(drawn_.begin(), drawn_.end(), open) &&
               std::any_of(drawn_.begin(), drawn_.end(),
                           [](const GraphReading& r) { return isOneOutline(r.graph); });
    }

    /// Do all other connected drawings lie inside faces of the best candidate, as a window or a
    /// label does?
    bool othersAreDetail(const GraphReading& best) const {
        if (best.otherParts.empty()) return true;
        const InkShares ink = shares(best.candidates.front());
        return ink.stray <= options_.thresholds.distancePx && !best.candidates.front().interrupted;
    }

    Interpretation conclude(GraphReading& best) {
        const bool nothing = best.candidates.empty();
        const bool blocked = blockedByOpenEnd(best);
        offerOutlines(best);
        addNamedReadings(best.candidates, context_);
        sortCandidates(best.candidates);
        Findings findings;
        findings.onlyOutlines = nothing && !best.candidates.empty();
        findings.candidates = &best.candidates;
        findings.otherParts = best.otherParts;
        findings.ambiguous = best.ambiguous;
        findings.blockedByOpenEnd = blocked;

        Interpretation out;
        out.graph = best.graph;
        const double least = best.candidates.empty() ? 0.0 : best.candidates.front().cost;
        const double distance = options_.thresholds.distancePx;
        for (const RatedCandidate& c : best.candidates) {
            if (static_cast<int>(out.candidates.size()) >= options_.maxCandidates) break;
            out.candidates.push_back(c.candidate);
            Evidence& evidence = out.candidates.back().evidence;
            evidence.prior = 0.0;
            evidence.prior = c.cost - evidence.cost();
            out.candidates.back().unusedStrokes = strokesBeside(ink_, c, meantPx(c), distance);
            const double off = c.candidate.residualPx / distance;
            const double quality = std::exp(-2.0 * off * off) *
                                   std::pow(0.9, c.candidate.missingEdges + c.candidate.extraEdges);
            out.candidates.back().score =
                out.candidates.size() == 1
                    ? quality
                    : std::min(quality, out.candidates.front().score *
                                            std::exp(-std::max(0.0, c.cost - least) / 30.0));
        }
        const double inkPx = inkLengthPx(ink_);
        findings.slip = likeliestSlip(readings_, best, inkPx);
        if (findings.slip != nullptr) best.clear = false;
        out.slip = likeliestSlip(readings_, best, inkPx, true) != nullptr;
        tellProbabilities(out.candidates, out.graph.edges.size(),
                          findings.slip == nullptr ? std::numeric_limits<double>::infinity()
                                                   : findings.slip->cost);
        if (best.clear && leavesTooMuch(best.candidates.front())) {
            best.clear = false;
            findings.leavesInk = true;
        }
        findings.twoFaces =
            !best.candidates.empty() && best.candidates.front().match.aspect->edgeOn;
        if (best.clear &&
            isAbsurd(best.candidates.front(), std::hypot(context_.noisePx, context_.cornerPx),
                     distance, options_.camera.worldPerPixel)) {
            best.clear = false;
            findings.absurd = true;
        }
        findings.flat = isFlat();
        if (best.clear && looksAccidental(best.candidates.front())) {
            best.clear = false;
            findings.accidental = true;
        }
        if (findings.flat) out.candidates.clear();
        if (best.clear && !findings.flat && othersAreDetail(best) && !findings.blockedByOpenEnd) {
            out.accepted = 0;
        } else {
            explain(out, findings, library_, options_);
        }
        return out;
    }

    /// What outlines suggest joins what the graph does, where nothing was clear enough to be taken.
    void offerOutlines(GraphReading& best) {
        if (best.clear) return;
        constexpr std::size_t kMostOffered = 3;
        std::vector<RatedCandidate> all;
        for (const GraphReading& r : offered_) all.push_back(r.candidates.front());
        sortCandidates(all);
        for (std::size_t i = 0; i < std::min(kMostOffered, all.size()); ++i) {
            const bool known = std::any_of(
                best.candidates.begin(), best.candidates.end(), [&](const RatedCandidate& c) {
                    return c.candidate.templateId == all[i].candidate.templateId &&
                           c.withinThresholds && c.cost <= all[i].cost;
                });
            if (!known) best.candidates.push_back(all[i]);
        }
        sortCandidates(best.candidates);
    }

    const TemplateLibrary& library_;
    const InterpretOptions& options_;
    const InkReading& ink_;
    double spreadPx_;  ///< how far this hand's line ends miss each other, per axis
    ReadingContext context_{options_};
    double worthCost_ = std::numeric_limits<double>::infinity();
    std::vector<GraphReading> readings_;
    std::vector<GraphReading> drawn_;    ///< those by line ends alone, unmatched
    std::vector<GraphReading> offered_;  ///< too doubtful to say more than the graph does
};

}  // namespace

Interpretation readFreeDrawing(const InkReading& ink, const TemplateLibrary& library,
                               const InterpretOptions& options) {
    return Pipeline(ink, library, options).run();
}

}  // namespace ew
