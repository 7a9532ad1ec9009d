// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/whole_drawing.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "core/base/tolerance.h"
#include "core/edge_graph/edit.h"
#include "core/edge_graph/wire_graph.h"
#include "core/reading/evidence/hand_noise.h"
#include "core/reading/extract/axis_frames.h"
#include "core/reading/extract/wire_drawing.h"
#include "core/reading/propose/polyhedron_proposals.h"
#include "core/reading/propose/prism_proposals.h"
#include "core/reading/propose/pyramid_proposals.h"
#include "core/reading/propose/shape_solver.h"
#include "core/reading/propose/wire_proposals.h"
#include "core/reading/score/candidates.h"
#include "core/reading/score/probability.h"
#include "core/reading/types/reading_params.h"
#include "core/tlib/library_index.h"

namespace ew {
namespace {

class WholeReader {
  public:
    WholeReader(const InkReading& ink, const TemplateLibrary& library,
                const InterpretOptions& options)
        : ink_(ink),
          options_(options),
          solver_(ink, library, options),
          wireSolver_(ink, library, options),
          crosses_(crossesLikeWires(ink, options.thresholds.distancePx)) {}

    WholeReading run() {
        std::vector<SolvedShape> found;
        for (const double distance : joinDistances()) {
            readAt(distance, found);
            std::stable_sort(
                found.begin(), found.end(),
                [](const SolvedShape& a, const SolvedShape& b) { return a.cost < b.cost; });
            dropAlike(found);
            if (!found.empty() && isClear(found)) break;
        }
        WholeReading out;
        if (found.empty()) return out;
        out.clear = isClear(found);
        out.residue = found.front().evidence.residue();
        out.graph = *found.front().graph;
        out.isKnown = found.front().known;
        for (SolvedShape& s : found) {
            if (s.graph != found.front().graph) s.candidate.junctionVertex.clear();
            s.candidate.junctionVertex.resize(out.graph.junctions.size(), -1);
            Evidence& evidence = s.candidate.evidence;
            evidence.prior = s.cost - evidence.cost();
            out.candidates.push_back(std::move(s.candidate));
            if (static_cast<int>(out.candidates.size()) == options_.maxCandidates) break;
        }
        tellProbabilities(out.candidates, out.graph.edges.size());
        return out;
    }

  private:
    static constexpr std::size_t kFewestLines = 6;
    static constexpr double kSteadyDeg = 1.2;  ///< lines of a steady hand turn by no more
    static constexpr int kManyLines = 16;
    static constexpr std::size_t kMostFrames = 6;
    static constexpr int kMostFramesTried = 16;  ///< of all graphs
    static constexpr double kSureFrame = 0.9;    ///< share of the lines along an axis
    static constexpr double kLikelyFrame = 0.7;  ///< that share, as one of the likeliest frame's

    /// How near ends count as meeting: a steady hand's corners lie together, and what it draws
    /// close to one another are two places.
    std::vector<double> joinDistances() const {
        const double usual = options_.thresholds.distancePx;
        constexpr double kSpreads = 4.0;
        constexpr double kLeastPx = 4.0;
        const double steady = std::max(kLeastPx, kSpreads * endSpread(ink_.segments, usual));
        if (steady > 0.8 * usual) return {usual};
        return {steady, usual};
    }

    void readAt(double distance, std::vector<SolvedShape>& found) {
        for (EdgeGraph& wires : buildWireGraphs(ink_, distance)) {
            if (addWires(std::move(wires), found)) return;
        }
        // No solid looks like this with its hidden edges left out.
        if (crosses_) return;
        for (const EdgeGraph& whole : buildEdgeGraphs(ink_, distance)) {
            if (whole.empty()) continue;
            std::vector<EdgeGraph> parts = connectedParts(whole);
            if (parts.front().edges.size() < kFewestLines) continue;
            add(EdgeGraph(parts.front()), true, found);
            // One closed line is no body, and no part of one.
            std::erase_if(parts, isOneOutline);
            if (parts.size() > 1) add(joinedParts(parts), false, found);
        }
    }

    /// \param alone  the graph is connected, and may be one of a family.
    void add(EdgeGraph&& graph, bool alone, std::vector<SolvedShape>& found) {
        const auto shared = std::make_shared<const EdgeGraph>(std::move(graph));
        const double price = bends(*shared);
        for (SolvedShape& s : read(*shared, alone)) {
            s.cost += price;
            s.graph = shared;
            found.push_back(std::move(s));
        }
    }

    /// What lines that stray from their edges cost: each correlation length of ink is a sample.
    double bends(const EdgeGraph& graph) const {
        const double usual = std::max(params::kLeastWobblePx, 1.3 * ink_.wobblePx);
        double price = 0.0;
        for (const GraphEdge& e : graph.edges) {
            const double excess = e.wobblePx * e.wobblePx / (usual * usual) - 1.0;
            if (excess > 0.0) price += excess * e.inkPx / tol::kWobbleCorrelationPx;
        }
        return price;
    }

