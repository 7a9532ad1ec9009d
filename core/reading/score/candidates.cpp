// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/score/candidates.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/base/tolerance.h"
#include "core/reading/evidence/hand_noise.h"
#include "core/reading/evidence/ink_extent.h"
#include "core/reading/solve/body_frame.h"
#include "core/reading/solve/general_fit.h"
#include "core/reading/solve/perspective_fit.h"
#include "core/reading/solve/rectilinear_fit.h"
#include "core/reading/solve/start_points.h"
#include "core/reading/types/reading_params.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }
constexpr double kRadian = 180.0 / std::numbers::pi;

class Reader {
  public:
    Reader(const EdgeGraph& graph, const GraphMatch& match, const ReadingContext& context)
        : match_(match),
          options_(context.options),
          entry_(*match.entry),
          sighting_(sightingOf(graph, match, context.options.thresholds.distancePx)),
          noisePx_(context.noisePx),
          cornerPx_(context.cornerPx),
          worthCost_(context.worthCost) {
        sighting_.doubt = std::clamp(noisePx_ - tol::kNoiseFloorPx, 0.0, 1.0);
    }

    std::vector<RatedCandidate> run(std::vector<Slip>& slips) {
        if (entry_.analysis.rectilinear) {
            rectilinear(slips);
        } else {
            general();
        }
        return std::move(out_);
    }

    void named(const RatedCandidate& base) {
        CameraPoints start;
        for (const Vec3& v : base.candidate.spec.vertices) {
            const Vec3 w = base.candidate.pose.toWorld(v);
            const Vec2 p = options_.camera.project(w);
            start.emplace_back(p.x(), p.y(), options_.camera.depthPx(w));
        }
        for (const TemplateReading& reading : entry_.tmpl.readings) {
            // Which edges are meant says the body: those that nearly are what the reading wants.
            std::vector<std::pair<double, SolverRelations>> variants;
            std::set<std::vector<int>> known;
            for (const auto& symmetry : entry_.symmetries) {
                SolverRelations relations = solverRelations(entry_.analysis);
                addReading(relations, entry_.analysis, reading.relations, symmetry);
                if (!known.insert(relationKey(relations)).second) continue;
                const double off = violation(relations, entry_.analysis, start);
                variants.emplace_back(off, std::move(relations));
            }
            std::stable_sort(variants.begin(), variants.end(),
                             [](const auto& a, const auto& b) { return a.first < b.first; });
            if (variants.size() > kMostVariants) variants.resize(kMostVariants);
            std::optional<GeneralSolution> best;
            for (const auto& variant : variants) {
                const auto s =
                    solveGeneral(entry_.tmpl, entry_.analysis, sighting_, variant.second, start);
                if (s && (!best || s->cost < best->cost)) best = s;
            }
            if (best) addGeneral(*best, reading.id, reading.name);
        }
    }

    std::vector<RatedCandidate> take() { return std::move(out_); }

  private:
    static std::vector<int> relationKey(const SolverRelations& r) {
        std::vector<int> key;
        for (const auto& p : r.perpendicular) {
            key.push_back(std::min(p[0], p[1]));
            key.push_back(std::max(p[0], p[1]));
        }
        for (auto g : r.equalLength) {
            std::sort(g.begin(), g.end());
            key.push_back(-1);
            key.insert(key.end(), g.begin(), g.end());
        }
        for (auto g : r.parallel) {
            std::sort(g.begin(), g.end());
            key.push_back(-2);
            key.insert(key.end(), g.begin(), g.end());
        }
        return key;
    }

