// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/modeling/free_drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/base/tolerance.h"
#include "core/edge_graph/build.h"
#include "core/edge_graph/canonical.h"
#include "core/edge_graph/edit.h"
#include "core/edge_graph/repair.h"
#include "core/modeling/accidental.h"
#include "core/modeling/box_on_solid.h"
#include "core/modeling/candidates.h"
#include "core/modeling/diagnose.h"
#include "core/modeling/ink_on_solid.h"
#include "core/modeling/outline_reading.h"
#include "core/modeling/reading_price.h"
#include "core/tlib/matcher.h"

namespace ew {
namespace {

/// One way to read the strokes, with what it leads to.
struct Reading {
    EdgeGraph graph;
    std::vector<EdgeGraph> otherParts;
    std::vector<RatedCandidate> candidates;  ///< best first
    std::optional<Vec2> impossibleCorner;
    int extraEdges = 0;
    double price = 0.0;  ///< of the graph: ink dropped or bent straight, second looks, extra edges
    double strayPrice = 0.0;  ///< ... that part of it which is for ink dropped
    double cost = 0.0;        ///< of the best candidate, price included
    bool clear = false;
    bool ambiguous = false;
};

/// Tolerances to try, the plain ones first. None joins ends at a corner from farther than the
/// distance threshold; only a gap inside an edge may be wider.
const std::vector<ReadingOptions>& readingOptions() {
    static const std::vector<ReadingOptions> kOptions{
        {},
        {1.0, 0.6, 0.4},
        {0.72, 0.8, 0.4},
        {1.0, 1.3, 0.7},
        {1.0, 1.0, 0.1},
        {0.72, 0.6, 0.2},
        {0.85, 1.0, 0.7},
        {0.55, 0.6, 0.2},
        {1.0, 1.0, 0.4, 2.2},
        {0.8, 0.8, 0.4, 2.2},
    };
    return kOptions;
}

/// Where the search for repairs starts from.
struct DraftOptions {
    ReadingOptions reading;
    double price = 0.0;
    double leastSpread = 0.0;  ///< for hands that miss by that much only [distance thresholds]
};
const std::vector<DraftOptions>& draftOptions() {
    static const std::vector<DraftOptions> kOptions{
        {{}},
        {{1.0, 1.3, 0.7}, tol::kSecondLookCost},
        {{0.72, 0.6, 0.2}, tol::kSecondLookCost},
        {{1.0, 1.6, 0.7}, 2 * tol::kSecondLookCost, kUnsteadySpread},
        {{1.4, 1.0, 0.4, 1.8}, 4 * tol::kSecondLookCost, 0.25},
    };
    return kOptions;
}

/// How much dearer the next different candidate must be. A drawing with a line too many or too few
/// could have been meant as something else altogether.
double clearMargin(const Candidate& best) {
    return best.missingEdges + best.extraEdges > 0 ? tol::kClearMarginImperfect : tol::kClearMargin;
}

/// Is the best candidate clear enough to be taken by itself?
void judge(Reading& r) {
    if (r.candidates.empty()) return;
    const RatedCandidate& best = r.candidates.front();
    r.cost = best.cost;
    const double margin = clearMargin(best.candidate);
    for (const RatedCandidate& other : r.candidates) {
        if (best.candidate.templateId != other.candidate.templateId && other.withinThresholds &&
            other.cost < best.cost + margin) {
            r.ambiguous = true;
        }
    }
    r.clear = best.withinThresholds && !r.ambiguous;
}

void sortCandidates(std::vector<RatedCandidate>& candidates) {
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const RatedCandidate& a, const RatedCandidate& b) {
                         if (a.withinThresholds != b.withinThresholds) return a.withinThresholds;
                         return a.cost < b.cost;
                     });
}

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
        for (Reading& r : readings_) match(r, false);
        std::size_t best = 0;
        for (std::size_t i = 1; i < readings_.size(); ++i) {
            if (better(readings_[i], readings_[best])) best = i;
        }
        Reading chosen = readings_[best];
        const bool wasClear = chosen.clear;
        if (!chosen.clear) tryOutlines(chosen);
        if (!chosen.clear || chosen.candidates.front().misfit > tol::kDoubtfulMisfit ||
            (!wasClear && rivalOf(chosen) != nullptr)) {
            tryRepairs(chosen);
            tryImperfect(chosen);
        }
        if (wasClear && !isBox(*chosen.candidates.front().entry)) tryOutlines(chosen);
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
                Reading r = read(std::move(graph));
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
        for (const Reading& r : readings_) {
            if (!r.graph.empty()) noise = std::min(noise, drawingNoisePx(r.graph));
        }
        const double hand = handNoisePx(ink_);
        return std::isfinite(noise) ? std::max(noise, hand) : std::max(1.0, hand);
    }

    static bool better(const Reading& a, const Reading& b) {
        if (a.candidates.empty()) return false;
        if (b.candidates.empty()) return true;
        const bool withinA = a.candidates.front().withinThresholds;
        const bool withinB = b.candidates.front().withinThresholds;
        if (withinA != withinB) return withinA;
        return a.cost < b.cost;
    }

    Reading read(EdgeGraph graph) const {
        Reading r;
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

    void match(Reading& r, bool allowMissing) {
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

    void addReadings(Reading& r, const GraphMatch& match) {
        context_.worthCost = worthCost_ - r.price;
        for (RatedCandidate& c : readingsOf(r.graph, match, context_, r.impossibleCorner)) {
            c.candidate.extraEdges = r.extraEdges;
            if (!isBox(*c.entry)) c.cost += tol::kBoxesAreUsual;
            c.cost += r.price + std::max(0.0, unexplainedPrice(c) - r.strayPrice);
            if (r.extraEdges > 0) c.candidate.notes.emplace_back("One line too many was left out.");
            if (c.withinThresholds)
                worthCost_ = std::min(worthCost_, c.cost + 2 * tol::kClearMargin);
            r.candidates.push_back(std::move(c));
        }
    }

    /// Does the best candidate of a reading by outline leave little enough ink aside, and bare of
    /// ink little enough of its edges, to be taken by itself?
    bool outlineTells(const Reading& r) const {
        const RatedCandidate& best = r.candidates.front();
        // A careless hand retraces an edge farther off than its ends tell.
        return r.price + (1 + tol::kBesideOutline) * unexplainedPrice(best, 1.0) <=
               tol::kOutlineTells * (static_cast<double>(best.match.edge.size()) - 2.0);
    }

    /// Aspects laid over the ink: where line ends joined wrongly the outline may still tell.
    void tryOutlines(Reading& best) {
        const double distance = options_.thresholds.distancePx;
        // A steady hand's ends say what they mean; a gap of it is to be told, not bridged.
        if (spreadPx_ < kUnsteadySpread * distance) return;
        const OutlineOptions o{
            distance, std::max(tol::kTurnExcuse * distance, tol::kTurnSpreads * spreadPx_)};
        for (const auto& entry : library_.index().entries) {
            if (!options_.templateId.empty() && entry->tmpl.id != options_.templateId) continue;
            if (best.clear && !entry->analysis.rectilinear) continue;
            for (OutlineReading& laid : readingsByOutline(ink_, entry, o)) {
                Reading r;
                r.graph = std::move(laid.graph);
                r.graph.noise = ink_.noise;
                r.otherParts = best.otherParts;
                r.price = tol::kSecondLookCost + bentPrice(r.graph, ink_.wobblePx) +
                          tol::kExtraEdgeCost * laid.barePx / (4.0 * distance);
                addReadings(r, laid.match);
                std::erase_if(r.candidates,
                              [&](const RatedCandidate& c) { return leavesTooMuch(c); });
                // Ink beside an outline that was laid over it was drawn for something.
                for (RatedCandidate& c : r.candidates)
                    c.cost += tol::kBesideOutline * unexplainedPrice(c);
                sortCandidates(r.candidates);
                judge(r);
                r.clear = r.clear && outlineTells(r);
                if (r.candidates.empty()) continue;
                if (better(r, best)) best = r;
                readings_.push_back(std::move(r));
            }
        }
    }

    /// Small corrections of the graph, as far as this hand's errors suggest them.
    void tryRepairs(Reading& best) {
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
            Reading r = read(std::move(repaired.graph));
            r.extraEdges = repaired.dropped;
            r.price += repaired.price;
            match(r, false);
            if (r.candidates.empty()) continue;
            if (better(r, best)) best = r;
            readings_.push_back(std::move(r));
        }
    }

    /// Length of the ink that runs far from every edge of this candidate: it meant something else
    /// [px].
    double unexplainedPx(const RatedCandidate& c, double share = 0.5) const {
        const double distance = options_.thresholds.distancePx;
        const double near = std::min(distance, std::max(share * distance, 3.0 * context_.noisePx));
        double length = 0;
        for (const Segment& s : ink_.segments) {
            std::size_t far = 0;
            for (const Vec2& p : s.points) {
                const bool explained =
                    std::any_of(c.match.edge.begin(), c.match.edge.end(), [&](int e) {
                        const auto& ends =
                            c.entry->analysis.edges[static_cast<std::size_t>(e)].ends;
                        const Vec2 a = c.drawn[static_cast<std::size_t>(ends[0])].head<2>();
                        const Vec2 b = c.drawn[static_cast<std::size_t>(ends[1])].head<2>();
                        // Overshoot is no other line.
                        return distanceToSegment(p, a, b, distance) <= near;
                    });
                if (!explained) ++far;
            }
            length += s.inkPx * static_cast<double>(far) / static_cast<double>(s.points.size());
        }
        return length;
    }

    double unexplainedPrice(const RatedCandidate& c, double share = 0.5) const {
        return tol::kExtraEdgeCost * unexplainedPx(c, share) /
               (4.0 * options_.thresholds.distancePx);
    }

    /// Does this candidate leave more of the ink aside than a slip of the pen? The fewer edges
    /// it shows, the less it says that they fit.
    bool leavesTooMuch(const RatedCandidate& c) const {
        double all = 0;
        for (const Segment& s : ink_.segments) all += s.inkPx;
        const auto edges = static_cast<double>(c.match.aspect->graph.edges.size());
        const double limit =
            std::min(tol::kMostUnexplained, tol::kUnexplainedPerEdge * (edges - 2.0));
        return unexplainedPx(c) > limit * all;
    }

    /// An edge too many or too few: each edge left out in turn, then aspects with one edge less.
    void tryImperfect(Reading& best) {
        std::size_t tried = 0;
        for (const Reading& base : readings_) {
            if (base.graph.edges.size() > 30 || base.graph.edges.size() < 5) continue;
            if (++tried > 3) break;
            for (std::size_t e = 0; e < base.graph.edges.size(); ++e) {
                Reading r;
                r.graph = withoutEdges(base.graph, {static_cast<int>(e)});
                if (r.graph.edges.size() < 5) continue;
                r.otherParts = base.otherParts;
                r.price = base.price + tol::kExtraEdgeCost;
                r.extraEdges = 1;
                match(r, false);
                if (better(r, best)) best = std::move(r);
            }
            Reading r;
            r.graph = base.graph;
            r.otherParts = base.otherParts;
            r.price = base.price;
            match(r, true);
            if (better(r, best)) best = std::move(r);
        }
    }

    /// Other graphs' candidates compete too: a different solid that explains the ink as well makes
    /// the choice the person's.
    const RatedCandidate* rivalOf(const Reading& best) const {
        if (best.candidates.empty()) return nullptr;
        const RatedCandidate& first = best.candidates.front();
        for (const Reading& r : readings_) {
            if (r.candidates.empty()) continue;
            const RatedCandidate& other = r.candidates.front();
            if (other.withinThresholds && other.cost < first.cost + clearMargin(first.candidate) &&
                other.candidate.templateId != first.candidate.templateId) {
                return &other;
            }
        }
        return nullptr;
    }

    void addRival(Reading& best) const {
        const RatedCandidate* other = rivalOf(best);
        if (other == nullptr) return;
        best.ambiguous = true;
        best.clear = false;
        best.candidates.push_back(*other);
        sortCandidates(best.candidates);
    }

    /// Is there ink that the best candidate explains as missing although a line was begun there?
    static bool blockedByOpenEnd(const Reading& r) {
        return !r.candidates.empty() && r.candidates.front().candidate.missingEdges > 0 &&
               !r.graph.openEnds.empty();
    }

    void addNamedReadings(Reading& r) {
        if (r.candidates.empty()) return;
        const RatedCandidate base = r.candidates.front();
        if (base.entry->tmpl.readings.empty()) return;
        for (RatedCandidate& c : namedReadings(r.graph, base, context_)) {
            r.candidates.push_back(std::move(c));
        }
        sortCandidates(r.candidates);
    }

    static bool looksAccidental(const RatedCandidate& c) {
        return hidesItsTaper(*c.entry, *c.match.aspect, c.drawn);
    }

    Interpretation conclude(Reading& best) {
        addNamedReadings(best);
        Findings findings;
        findings.candidates = &best.candidates;
        findings.impossibleCorner = best.impossibleCorner;
        findings.otherParts = best.otherParts;
        findings.ambiguous = best.ambiguous;
        findings.blockedByOpenEnd = blockedByOpenEnd(best);

        Interpretation out;
        out.graph = best.graph;
        const double least = best.candidates.empty() ? 0.0 : best.candidates.front().cost;
        for (const RatedCandidate& c : best.candidates) {
            if (static_cast<int>(out.candidates.size()) >= options_.maxCandidates) break;
            out.candidates.push_back(c.candidate);
            const double off = c.candidate.residualPx / options_.thresholds.distancePx;
            const double quality = std::exp(-2.0 * off * off) *
                                   std::pow(0.9, c.candidate.missingEdges + c.candidate.extraEdges);
            out.candidates.back().score =
                out.candidates.size() == 1
                    ? quality
                    : std::min(quality, out.candidates.front().score *
                                            std::exp(-std::max(0.0, c.cost - least) / 30.0));
        }
        if (best.clear && leavesTooMuch(best.candidates.front())) {
            best.clear = false;
            findings.leavesInk = true;
        }
        if (best.clear && looksAccidental(best.candidates.front())) {
            best.clear = false;
            findings.accidental = true;
        }
        if (best.clear && best.otherParts.empty() && !findings.blockedByOpenEnd) {
            out.accepted = 0;
        } else {
            explain(out, findings, library_, options_);
        }
        return out;
    }

    const TemplateLibrary& library_;
    const InterpretOptions& options_;
    const InkReading& ink_;
    double spreadPx_;  ///< how far this hand's line ends miss each other, per axis
    ReadingContext context_{options_};
    double worthCost_ = std::numeric_limits<double>::infinity();
    std::vector<Reading> readings_;
};

}  // namespace

Interpretation readFreeDrawing(const InkReading& ink, const TemplateLibrary& library,
                               const InterpretOptions& options) {
    return Pipeline(ink, library, options).run();
}

}  // namespace ew
