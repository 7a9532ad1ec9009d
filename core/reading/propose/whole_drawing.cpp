// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/whole_drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "core/base/tolerance.h"
#include "core/edge_graph/edit.h"
#include "core/reading/evidence/hand_noise.h"
#include "core/reading/extract/axis_frames.h"
#include "core/reading/propose/polyhedron_proposals.h"
#include "core/reading/propose/prism_proposals.h"
#include "core/reading/propose/pyramid_proposals.h"
#include "core/reading/score/candidates.h"
#include "core/reading/score/picture_evidence.h"
#include "core/reading/score/planes_price.h"
#include "core/reading/types/reading_params.h"
#include "core/tlib/library_index.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A hypothesis that was solved and is a solid.
struct Solved {
    Candidate candidate;
    PictureEvidence evidence;
    double cost = 0.0;
    double misfit = 0.0;  ///< PlaneFit::misfit
    Solid solid;
    bool known = false;    ///< is a template of the library
    bool guessed = false;  ///< a hole ends where nothing of it is seen
    bool faint = false;    ///< some corner of a seen face turns by no more than this hand errs
    int lift = -1;         ///< those of one number differ in what is not seen alone; -1: none
    std::shared_ptr<const EdgeGraph> graph;
};

class WholeReader {
  public:
    WholeReader(const InkReading& ink, const TemplateLibrary& library,
                const InterpretOptions& options)
        : ink_(ink), library_(library), options_(options) {}

    WholeReading run() {
        std::vector<Solved> found;
        for (const double distance : joinDistances()) {
            readAt(distance, found);
            if (!found.empty() && isClear(found)) break;
        }
        WholeReading out;
        if (found.empty()) return out;
        out.clear = isClear(found);
        out.residue = found.front().evidence.residue();
        out.graph = *found.front().graph;
        out.isKnown = found.front().known;
        for (Solved& s : found) {
            if (s.graph != found.front().graph) s.candidate.junctionVertex.clear();
            s.candidate.junctionVertex.resize(out.graph.junctions.size(), -1);
            out.candidates.push_back(std::move(s.candidate));
            if (static_cast<int>(out.candidates.size()) == options_.maxCandidates) break;
        }
        return out;
    }

  private:
    static constexpr std::size_t kFewestLines = 6;
    static constexpr std::size_t kManyLines = 16;
    static constexpr int kMostTried = 60;  ///< proposals of all graphs
    static constexpr std::size_t kMostFrames = 6;
    static constexpr int kMostFramesTried = 16;  ///< of all graphs
    static constexpr double kSureFrame = 0.9;    ///< share of the lines along an axis
    static constexpr double kLikelyFrame = 0.7;  ///< that share, as one of the likeliest frame's
    static constexpr double kLeastSnapDeg = 0.5;
    /// What fits no better than this, in variances, is not worth the work.
    static constexpr double kHopeless = 10.0;

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

    void readAt(double distance, std::vector<Solved>& found) {
        for (const EdgeGraph& whole : buildEdgeGraphs(ink_, distance)) {
            if (whole.empty()) continue;
            std::vector<EdgeGraph> parts = connectedParts(whole);
            if (parts.front().edges.size() < kFewestLines) continue;
            add(EdgeGraph(parts.front()), true, found);
            // One closed line is no body, and no part of one.
            std::erase_if(parts, isOneOutline);
            if (parts.size() > 1) add(joinedParts(parts), false, found);
        }
        std::stable_sort(found.begin(), found.end(),
                         [](const Solved& a, const Solved& b) { return a.cost < b.cost; });
        dropAlike(found);
    }