    RatedCandidate blank(const CameraPoints& points, int parameters) const {
        RatedCandidate r;
        r.entry = match_.entry;
        r.match = match_;
        r.drawn = points;
        Candidate& c = r.candidate;
        c.templateId = entry_.tmpl.id;
        c.templateName = entry_.tmpl.name;
        c.aspect = match_.aspect->name;
        c.operation = Operation::Create;
        c.residualPx = residualPx(sighting_, entry_.analysis, points);
        c.junctionVertex = match_.vertex;
        c.missingEdges = match_.missingEdges;
        const Misfit misfit = misfitOf(sighting_, entry_.analysis, points, noisePx_, cornerPx_);
        r.misfit = misfit.perEnd;
        r.cost = misfit.cost + params::kFreedomCost * parameters +
                 tol::kMissingEdgeCost * match_.missingEdges;
        c.evidence.fit = misfit.cost;
        c.evidence.bare = tol::kMissingEdgeCost * match_.missingEdges;
        c.evidence.freedoms = params::kFreedomCost * parameters;
        r.parallelDeg = match_.parallelDeg;
        r.parameters = parameters;
        r.withinThresholds = match_.parallelDeg <= options_.thresholds.angleDeg &&
                             match_.bentDeg <= 2 * options_.thresholds.angleDeg &&
                             c.residualPx <= tol::kClearResidual * options_.thresholds.distancePx;
        if (match_.missingEdges > 0) {
            c.notes.push_back(match_.missingEdges == 1
                                  ? "One edge that was not drawn was added."
                                  : std::to_string(match_.missingEdges) +
                                        " edges that were not drawn were added.");
        }
        return r;
    }

    void addRectilinear(const AffinePicture& picture, const std::array<Vec3, 3>& axes,
                        DepthRule rule, int parameters) {
        CameraPoints points;
        const RectilinearStructure& r = *entry_.analysis.rectilinear;
        for (std::size_t v = 0; v < entry_.tmpl.shape.vertices.size(); ++v) {
            Vec3 p(picture.origin.x(), picture.origin.y(), 0);
            for (std::size_t a = 0; a < 3; ++a)
                p += picture.position[a][at(r.planes[a][v])] * axes[a];
            points.push_back(p);
        }
        bool mirrored = false;
        if (rule != DepthRule::Oblique &&
            !facesLookRight(entry_.tmpl, sighting_, points, mirrored)) {
            return;
        }
        // The ink is compared with the affine picture that it was fitted to: the oblique reading is
        // no parallel projection, so the solid's own picture differs from it by design.
        CameraPoints drawn;
        for (std::size_t v = 0; v < points.size(); ++v) {
            const Vec2 p = picture.at(r, v);
            drawn.emplace_back(p.x(), p.y(), points[v].z());
        }
        RatedCandidate rated = blank(drawn, parameters);
        const PlacedBody body =
            placeRectilinear(entry_.tmpl, r, picture, axes, sighting_, options_.camera);
        rated.candidate.spec = body.spec;
        rated.candidate.pose = body.pose;
        rated.candidate.depth = rule;
        rated.candidate.readingId = "default";
        rated.candidate.readingName = "Parallel projection";
        rated.cost += tol::kUnseenPlaneCost * picture.unseenPlanes;
        if (picture.unseenPlanes > 0) {
            rated.candidate.notes.push_back(
                "Parts that cannot be seen from here keep the template's proportions.");
        }
        out_.push_back(std::move(rated));
    }

    bool addOrthographic(const AffinePicture& picture, DepthRule rule, int parameters) {
        const auto depths = cornerDepths(picture.axes);
        if (!depths) return false;
        const std::size_t before = out_.size();
        for (const double sign : {1.0, -1.0}) {
            std::array<Vec3, 3> axes;
            for (std::size_t a = 0; a < 3; ++a) {
                axes[a] = Vec3(picture.axes[a].x(), picture.axes[a].y(), sign * (*depths)[a]);
            }
            addRectilinear(picture, axes, rule, parameters);
        }
        return out_.size() > before;
    }

    void rectilinear(std::vector<Slip>& slips) {
        const auto picture = fitAffine(sighting_, entry_.analysis);
        if (!picture) return;
        parallelViews(*picture, slips);
        noteMovedCorner(*picture, slips);
        perspective(*picture);
    }