    std::vector<SolvedShape> read(const EdgeGraph& graph, bool alone) {
        solver_.begin(graph);
        const LineDrawing drawing = lineDrawing(graph, params::kStraightDeg);
        std::vector<SolvedShape> found = read(graph, drawing, alone);
        // What looks like a line that ends behind another one may be a corner of a steady hand, as
        // where the slope of a gable runs nearly along the ridge.
        const double steadyDeg = straightDeg(graph);
        if (steadyDeg > kSteadyDeg) return found;
        const LineDrawing steady = lineDrawing(graph, steadyDeg);
        if (!differ(drawing, steady)) return found;
        for (SolvedShape& s : read(graph, steady, alone)) found.push_back(std::move(s));
        return found;
    }

    /// How far straight lines of this hand turn, standard deviation; 1 to kStraightDeg [degrees].
    double straightDeg(const EdgeGraph& graph) const {
        constexpr double kLeastDeg = 1.0;
        double px = 0.0;
        for (const GraphEdge& e : graph.edges) px += e.inkPx;
        const double mean = px / static_cast<double>(std::max<std::size_t>(1, graph.edges.size()));
        const double noise = drawnNoisePx(graph, ink_);
        const double turn = std::atan2(std::numbers::sqrt2 * noise, std::max(mean, 1.0));
        return std::clamp(turn * 180.0 / std::numbers::pi, kLeastDeg, params::kStraightDeg);
    }

    /// Do lines end behind others, or faces have corners, in one and not in the other?
    static bool differ(const LineDrawing& a, const LineDrawing& b) {
        const auto stems = [](const LineDrawing::Node& x, const LineDrawing::Node& y) {
            return x.stem == y.stem;
        };
        const auto corners = [](const LineDrawing::Region& x, const LineDrawing::Region& y) {
            return x.corners == y.corners;
        };
        return !std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(), stems) ||
               !std::equal(a.regions.begin(), a.regions.end(), b.regions.begin(), b.regions.end(),
                           corners);
    }

    std::vector<SolvedShape> read(const EdgeGraph& graph, const LineDrawing& drawing, bool alone) {
        std::vector<SolvedShape> found;
        if (alone) {
            const auto families = familyProposals(drawing, solver_.spread());
            if (solver_.solveAll(families, drawing, 0, found)) return found;
        }
        for (const double spread : solver_.spreads()) {
            const std::vector<AxisFrame> frames = axisFrames(drawing, spread, kMostFrames);
            for (const AxisFrame& frame : frames) {
                if (frame.share < kLikelyFrame * frames.front().share) continue;
                if (framesTried_++ == kMostFramesTried) return found;
                const std::vector<ShapeHypothesis> proposals =
                    polyhedronProposals(drawing, frame, spread);
                const bool explained = solver_.solveAll(proposals, drawing, lifts_, found);
                if (!proposals.empty()) lifts_ += proposals.back().lift + 1;
                // Slanted lines fit more than one frame.
                if (explained && frame.share > kSureFrame) return found;
            }
        }
        return found;
    }

    static std::vector<ShapeHypothesis> familyProposals(const LineDrawing& drawing,
                                                        double spreadPx) {
        std::vector<ShapeHypothesis> out = prismProposals(drawing, spreadPx);
        for (ShapeHypothesis& h : pyramidProposals(drawing, spreadPx)) out.push_back(std::move(h));
        return out;
    }

    /// All edges may be drawn, hidden ones, too.
    /// \return does a solid explain the ink?
    bool addWires(EdgeGraph&& graph, std::vector<SolvedShape>& found) {
        const auto wires = wireDrawing(graph);
        if (!wires) return false;
        const auto shared = std::make_shared<const EdgeGraph>(std::move(graph));
        wireSolver_.begin(*shared);
        bool explained = false;
        for (SolvedShape& s : readWires(*wires)) {
            explained = explained || s.explains();
            s.cost += bends(*shared);
            s.graph = shared;
            found.push_back(std::move(s));
        }
        return explained;
    }

    std::vector<SolvedShape> readWires(const LineDrawing& wires) {
        std::vector<SolvedShape> found = tryWires(wires);
        // Of an exact drawing nothing counts that is only like it.
        if (wireSolver_.isExact()) {
            std::erase_if(found, [&](const SolvedShape& s) {
                return s.candidate.residualPx > params::kExactPx;
            });
        }
        return found;
    }

