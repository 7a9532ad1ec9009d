// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/shape_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "core/reading/evidence/hand_noise.h"
#include "core/reading/score/candidates.h"
#include "core/reading/score/planes_price.h"
#include "core/reading/solve/polyhedron_fit.h"
#include "core/tlib/library_index.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr double kLeastSnapDeg = 0.5;
/// What fits no better than this, in variances, is not worth the work.
constexpr double kHopeless = 10.0;

/// Was it closed behind what is seen? What is hidden of a prism or a pyramid follows from its
/// base.
bool isClosed(const ShapeHypothesis& h) { return h.lift >= 0; }

/// Does a model put two faces that meet in an edge into one plane?
bool flattens(const PlaneModel& model, const ShapeHypothesis& h) {
    std::map<std::pair<int, int>, int> faceOf;  // by directed edge
    const auto& faces = h.rough.faces;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        for (std::size_t k = 0; k < faces[f].size(); ++k) {
            faceOf[{faces[f][k], faces[f][(k + 1) % faces[f].size()]}] = static_cast<int>(f);
        }
    }
    return std::any_of(faceOf.begin(), faceOf.end(), [&](const auto& edge) {
        const auto other = faceOf.find({edge.first.second, edge.first.first});
        if (other == faceOf.end()) return false;
        const std::size_t a = at(edge.second);
        const std::size_t b = at(other->second);
        if (!h.pieceOf.empty() && h.pieceOf[a] == h.pieceOf[b]) return false;
        return model.faces[a].normal == model.faces[b].normal &&
               model.faces[a].sense == model.faces[b].sense;
    });
}

std::vector<DrawnVertex> seen(const ShapeHypothesis& h, const LineDrawing& drawing, double spread) {
    std::vector<DrawnVertex> out;
    for (std::size_t v = 0; v < h.node.size(); ++v) {
        if (h.node[v] < 0) continue;
        out.push_back({static_cast<int>(v), drawing.nodes[at(h.node[v])].at, spread});
    }
    return out;
}

std::vector<DrawnStretch> stretches(const ShapeHypothesis& h, double spread) {
    std::vector<DrawnStretch> out = h.stretches;
    for (DrawnStretch& s : out) s.spreadPx = spread;
    return out;
}

/// Has a face a hole of which no corner is seen? A hole through the solid may as well end
/// within it.
bool endsUnseen(const Solid& solid, const ShapeHypothesis& h) {
    // The solid's corners come in the order of the hypothesis where all of them were kept.
    if (solid.vertices().size() != h.node.size()) return false;
    return std::any_of(solid.faces().begin(), solid.faces().end(), [&](const SolidFace& f) {
        return std::any_of(f.loops.begin() + 1, f.loops.end(), [&](const auto& hole) {
            return std::all_of(hole.begin(), hole.end(), [&](int v) { return h.node[at(v)] < 0; });
        });
    });
}

/// Is the picture no larger than the drawing, by and large, and the solid not far deeper?
bool isWithin(const PlaneFit& f, const LineDrawing& drawing) {
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

std::string familyName(const std::string& family) {
    if (family == "prism") return "Prism";
    if (family == "pyramid") return "Pyramid";
    return family == "frustum" ? "Frustum" : "Solid";
}

}  // namespace

/// A proposal's least regular model, after a few steps.
struct ShapeSolver::Rough {
    std::optional<PlaneFit> fit;
    int redundancy = 0;  ///< numbers drawn beyond those that it takes
    bool tried = false;
};

void ShapeSolver::begin(const EdgeGraph& graph) {
    noise_ = drawnNoisePx(graph, ink_);
    spread_ = fitSpread_ =
        std::hypot(noise_, cornerSpread(ink_, options_.thresholds.distancePx, noise_));
}

std::vector<double> ShapeSolver::spreads() const {
    constexpr double kExactSpreadPx = 0.005;
    if (noise_ > params::kExactPx) return {spread_};
    return {kExactSpreadPx, spread_};
}