    void parallelViews(const AffinePicture& picture, std::vector<Slip>& slips) {
        const RectilinearStructure& r = *entry_.analysis.rectilinear;
        const int parameters = 2 + r.planeCount[0] + r.planeCount[1] + r.planeCount[2];
        const CriticalAngle critical = criticalAngle(picture);
        const double spread = critical.spreadDeg * noisePx_ / std::max(sighting_.acrossPx, 1e-9);
        const bool solved = addOrthographic(picture, DepthRule::Orthographic, parameters);
        const bool doubtful = critical.offDeg < tol::kUnreliableCornerDeg;
        if (solved && !doubtful) {
            // The drawing says what it is; the oblique reading is there for those who never draw
            // otherwise.
            const double price = out_.front().cost + tol::kUnlikelyReadingCost;
            if (critical.offDeg < tol::kObliqueLimitDeg && addOblique(picture, parameters) < 1e9) {
                out_.back().cost = price;
            }
            return;
        }

        double snapMoved = 0;
        if (!solved) {
            // What is snapped or read obliquely is a guess; that no such corner exists is a fact.
            if (match_.missingEdges == 0 && critical.offDeg > params::kSureAngle * spread) {
                slips.push_back(impossible(picture, cornerPlace(critical), parameters));
            }
            const AffinePicture snapped = snapToSolvable(picture, tol::kSnapMarginDeg, snapMoved);
            if (critical.offDeg + tol::kSnapMarginDeg > tol::kSnapLimitDeg ||
                !addOrthographic(snapped, DepthRule::Snapped, parameters)) {
                if (critical.offDeg > 3 * tol::kUnreliableCornerDeg) return;
                snapMoved = 1e9;
            } else {
                out_.back().candidate.readingName = "Nearest parallel projection";
                out_.back().candidate.notes.push_back(
                    "The corner has no exact solution; the nearest drawing that has one was "
                    "taken.");
            }
        }
        const double obliqueMoved = addOblique(picture, parameters);
        if (out_.size() < 2) return;
        // Which comes first: the one that moves the ink less, but a solution that rests on an angle
        // which this hand cannot have meant exactly yields to the oblique reading.
        const double doubt =
            std::max(tol::kDepthSpreads * spread, std::min(tol::kStretchedCornerDeg, 2.0 * spread));
        const bool unsure = solved && critical.offDeg < doubt;
        const bool obliqueFirst = unsure || (!solved && obliqueMoved <= snapMoved);
        if (obliqueFirst) {
            out_.back().cost = out_.front().cost - 0.5;
            std::swap(out_.front(), out_.back());
        } else {
            out_.back().cost = out_.front().cost + 0.5;
        }
    }

    /// A box in perspective is no frustum: where lines converge as they would for an eye nearby,
    /// the solid is the one that this eye saw.
    void perspective(const AffinePicture& picture) {
        if (out_.empty() || out_.front().misfit * sighted() < params::kPerspectiveCost) return;
        auto depths = cornerDepths(picture.axes);
        if (!depths) {
            double moved = 0;
            depths = cornerDepths(snapToSolvable(picture, tol::kSnapMarginDeg, moved).axes);
        }
        if (!depths) return;
        const double least = out_.front().cost;
        for (const double sign : {1.0, -1.0}) {
            for (double& d : *depths) d *= sign;
            const auto seen = fitPerspective(sighting_, entry_.analysis, picture, *depths);
            if (seen) addPerspective(*seen, least);
        }
    }

    /// Line ends that count in misfitOf().
    double sighted() const { return static_cast<double>(2 * sighting_.edges.size()); }

    /// \param least  cost of the best parallel view.
    void addPerspective(const PerspectivePicture& seen, double least) {
        const RectilinearStructure& r = *entry_.analysis.rectilinear;
        CameraPoints drawn;
        for (std::size_t v = 0; v < entry_.tmpl.shape.vertices.size(); ++v) {
            drawn.push_back(seen.at(r, v));
        }
        bool mirrored = false;
        if (!facesLookRight(entry_.tmpl, sighting_, drawn, mirrored)) return;
        const int parameters = 2 + r.planeCount[0] + r.planeCount[1] + r.planeCount[2];
        RatedCandidate rated = blank(drawn, parameters);
        rated.cost += params::kPerspectiveCost;
        // What is parallel comes together, so the angle threshold does not speak.
        rated.withinThresholds =
            rated.candidate.residualPx <= tol::kClearResidual * options_.thresholds.distancePx;
        if (rated.cost >= least) return;
        const PlacedBody body =
            placeRectilinear(entry_.tmpl, r, seen.parallel, seen.axes, sighting_, options_.camera);
        rated.candidate.spec = body.spec;
        rated.candidate.pose = body.pose;
        rated.candidate.depth = DepthRule::Perspective;
        rated.candidate.readingId = "perspective";
        rated.candidate.readingName = "Perspective";
        rated.candidate.notes.push_back("Read in perspective: lines that run away come together.");
        out_.insert(out_.begin(), std::move(rated));
    }