    std::vector<SolvedShape> tryWires(const LineDrawing& wires) {
        ShapeSolver& solver = wireSolver_;
        std::vector<SolvedShape> found;
        std::vector<ShapeHypothesis> families = familyProposals(wires, solver.spread());
        preferFromAbove(families);
        if (solver.solveAll(families, wires, 0, found) && !solver.mayBeNearer()) return found;
        for (const double spread : solver.spreads()) {
            for (const AxisFrame& frame : axisFrames(wires, spread, kMostFrames)) {
                std::vector<ShapeHypothesis> proposals = wireProposals(wires, frame, spread);
                preferFromAbove(proposals);
                const bool explained = solver.solveAll(proposals, wires, 0, found);
                if (explained && frame.share > kSureFrame && !solver.mayBeNearer()) return found;
            }
        }
        return found;
    }

    static void preferFromAbove(std::vector<ShapeHypothesis>& proposals) {
        for (ShapeHypothesis& h : proposals) h.price += params::kFromBelowCost * seenFromBelow(h);
    }

    /// One reading of each solid: every face of a box may be the base.
    static void dropAlike(std::vector<SolvedShape>& found) {
        std::vector<SolvedShape> kept;
        for (SolvedShape& s : found) {
            const double same = s.exact ? params::kSameExactVolume : params::kSameVolume;
            const auto alike = std::find_if(kept.begin(), kept.end(), [&](const SolvedShape& k) {
                const bool counts = k.solid.vertices().size() == s.solid.vertices().size() &&
                                    k.solid.edges().size() == s.solid.edges().size();
                const bool volume = std::abs(k.solid.volume() / s.solid.volume() - 1.0) < same;
                return counts && (volume || isPlainer(s, k));
            });
            if (alike == kept.end()) {
                kept.push_back(std::move(s));
            } else if (isPlainer(s, *alike)) {
                s.cost = alike->cost;
                *alike = std::move(s);
            }
        }
        found = std::move(kept);
    }

    /// Is the one of a family, where the other one is no more than a solid that looks like it?
    static bool isPlainer(const SolvedShape& s, const SolvedShape& than) {
        return s.family && !than.family && s.explains() && !s.exact &&
               s.cost < than.cost + params::kWholeMargin;
    }

    /// A prism, pyramid or frustum that has every line and all of the ink.
    static bool isSure(const SolvedShape& s) {
        return s.family && s.misfit <= params::kSureMisfit &&
               s.evidence.residue() <= params::kSureResidue;
    }

    /// Do two readings differ in what is not seen alone?
    static bool looksAlike(const SolvedShape& a, const SolvedShape& b) {
        return a.lift == b.lift && a.lift >= 0;
    }

    /// Does the first one explain the ink, and no other as well at much the same cost?
    bool isClear(const std::vector<SolvedShape>& found) const {
        if (found.front().evidence.residue() > params::kWholeResidue) return false;
        if (found.front().misfit > params::kWholeMisfit) return false;
        // An unsteady hand's few lines fit many solids, and a corner that hardly stands out may be
        // none: what is of no family is not taken then, and of a family what is far from others.
        // One that does not stand out at all is none.
        const bool unsteady = endSpread(ink_.segments, options_.thresholds.distancePx) >
                              kUnsteadySpread * options_.thresholds.distancePx;
        const bool few = unsteady && found.front().lines < kManyLines;
        const bool faint = found.front().leastCorner < params::kFaintCorner;
        const bool doubtful = few || faint;
        if (doubtful && !isSure(found.front())) return false;
        if (!found.front().exact && found.front().leastCorner < params::kNoCorner) return false;
        if (found.front().guessed || found.front().tiny) return false;
        return std::none_of(found.begin() + 1, found.end(), [&](const SolvedShape& other) {
            double margin = params::kWholeMargin;
            if (found.front().exact) margin = params::kExactMargin;
            if (looksAlike(found.front(), other)) margin = params::kCompletionMargin;
            if (doubtful) margin *= params::kDoubtfulMargins;
            return other.evidence.residue() <= params::kOtherResidue &&
                   other.cost < found.front().cost + margin;
        });
    }

    const InkReading& ink_;
    const InterpretOptions& options_;
    ShapeSolver solver_;      ///< of drawings whose hidden lines are left out
    ShapeSolver wireSolver_;  ///< of those that show them
    bool crosses_ = false;    ///< lines cross as hidden edges do
    int framesTried_ = 0;
    int lifts_ = 0;  ///< numbers of ShapeHypothesis::lift of frames before
};

}  // namespace

std::size_t mostLines(const TemplateLibrary& library) {
    std::size_t most = 0;
    for (const auto& entry : library.index().entries) {
        for (const Aspect& a : entry->aspects) most = std::max(most, a.graph.edges.size());
    }
    return most;
}

WholeReading readWholeDrawing(const InkReading& ink, const TemplateLibrary& library,
                              const InterpretOptions& options) {
    return WholeReader(ink, library, options).run();
}

}  // namespace ew