ShapeSolver::Rough ShapeSolver::roughFit(const ShapeHypothesis& h,
                                         const LineDrawing& drawing) const {
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
std::optional<double> ShapeSolver::exactSpread(const std::vector<Rough>& rough) const {
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

/// The model that costs least, its freedoms counted, of more and less regular ones.
std::optional<PlaneFit> ShapeSolver::fit(const ShapeHypothesis& h,
                                         const LineDrawing& drawing) const {
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
            if (flattens(model, h)) continue;
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

std::optional<SolvedShape> ShapeSolver::solve(const ShapeHypothesis& h,
                                              const LineDrawing& drawing) const {
    const auto f = fit(h, drawing);
    if (!f || !isWithin(*f, drawing)) return std::nullopt;
    Candidate c;
    place(*f, h, c);
    auto solid = Solid::fromSpec(c.spec);
    if (!solid) return std::nullopt;
    SolvedShape out{.candidate = std::move(c),
                    .cost = f->cost,
                    .misfit = f->misfit,
                    .solid = *std::move(solid),
                    .family = h.sides > 0,
                    .leastCorner = leastCorner(*f, h, drawing),
                    .exact = isExact(),
                    .lift = h.lift};
    // A careful hand's lines lie where the picture has them, but for what the fit itself
    // misses.
    const double missed = std::sqrt(f->misfit) * fitSpread_;
    const double near = std::min(options_.thresholds.distancePx,
                                 params::kLeastBesidePx + 3.0 * noise_ + 2.0 * missed);
    out.evidence = pictureEvidence(ink_, out.solid, out.candidate.pose, options_.camera, near,
                                   params::kThinFace * options_.thresholds.distancePx);
    Evidence& told = out.candidate.evidence;
    told.freedoms = params::kFreedomCost * f->model.freedoms();
    told.fit = f->misfit * static_cast<double>(drawing.nodes.size());
    told.stray = params::kStrayCost * out.evidence.strayPx / options_.thresholds.distancePx;
    told.bare = params::kStrayCost * out.evidence.barePx / options_.thresholds.distancePx;
    out.cost += told.stray + told.bare;
    out.cost += h.price;
    if (isClosed(h)) {
        out.cost += params::kUnseenCornerCost *
                    static_cast<double>(std::count(h.node.begin(), h.node.end(), -1));
        out.cost += params::kHiddenFrontCost * out.evidence.hiddenFronts;
    }
    describe(h, *f, out);
    out.guessed = endsUnseen(out.solid, h);
    const std::vector<double> sides = seenSides(*f, h);
    out.lines = static_cast<int>(sides.size());
    // The ends of so short a side may be one corner, which lines of this hand missed.
    out.tiny = !isExact() && std::any_of(sides.begin(), sides.end(), [&](double length) {
        return length < params::kTinySide * spread_;
    });
    return out;
}

namespace {

/// Where a face of a fit is seen, corner by corner [px].
std::vector<Vec2> pictureOf(const std::vector<int>& loop, const PlaneFit& f) {
    std::vector<Vec2> out;
    for (const int v : loop) out.push_back(f.camera[at(v)].head<2>());
    return out;
}

bool looksAtEye(const std::vector<Vec2>& face) {
    double area = 0.0;
    for (std::size_t k = 0; k < face.size(); ++k) {
        area += cross2(face[k], face[(k + 1) % face.size()]);
    }
    return area < 0.0;  // y is down
}

}  // namespace

/// Of the faces that look at the eye. Where a third line ends there is a corner.
double ShapeSolver::leastCorner(const PlaneFit& f, const ShapeHypothesis& h,
                                const LineDrawing& drawing) const {
    double least = std::numeric_limits<double>::infinity();
    const auto isSure = [&](int v) {
        const int node = h.node[at(v)];
        return node >= 0 && drawing.nodes[at(node)].out.size() > 2;
    };
    for (const std::vector<int>& loop : h.rough.faces) {
        const std::vector<Vec2> px = pictureOf(loop, f);
        if (!looksAtEye(px)) continue;
        const std::size_t n = px.size();
        const auto p = [&](std::size_t k) -> const Vec2& { return px[k % n]; };
        for (std::size_t k = 0; k < n; ++k) {
            const Vec2 chord = p(k + 2) - p(k);
            if (isSure(loop[(k + 1) % n])) continue;
            const double height =
                std::abs(cross2(chord, p(k + 1) - p(k))) / std::max(chord.norm(), 1e-6);
            least = std::min(least, height / spread_);
        }
    }
    return least;
}

std::vector<double> ShapeSolver::seenSides(const PlaneFit& f, const ShapeHypothesis& h) const {
    std::map<std::pair<int, int>, double> sides;
    for (const std::vector<int>& loop : h.rough.faces) {
        const std::vector<Vec2> px = pictureOf(loop, f);
        if (!looksAtEye(px)) continue;
        const std::size_t n = px.size();
        const auto p = [&](std::size_t k) -> const Vec2& { return px[k % n]; };
        for (std::size_t k = 0; k < n; ++k) {
            sides[std::minmax(loop[k], loop[(k + 1) % n])] = (p(k + 1) - p(k)).norm();
        }
    }
    std::vector<double> out;
    for (const auto& [side, length] : sides) out.push_back(length);
    return out;
}

/// In millimetres and in the world, with the nearest corner in the Sketch Plane.
void ShapeSolver::place(const PlaneFit& f, const ShapeHypothesis& h, Candidate& c) const {
    const double scale = options_.camera.worldPerPixel;
    for (const Vec3& p : f.body) c.spec.vertices.push_back(scale * p);
    c.spec.faces = h.rough.faces;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3& p : f.camera) nearest = std::min(nearest, p.z());
    c.pose.rotation = options_.camera.cameraToWorld() * f.model.bodyToCamera;
    c.pose.translation =
        options_.camera.unproject(f.model.center.head<2>(), f.model.center.z() - nearest);
}

void ShapeSolver::describe(const ShapeHypothesis& h, const PlaneFit& f, SolvedShape& out) const {
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
const LibraryEntry* ShapeSolver::templateOf(const PlaneModel& model,
                                            const PolyhedronSpec& spec) const {
    const auto sizes = [](const PolyhedronSpec& s) {
        std::multiset<std::size_t> out;
        for (const auto& face : s.faces) out.insert(face.size());
        return out;
    };
    const bool upright =
        std::all_of(model.normals.begin(), model.normals.end(), [](const PlaneModel::Normal& n) {
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

bool ShapeSolver::solveAll(const std::vector<ShapeHypothesis>& proposals,
                           const LineDrawing& drawing, int lifts, std::vector<SolvedShape>& found) {
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
        explained = explained || s->explains();
        if (s->lift >= 0) s->lift += lifts;
        found.push_back(std::move(*s));
    }
    return explained;
}

}  // namespace ew