    double addOblique(const AffinePicture& picture, int parameters) {
        double moved = 0;
        ObliqueBody body = obliqueAxes(picture, options_.obliqueFactor, moved);
        orientDepth(picture, body);
        const std::size_t before = out_.size();
        addRectilinear(picture, body.axes, DepthRule::Oblique, parameters);
        if (out_.size() == before) return 1e9;
        Candidate& c = out_.back().candidate;
        c.readingId = "oblique";
        c.readingName = "Oblique";
        c.obliqueFactor = options_.obliqueFactor;
        c.notes.push_back(
            "Read as an oblique drawing: the front face is true, the depth is a choice.");
        return moved;
    }

    /// The seen face that is perpendicular to the depth axis is the front: nearer than the rest.
    void orientDepth(const AffinePicture& picture, ObliqueBody& body) const {
        const RectilinearStructure& r = *entry_.analysis.rectilinear;
        const std::size_t axis = at(body.depthAxis);
        double front = 0;
        double count = 0;
        for (const int f : sighting_.visibleFaces) {
            const auto& loop = entry_.tmpl.shape.faces[at(f)];
            const int plane = r.planes[axis][at(loop[0])];
            const bool across = std::all_of(loop.begin(), loop.end(),
                                            [&](int v) { return r.planes[axis][at(v)] == plane; });
            if (!across) continue;
            front += picture.position[axis][at(plane)];
            count += 1;
        }
        double mean = 0;
        for (const double p : picture.position[axis]) mean += p;
        mean /= static_cast<double>(picture.position[axis].size());
        if (count > 0 && front / count > mean) body.axes[axis] = -body.axes[axis];
    }

    /// Faces that are parallelograms, round a corner that cannot be right-angled.
    Slip impossible(const AffinePicture& picture, const Vec2& corner, int parameters) const {
        const Misfit misfit =
            misfitOf(sighting_, entry_.analysis,
                     picturePoints(picture, *entry_.analysis.rectilinear), noisePx_, cornerPx_);
        const double cost = misfit.cost + params::kFreedomCost * parameters +
                            tol::kMissingEdgeCost * match_.missingEdges +
                            params::kImpossibleCornerCost;
        return {Errc::ImpossibleCorner, corner,         corner,          cost,
                misfit.perEnd,          entry_.tmpl.id, entry_.tmpl.name};
    }

    void noteMovedCorner(const AffinePicture& picture, std::vector<Slip>& slips) const {
        // Who draws exactly means what he draws.
        if (match_.missingEdges > 0 || noisePx_ <= params::kExactNoisePx) return;
        const Misfit all =
            misfitOf(sighting_, entry_.analysis,
                     picturePoints(picture, *entry_.analysis.rectilinear), noisePx_, cornerPx_);
        if (all.perEnd <= tol::kDoubtfulMisfit) return;  // none lies far off
        const double least = std::max(params::kSlipLeast * options_.thresholds.distancePx,
                                      params::kSlipSpreads * cornerPx_);
        if (auto slip = movedCorner(sighting_, entry_, noisePx_, cornerPx_, least)) {
            slips.push_back(*std::move(slip));
        }
    }

    /// Where the two axes of the critical angle meet: best with the third one between them, as
    /// people look at a corner.
    Vec2 cornerPlace(const CriticalAngle& critical) const {
        double best = -1.0;
        Vec2 place = sighting_.edges.front().tips[0];
        for (std::size_t v = 0; v < sighting_.seen.size(); ++v) {
            if (!sighting_.seen[v]) continue;
            int across = 0;
            Vec2 pull = Vec2::Zero();  // small where lines leave to all sides
            double count = 0.0;
            for (const DrawnEdge& d : sighting_.edges) {
                const bool first = d.vertex[0] == static_cast<int>(v);
                if (!first && d.vertex[1] != static_cast<int>(v)) continue;
                pull += first ? d.direction() : Vec2(-d.direction());
                count += 1.0;
                if (entry_.analysis.edges[at(d.edge)].directionClass != critical.axis) ++across;
            }
            const double all = count - pull.norm() / std::max(1.0, count);
            if (across < 2 || all <= best) continue;
            best = all;
            place = sighting_.vertexPx[v];
        }
        return place;
    }