    /// \param alone  the graph is connected, and may be one of a family.
    void add(EdgeGraph&& graph, bool alone, std::vector<Solved>& found) {
        const auto shared = std::make_shared<const EdgeGraph>(std::move(graph));
        const double price = bends(*shared);
        for (Solved& s : read(*shared, alone)) {
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

    std::vector<Solved> read(const EdgeGraph& graph, bool alone) {
        noise_ = std::max(drawingNoisePx(graph), handNoisePx(ink_));
        corner_ = cornerSpread(ink_, options_.thresholds.distancePx, noise_);
        const LineDrawing drawing = lineDrawing(graph, params::kStraightDeg);
        spread_ = fitSpread_ = std::hypot(noise_, corner_);
        std::vector<Solved> found;
        if (alone) {
            std::vector<ShapeHypothesis> families = prismProposals(drawing, spread_);
            for (ShapeHypothesis& h : pyramidProposals(drawing, spread_)) {
                families.push_back(std::move(h));
            }
            if (solveAll(families, drawing, found)) return found;
        }
        std::vector<double> spreads{spread_};
        // An exact drawing tells planes apart that a hand would draw as one.
        constexpr double kExactSpreadPx = 0.005;
        if (noise_ <= params::kExactPx) spreads.insert(spreads.begin(), kExactSpreadPx);
        for (const double spread : spreads) {
            const std::vector<AxisFrame> frames = axisFrames(drawing, spread, kMostFrames);
            for (const AxisFrame& frame : frames) {
                if (frame.share < kLikelyFrame * frames.front().share) continue;
                if (framesTried_++ == kMostFramesTried) return found;
                const std::vector<ShapeHypothesis> proposals =
                    polyhedronProposals(drawing, frame, spread);
                const bool explained = solveAll(proposals, drawing, found);
                if (!proposals.empty()) lifts_ += proposals.back().lift + 1;
                // Slanted lines fit more than one frame.
                if (explained && frame.share > kSureFrame) return found;
            }
        }
        return found;
    }

    /// \return does one of them explain the ink?
    bool solveAll(const std::vector<ShapeHypothesis>& proposals, const LineDrawing& drawing,
                  std::vector<Solved>& found) {
        std::vector<Rough> rough;
        for (const ShapeHypothesis& h : proposals) {
            // An exact drawing is told by any proposal, also by one that is too many to be tried.
            const bool wanted = noise_ <= params::kExactPx || tried_ < kMostTried;
            rough.push_back(wanted ? roughFit(h, drawing) : Rough{});
            rough.back().tried = tried_++ < kMostTried;
        }
        fitSpread_ = std::min(fitSpread_, exactSpread(rough).value_or(spread_));
        bool explained = false;
        for (std::size_t i = 0; i < proposals.size(); ++i) {
            if (!rough[i].tried || !rough[i].fit || rough[i].fit->misfit > kHopeless) continue;
            auto s = solve(proposals[i], drawing);
            if (!s) continue;
            explained = explained || (s->misfit <= params::kWholeMisfit &&
                                      s->evidence.residue() <= params::kWholeResidue);
            found.push_back(std::move(*s));
        }
        return explained;
    }

    /// A proposal's least regular model, after a few steps.
    struct Rough {
        std::optional<PlaneFit> fit;
        int redundancy = 0;  ///< numbers drawn beyond those that it takes
        bool tried = false;
    };

    Rough roughFit(const ShapeHypothesis& h, const LineDrawing& drawing) const {
        constexpr int kFewSteps = 8;
        PlaneModel model = regularModel(h.rough, h.frame, kLeastSnapDeg);
        const auto vertices = seen(h, drawing, spread_);
        Rough out;
        out.redundancy = 2 * static_cast<int>(vertices.size()) - model.freedoms();
        out.fit = fitPlanes(std::move(model), vertices, stretches(h, spread_), kFewSteps);
        return out;
    }

    /// Where something fits far better than hands do although much could contradict it, the drawing
    /// is exact, and says what is regular and what is not.
    std::optional<double> exactSpread(const std::vector<Rough>& rough) const {
        if (noise_ > params::kExactPx) return std::nullopt;
        constexpr int kRedundant = 4;
        std::optional<double> least;
        for (const Rough& r : rough) {
            if (!r.fit || r.redundancy < kRedundant) continue;
            const double rms = std::sqrt(r.fit->misfit) * spread_;
            if (rms < params::kExactPx && rms < least.value_or(1.0)) least = rms;
        }
        if (!least) return std::nullopt;
        return std::max(2.0 * *least, 0.5 * params::kExactPx);
    }

    /// Was it closed behind what is seen? What is hidden of a prism or a pyramid follows from its
    /// base.
    static bool isClosed(const ShapeHypothesis& h) { return h.lift >= 0; }

    /// The model that costs least, its freedoms counted, of more and less regular ones.
    std::optional<PlaneFit> fit(const ShapeHypothesis& h, const LineDrawing& drawing) const {
        std::optional<PlaneFit> best;
        const auto vertices = seen(h, drawing, fitSpread_);
        const auto lines = stretches(h, fitSpread_);
        int before = -1;
        for (const double angle : {kLeastSnapDeg, 3.0, 8.0, 15.0}) {
            std::vector<PlaneModel> models{regularModel(h.rough, h.frame, angle)};
            if (models.front().freedoms() == before) continue;  // no more regular
            before = models.front().freedoms();
            if (!h.ring.empty()) {
                models.push_back(models.front());
                makeRegularRing(models.back(), h.ring);
            }
            for (PlaneModel& model : models) {
                const int freedoms = model.freedoms();
                auto f = fitPlanes(std::move(model), vertices, lines);
                if (!f) continue;
                f->cost += params::kFreedomCost * freedoms +
                           (isClosed(h) ? planesPrice(f->model) : slantsPrice(f->model));
                if (!best || f->cost < best->cost) best = std::move(f);
            }
        }
        return best;
    }

    std::vector<DrawnVertex> seen(const ShapeHypothesis& h, const LineDrawing& drawing,
                                  double spread) const {
        std::vector<DrawnVertex> out;
        for (std::size_t v = 0; v < h.node.size(); ++v) {
            if (h.node[v] < 0) continue;
            out.push_back({static_cast<int>(v), drawing.nodes[at(h.node[v])].at, spread});
        }
        return out;
    }

    static std::vector<DrawnStretch> stretches(const ShapeHypothesis& h, double spread) {
        std::vector<DrawnStretch> out = h.stretches;
        for (DrawnStretch& s : out) s.spreadPx = spread;
        return out;
    }

    std::optional<Solved> solve(const ShapeHypothesis& h, const LineDrawing& drawing) const {
        const auto f = fit(h, drawing);
        if (!f || !isWithin(*f, drawing)) return std::nullopt;
        Candidate c;
        place(*f, h, c);
        auto solid = Solid::fromSpec(c.spec);
        if (!solid) return std::nullopt;
        Solved out{std::move(c),
                   {},
                   f->cost,
                   f->misfit,
                   *std::move(solid),
                   false,
                   false,
                   isFaint(*f, h),
                   h.lift < 0 ? -1 : lifts_ + h.lift,
                   nullptr};
        // A careful hand's lines lie where the picture has them, but for what the fit itself
        // misses.
        const double missed = std::sqrt(f->misfit) * fitSpread_;
        const double near = std::min(options_.thresholds.distancePx,
                                     params::kLeastBesidePx + 3.0 * noise_ + 2.0 * missed);
        out.evidence = pictureEvidence(ink_, out.solid, out.candidate.pose, options_.camera, near);
        out.cost += params::kStrayCost * (out.evidence.strayPx + out.evidence.barePx) /
                    options_.thresholds.distancePx;
        out.cost += h.price;
        if (isClosed(h)) {
            out.cost += params::kUnseenCornerCost *
                        static_cast<double>(std::count(h.node.begin(), h.node.end(), -1));
            out.cost += params::kHiddenFrontCost * out.evidence.hiddenFronts;
        }
        describe(h, *f, out);
        out.guessed = endsUnseen(out.solid, h);
        return out;
    }

    /// Has a face a hole of which no corner is seen? A hole through the solid may as well end
    /// within it.
    static bool endsUnseen(const Solid& solid, const ShapeHypothesis& h) {
        // The solid's corners come in the order of the hypothesis where all of them were kept.
        if (solid.vertices().size() != h.node.size()) return false;
        return std::any_of(solid.faces().begin(), solid.faces().end(), [&](const SolidFace& f) {
            return std::any_of(f.loops.begin() + 1, f.loops.end(), [&](const auto& hole) {
                return std::all_of(hole.begin(), hole.end(),
                                   [&](int v) { return h.node[at(v)] < 0; });
            });
        });
    }

    /// Is the picture no larger than the drawing, by and large, and the solid not far deeper?
    static bool isWithin(const PlaneFit& f, const LineDrawing& drawing) {
        const auto [low, high] = drawing.bounds();
        const double size = (high - low).norm();
        constexpr double kRoom = 0.5;
        constexpr double kDepth = 20.0;
        double near = std::numeric_limits<double>::infinity();
        double far = -near;
        for (const Vec3& p : f.camera) {
            const Vec2 q = p.head<2>();
            if (((low - q).array() > kRoom * size).any()) return false;
            if (((q - high).array() > kRoom * size).any()) return false;
            near = std::min(near, p.z());
            far = std::max(far, p.z());
        }
        return far - near < kDepth * size;
    }

    /// Does some face that looks at the eye have a corner that may be the bend of one line?
    bool isFaint(const PlaneFit& f, const ShapeHypothesis& h) const {
        for (const std::vector<int>& loop : h.rough.faces) {
            const std::size_t n = loop.size();
            const auto p = [&](std::size_t k) -> Vec2 {
                return f.camera[at(loop[k % n])].head<2>();
            };
            double area = 0.0;
            for (std::size_t k = 0; k < n; ++k) area += cross2(p(k), p(k + 1));
            if (area >= 0.0) continue;  // looks away; y is down
            for (std::size_t k = 0; k < n; ++k) {
                const Vec2 chord = p(k + 2) - p(k);
                const double height =
                    std::abs(cross2(chord, p(k + 1) - p(k))) / std::max(chord.norm(), 1e-6);
                if (height < params::kFaintCorner * spread_) return true;
            }
        }
        return false;
    }

    /// In millimetres and in the world, with the nearest corner in the Sketch Plane.
    void place(const PlaneFit& f, const ShapeHypothesis& h, Candidate& c) const {
        const double scale = options_.camera.worldPerPixel;
        for (const Vec3& p : f.body) c.spec.vertices.push_back(scale * p);
        c.spec.faces = h.rough.faces;
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vec3& p : f.camera) nearest = std::min(nearest, p.z());
        c.pose.rotation = options_.camera.cameraToWorld() * f.model.bodyToCamera;
        c.pose.translation =
            options_.camera.unproject(f.model.center.head<2>(), f.model.center.z() - nearest);
    }

    void describe(const ShapeHypothesis& h, const PlaneFit& f, Solved& out) const {
        Candidate& c = out.candidate;
        c.templateId = h.family;
        c.templateName = familyName(h.family);
        const std::size_t bodies = separateBodies(c.spec).size();
        if (bodies > 1) c.templateName = std::to_string(bodies) + " solids";
        if (const LibraryEntry* entry = templateOf(f.model, c.spec)) {
            c.templateId = entry->tmpl.id;
            c.templateName = entry->tmpl.name;
            out.known = true;
        }
        c.unusedStrokes = out.evidence.beside;
        c.aspect = "region";
        c.readingId = "default";
        c.residualPx = std::sqrt(f.misfit) * fitSpread_;
        c.junctionVertex.assign(out.candidate.junctionVertex.size(), -1);
        int highest = -1;
        for (const int node : h.node) highest = std::max(highest, node);
        c.junctionVertex.assign(at(highest + 1), -1);
        for (std::size_t v = 0; v < h.node.size(); ++v) {
            if (h.node[v] >= 0) c.junctionVertex[at(h.node[v])] = static_cast<int>(v);
        }
        const double off = c.residualPx / options_.thresholds.distancePx;
        c.score = std::exp(-2.0 * off * off) * std::exp(-2.0 * out.evidence.residue());
    }

    /// The template that a solid is one of: the same sizes of faces and, where all edges of the
    /// template run along three axes, all faces across them.
    const LibraryEntry* templateOf(const PlaneModel& model, const PolyhedronSpec& spec) const {
        const auto sizes = [](const PolyhedronSpec& s) {
            std::multiset<std::size_t> out;
            for (const auto& face : s.faces) out.insert(face.size());
            return out;
        };
        const bool upright = std::all_of(model.normals.begin(), model.normals.end(),
                                         [](const PlaneModel::Normal& n) {
                                             return n.kind == PlaneModel::Normal::Kind::Fixed &&
                                                    n.first.cwiseAbs().maxCoeff() == 1.0;
                                         });
        for (const auto& entry : library_.index().entries) {
            if (entry->analysis.rectilinear.has_value() != upright) continue;
            if (entry->tmpl.shape.vertices.size() != spec.vertices.size()) continue;
            if (sizes(entry->tmpl.shape) == sizes(spec)) return entry.get();
        }
        return nullptr;
    }

    static std::string familyName(const std::string& family) {
        if (family == "prism") return "Prism";
        if (family == "pyramid") return "Pyramid";
        return family == "frustum" ? "Frustum" : "Solid";
    }

    /// One reading of each solid: every face of a box may be the base.
    static void dropAlike(std::vector<Solved>& found) {
        std::vector<Solved> kept;
        for (Solved& s : found) {
            const bool known = std::any_of(kept.begin(), kept.end(), [&](const Solved& k) {
                return k.solid.vertices().size() == s.solid.vertices().size() &&
                       k.solid.edges().size() == s.solid.edges().size() &&
                       std::abs(k.solid.volume() / s.solid.volume() - 1.0) < params::kSameVolume;
            });
            if (!known) kept.push_back(std::move(s));
        }
        found = std::move(kept);
    }

    /// Do two readings differ in what is not seen alone?
    static bool looksAlike(const Solved& a, const Solved& b) {
        return a.lift == b.lift && a.lift >= 0;
    }

    /// Does the first one explain the ink, and no other as well at much the same cost?
    bool isClear(const std::vector<Solved>& found) const {
        if (found.front().evidence.residue() > params::kWholeResidue) return false;
        if (found.front().misfit > params::kWholeMisfit) return false;
        if (found.front().faint) return false;
        // An unsteady hand's few lines fit many solids.
        const bool unsteady = endSpread(ink_.segments, options_.thresholds.distancePx) >
                              kUnsteadySpread * options_.thresholds.distancePx;
        if (unsteady && !found.front().known && found.front().graph->edges.size() < kManyLines) {
            return false;
        }
        if (found.front().guessed) return false;
        return std::none_of(found.begin() + 1, found.end(), [&](const Solved& other) {
            const double margin =
                looksAlike(found.front(), other) ? params::kCompletionMargin : params::kWholeMargin;
            return other.evidence.residue() <= params::kOtherResidue &&
                   other.cost < found.front().cost + margin;
        });
    }

    const InkReading& ink_;
    const TemplateLibrary& library_;
    const InterpretOptions& options_;
    int tried_ = 0;
    int framesTried_ = 0;
    int lifts_ = 0;  ///< numbers of ShapeHypothesis::lift of frames before
    double noise_ = 1.0;
    double corner_ = 2.0;
    double spread_ = 2.0;     ///< of drawn corners, per axis [px]
    double fitSpread_ = 2.0;  ///< the same, where the drawing is not exact
};

}  // namespace

WholeReading readWholeDrawing(const InkReading& ink, const TemplateLibrary& library,
                              const InterpretOptions& options) {
    return WholeReader(ink, library, options).run();
}

}  // namespace ew