    void general() {
        const double atLeast =
            params::kFreedomCost * templateFreedoms(entry_.tmpl, entry_.analysis) +
            tol::kMissingEdgeCost * match_.missingEdges;
        if (atLeast > worthCost_) return;
        const SolverRelations relations = solverRelations(entry_.analysis);
        std::optional<GeneralSolution> best;
        int tried = 0;
        for (const CameraPoints& start :
             startPoints(entry_.tmpl, sighting_, *match_.aspect, match_.mirrored)) {
            const auto s = solveGeneral(entry_.tmpl, entry_.analysis, sighting_, relations, start);
            if (s && (!best || s->cost < best->cost)) best = s;
            // A start that explains the drawing needs no second opinion.
            if (best && best->cost < 1.0) break;
            if (++tried >= 3 && best) break;
        }
        if (best) addGeneral(*best, "default", "Most regular");
    }

    void addGeneral(const GeneralSolution& s, const std::string& id, const std::string& name) {
        RatedCandidate rated = blank(s.points, s.parameters);
        const PlacedBody body = placeGeneral(entry_.tmpl, s.points, sighting_, options_.camera);
        rated.candidate.spec = body.spec;
        rated.candidate.pose = body.pose;
        rated.candidate.readingId = id;
        rated.candidate.readingName =
            s.freedoms == 0 && id == "default" ? "Parallel projection" : name;
        if (s.freedoms > 0) {
            rated.candidate.notes.push_back(
                (s.freedoms == 1
                     ? std::string("The drawing leaves one measure open; ")
                     : "The drawing leaves " + std::to_string(s.freedoms) + " measures open; ") +
                "the most regular shape was taken.");
        }
        out_.push_back(std::move(rated));
    }

    static constexpr std::size_t kMostVariants = 2;

    const GraphMatch& match_;
    const InterpretOptions& options_;
    const LibraryEntry& entry_;
    Sighting sighting_;
    double noisePx_;
    double cornerPx_;
    double worthCost_;
    std::vector<RatedCandidate> out_;
};

}  // namespace

double drawingNoisePx(const EdgeGraph& graph) {
    std::vector<int> degree(graph.junctions.size(), 0);
    for (const GraphEdge& e : graph.edges) {
        ++degree[at(e.ends[0])];
        ++degree[at(e.ends[1])];
    }
    double sum = 0;
    double freedom = 0;
    for (const int d : degree) freedom += std::max(0, d - 2);
    double wobble = 0;
    for (const GraphEdge& e : graph.edges) {
        wobble += e.wobblePx * e.wobblePx;
        const Vec2 dir = (e.tips[1] - e.tips[0]).normalized();
        for (std::size_t s = 0; s < 2; ++s) {
            if (degree[at(e.ends[s])] < 3) continue;
            const double off = cross2(dir, graph.junctions[at(e.ends[s])].position - e.tips[s]);
            sum += off * off;
        }
    }
    wobble /= std::max<double>(1.0, static_cast<double>(graph.edges.size()));
    // Few junctions say little: the lines' own wobble counts like two of them.
    const double variance = (sum + 2 * wobble) / (freedom + 2);
    return std::sqrt(variance + tol::kNoiseFloorPx * tol::kNoiseFloorPx);
}

double drawnNoisePx(const EdgeGraph& graph, const InkReading& ink) {
    return std::max(drawingNoisePx(graph), handNoisePx(ink));
}

double cornerSpread(const InkReading& ink, double distancePx, double noisePx) {
    const double mean =
        inkLengthPx(ink) / std::max<double>(1.0, static_cast<double>(ink.segments.size()));
    const double least = std::max(params::kCornerSpreadLeastPx, params::kCornerSpreadShare * mean);
    // What its ends miss each other by and its lines' noise does not explain.
    const double ends = endSpread(ink.segments, distancePx);
    return std::sqrt(least * least + std::max(0.0, ends * ends - noisePx * noisePx));
}

std::vector<RatedCandidate> readingsOf(const EdgeGraph& graph, const GraphMatch& match,
                                       const ReadingContext& context, std::vector<Slip>& slips) {
    return Reader(graph, match, context).run(slips);
}

void addNamedReadings(std::vector<RatedCandidate>& candidates, const ReadingContext& context) {
    if (candidates.empty() || candidates.front().entry->tmpl.readings.empty()) return;
    const RatedCandidate base = candidates.front();
    Reader reader(*base.graph, base.match, context);
    reader.named(base);
    double cost = base.cost;
    for (RatedCandidate& r : reader.take()) {
        cost += 0.25;
        r.cost = std::max(r.cost, cost);
        r.graph = base.graph;
        candidates.push_back(std::move(r));
    }
}

}  // namespace ew
