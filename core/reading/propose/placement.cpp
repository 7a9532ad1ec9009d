// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/placement.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include "core/base/tolerance.h"
#include "core/reading/propose/kept_wall.h"
#include "core/reading/propose/placement_faces.h"
#include "core/reading/propose/placement_price.h"
#include "core/reading/propose/placement_tool.h"
#include "core/reading/solve/anchor_start.h"
#include "core/reading/solve/placement_directions.h"
#include "core/reading/solve/placement_relations.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class Placer {
  public:
    Placer(const JointGraph& joint, const JointReading& reading, const GraphMatch& match,
           const ModelView& model, const PlacementOptions& options)
        : joint_(joint),
          reading_(reading),
          match_(match),
          tmpl_(match.entry->tmpl),
          analysis_(match.entry->analysis),
          model_(model),
          options_(options),
          sighting_(sightingOf(reading.graph, match, options.thresholds.distancePx)) {
        // Slight evidence may be overruled as far as the hand is unsteady.
        sighting_.doubt = std::clamp(options.noisePx - tol::kNoiseFloorPx, 0.0, 1.0);
        for (const Junction& j : reading.graph.junctions) center_ += j.position;
        center_ /= static_cast<double>(reading.graph.junctions.size());
    }

    std::vector<Placement> run() {
        if (match_.aspect->kind == AspectKind::Explicit) {
            for (std::size_t t = 0; t < tmpl_.shape.faces.size(); ++t) {
                const int ti = static_cast<int>(t);
                const auto& seen = match_.aspect->visibleFaces;
                if (std::find(seen.begin(), seen.end(), ti) != seen.end()) continue;
                for (const int f : facesUnder(ti, reading_, match_, model_, sighting_, true))
                    attempt({{ti, f}}, Operation::Add);
            }
        } else {
            FacePairs pairs;
            for (const int t : match_.aspect->mouth) {
                const std::vector<int> faces =
                    facesUnder(t, reading_, match_, model_, sighting_, false);
                if (faces.empty()) return {};
                pairs.push_back({t, faces.front()});
            }
            attempt(pairs, Operation::Cut);
        }
        std::stable_sort(out_.begin(), out_.end(),
                         [](const Placement& a, const Placement& b) { return a.cost < b.cost; });
        return std::move(out_);
    }

    /// See placementsOn.
    std::vector<Placement> on(const Seat& seat) {
        attempt(seat.faces, seat.operation);
        return std::move(out_);
    }

    /// See adjustedPlacement.
    std::optional<Placement> adjusted(const Placement& placed, int face) const {
        const Vec3 n = model_.plane(face).normal;
        for (const int t : hiddenFaces(placed)) {
            const auto& loop = tmpl_.shape.faces[at(t)];
            const Vec3 m = (placed.points[at(loop[1])] - placed.points[at(loop[0])])
                               .cross(placed.points[at(loop[2])] - placed.points[at(loop[0])])
                               .normalized();
            if (m.cross(n).norm() > tol::kSolidDirection) continue;
            FacePairs pairs = placed.coinciding;
            pairs.push_back({t, face});
            KeptRelations keep;
            keep.overrule = true;
            auto moved = solve(pairs, placed.operation, placed.directions, keep);
            if (!moved) continue;
            // Which side of the new plane it comes to lie on does not matter.
            moved->coinciding.pop_back();
            const bool fits = onItsSide(*moved);
            moved->coinciding.push_back({t, face});
            if (fits) return moved;
        }
        return std::nullopt;
    }

    /// See clearPlacement.
    std::optional<Placement> clearOf(const Placement& placed, const std::vector<int>& met) const {
        if (!analysis_.convex) return std::nullopt;
        const auto wall = wallClearOf(tmpl_.shape.faces, placed.points, hiddenFaces(placed), model_,
                                      met, options_.thresholds.distancePx);
        Placement moved = placed;
        if (!wall || !moveWall(*wall, tmpl_.shape.faces, moved.points)) return std::nullopt;
        const auto& loop = tmpl_.shape.faces[at(wall->face)];
        std::erase_if(moved.tool.vertices, [&](const ToolVertexRule& r) {
            return std::find(loop.begin(), loop.end(), r.vertex) != loop.end();
        });
        moved.residualPx = residualPx(sighting_, analysis_, moved.points);
        moved.misfit = misfitOf(sighting_, analysis_, moved.points, options_.noisePx);
        return finishTool(moved, tmpl_, model_) ? std::optional(std::move(moved)) : std::nullopt;
    }

  private:
    /// Faces of the template that were neither drawn nor lie in a face of the solid.
    std::vector<int> hiddenFaces(const Placement& placed) const {
        std::vector<int> hidden;
        for (std::size_t t = 0; t < tmpl_.shape.faces.size(); ++t) {
            const int ti = static_cast<int>(t);
            const auto& seen = sighting_.visibleFaces;
            const bool drawn = match_.aspect->kind == AspectKind::Explicit &&
                               std::find(seen.begin(), seen.end(), ti) != seen.end();
            if (!drawn && !coincides(placed.coinciding, ti)) hidden.push_back(ti);
        }
        return hidden;
    }

    bool coincides(const FacePairs& pairs, int templateFace) const {
        return std::any_of(pairs.begin(), pairs.end(),
                           [&](const auto& p) { return p[0] == templateFace; });
    }

    /// Faces of the solid that a template vertex lies in by these pairs.
    std::vector<int> facesOf(const FacePairs& pairs, int vertex) const {
        std::vector<int> faces;
        for (const auto& p : pairs) {
            const auto& loop = tmpl_.shape.faces[at(p[0])];
            if (std::find(loop.begin(), loop.end(), vertex) != loop.end()) faces.push_back(p[1]);
        }
        return faces;
    }

    void addPlanes(Anchors& anchors, const FacePairs& pairs) const {
        for (const auto& [t, f] : pairs) {
            const CameraPlane plane = model_.plane(f);
            Vec2 near = center_;
            for (const int v : tmpl_.shape.faces[at(t)]) {
                if (sighting_.seen[at(v)]) near = sighting_.vertexPx[at(v)];
            }
            for (const int v : tmpl_.shape.faces[at(t)]) {
                anchors.planes.push_back({v, plane.normal, plane.offset, near});
            }
        }
    }

    void addPlaces(Anchors& anchors, ToolSpec& tool, const FacePairs& pairs,
                   const std::set<int>& loose) const {
        for (std::size_t j = 0; j < reading_.junctionNode.size(); ++j) {
            const int v = match_.vertex[j];
            const JointNode& node = joint_.nodes[at(reading_.junctionNode[j])];
            if (v < 0 || loose.contains(v)) continue;
            const std::vector<int> faces = facesOf(pairs, v);
            if (faces.empty()) continue;
            const auto inAll = [&](auto&& test) {
                return std::all_of(faces.begin(), faces.end(), test);
            };
            if (node.modelVertex >= 0 &&
                inAll([&](int f) { return model_.vertexInFace(node.modelVertex, f); })) {
                anchors.points.push_back({v, model_.vertex(node.modelVertex)});
                tool.vertices.push_back(
                    {v, ToolVertexRule::Kind::AtVertex, node.modelVertex, -1, 0.0});
            } else if (node.modelEdge >= 0 &&
                       inAll([&](int f) { return model_.edgeInFace(node.modelEdge, f); })) {
                const int end = model_.solid().edges()[at(node.modelEdge)].ends[0];
                anchors.lines.push_back(
                    {v, model_.vertex(end), model_.edgeDirection(node.modelEdge)});
                tool.vertices.push_back({v, ToolVertexRule::Kind::OnEdge, node.modelEdge, -1, 0.0});
            }
        }
    }

    struct Best {
        std::optional<Placement> placed;
        DirectionAssignment directions;
        KeptRelations keep;
    };

    /// Tries directions of the model, the most obvious first; the cheapest explanation counts.
    void attempt(const FacePairs& pairs, Operation operation) {
        if (!distinctPlanes(pairs)) return;
        constexpr std::size_t kMostAssignments = 40;
        constexpr int kMostIterated = 5;
        const auto assignments = directionAssignments(
            reading_, match_, model_, pairs, {options_.thresholds.angleDeg, options_.noisePx},
            kMostAssignments);
        Best best;
        int iterated = 0;
        for (const DirectionAssignment& a : assignments) {
            const bool linear = isLinear(tmpl_, analysis_, a.known());
            if (!linear && (options_.plain || ++iterated > kMostIterated)) continue;
            if (best.placed && a.cost >= best.placed->cost) continue;
            consider(pairs, operation, a, {}, best);
            // What agrees with the ink needs no second opinion.
            if (best.placed && agrees(*best.placed)) break;
        }
        evenSlopes(pairs, operation, assignments, best);
        if (!(best.placed && agrees(*best.placed))) loosen(pairs, operation, assignments, best);
        if (!options_.plain && !(best.placed && agrees(*best.placed))) {
            DirectionAssignment none;
            none.byClass.resize(at(analysis_.classCount));
            for (const KeptRelations& keep :
                 {KeptRelations{false, true}, KeptRelations{false, false}}) {
                consider(pairs, operation, none, keep, best);
            }
        }
        // A body whose picture leaves something open is regular where it can be.
        if (best.placed && best.placed->open > 0 && operation == Operation::Add) {
            KeptRelations regular = best.keep;
            regular.regular = true;
            consider(pairs, operation, best.directions, regular, best);
        }
        if (!best.placed) return;
        auto flush = snapFaces(*best.placed, best.directions, best.keep);
        if (flush && onItsSide(*flush)) best.placed = std::move(flush);
        out_.push_back(std::move(*best.placed));
    }

    /// Grooves and roofs with both slopes as steep. Whether they are said to be or to have one
    /// upright is for the ink to tell: both leave as much open.
    void evenSlopes(const FacePairs& pairs, Operation operation,
                    const std::vector<DirectionAssignment>& assignments, Best& best) const {
        const std::vector<Ridge> ridges = ridgesOf(tmpl_, analysis_, pairs);
        if (ridges.empty()) return;
        for (const DirectionAssignment& a : assignments) {
            if (!isLinear(tmpl_, analysis_, a.known())) continue;
            if (!slopesAreFree(ridges, analysis_, a)) continue;
            KeptRelations even;
            even.symmetric = true;
            consider(pairs, operation, a, even, best);
            return;
        }
    }

    /// What was drawn near an edge or a corner of the solid need not be meant to lie there: tries
    /// without each of these places, and without all.
    void loosen(const FacePairs& pairs, Operation operation,
                const std::vector<DirectionAssignment>& assignments, Best& best) const {
        constexpr std::size_t kMostDirections = 6;
        std::vector<std::set<int>> choices(1);
        for (std::size_t j = 0; j < reading_.junctionNode.size(); ++j) {
            const int v = match_.vertex[j];
            const JointNode& node = joint_.nodes[at(reading_.junctionNode[j])];
            if (v < 0 || (node.modelVertex < 0 && node.modelEdge < 0)) continue;
            if (facesOf(pairs, v).empty() || !byChance(static_cast<int>(j))) continue;
            choices.push_back({v});
            choices.front().insert(v);
        }
        if (choices.size() == 2) choices.pop_back();
        if (choices.front().empty()) return;
        for (const std::set<int>& loose : choices) {
            std::size_t tried = 0;
            for (const DirectionAssignment& a : assignments) {
                if (!isLinear(tmpl_, analysis_, a.known())) continue;
                if (++tried > kMostDirections) break;
                consider(pairs, operation, a, KeptRelations{true, true, loose}, best);
                if (best.placed && agrees(*best.placed)) return;
            }
        }
    }

    /// No edge of the model that is part of the reading ends at this junction.
    bool byChance(int junction) const {
        for (std::size_t e = 0; e < reading_.graph.edges.size(); ++e) {
            const auto& ends = reading_.graph.edges[e].ends;
            const bool here = ends[0] == junction || ends[1] == junction;
            if (here && reading_.edgeModel[e] >= 0) return false;
        }
        return true;
    }

    bool agrees(const Placement& p) const {
        return p.misfit <= static_cast<double>(sighting_.edges.size());
    }

    void consider(const FacePairs& pairs, Operation operation, const DirectionAssignment& a,
                  const KeptRelations& keep, Best& best) const {
        auto placed = solve(pairs, operation, a, keep);
        if (!placed) return;
        if (placed->open > 0 && operation == Operation::Cut) {
            if (auto through = reachThrough(*placed, a, keep)) placed = std::move(through);
        }
        if (!onItsSide(*placed)) return;
        if (!best.placed || placed->cost < best.placed->cost) {
            best = {std::move(placed), a, keep};
        }
    }

    bool distinctPlanes(const FacePairs& pairs) const {
        std::set<int> faces;
        for (const auto& p : pairs) {
            if (!faces.insert(p[1]).second) return false;
        }
        return true;
    }

    std::optional<Placement> solve(const FacePairs& pairs, Operation operation,
                                   const DirectionAssignment& directions,
                                   const KeptRelations& keep) const {
        Anchors anchors;
        Placement out;
        out.operation = operation;
        out.coinciding = pairs;
        addPlanes(anchors, pairs);
        addPlaces(anchors, out.tool, pairs, keep.loose);
        for (std::size_t e = 0; e < analysis_.edges.size(); ++e) {
            const auto& d = directions.byClass[at(analysis_.edges[e].directionClass)];
            if (!d) continue;
            anchors.directions.push_back({static_cast<int>(e), d->direction});
            out.tool.edges.push_back({analysis_.edges[e].ends, d->kind, d->index, d->other});
        }
        if (keep.symmetric) {
            for (const Ridge& r : ridgesOf(tmpl_, analysis_, pairs)) {
                anchors.medians.push_back({r.apex, r.base, model_.plane(r.face).normal});
            }
        }
        const auto solution = solved(anchors, directions, keep, operation);
        if (!solution) return std::nullopt;
        out.points = solution->points;
        out.residualPx = residualPx(sighting_, analysis_, out.points);
        if (!(out.residualPx <= most()) && !keep.overrule) return std::nullopt;
        out.directions = directions;
        out.misfit = misfitOf(sighting_, analysis_, out.points, options_.noisePx);
        out.open = solution->freedoms;
        out.parameters = solution->parameters;
        out.cost = out.misfit + directions.cost +
                   tol::kStrangeDirectionCost *
                       (strangeDirections(out, analysis_, model_) - (keep.symmetric ? 1 : 0)) +
                   tol::kFreedomCost * solution->parameters +
                   tol::kUnseenPlaneCost * solution->freedoms +
                   tol::kModelEdgeCost * reading_.modelEdges;
        return finishTool(out, tmpl_, model_) ? std::optional<Placement>(std::move(out))
                                              : std::nullopt;
    }

    double most() const { return tol::kClearResidual * options_.thresholds.distancePx; }

    /// In closed form where that can be. What an added body leaves open is closed by regularity,
    /// which takes iterations.
    std::optional<GeneralSolution> solved(const Anchors& anchors,
                                          const DirectionAssignment& directions,
                                          const KeptRelations& keep, Operation operation) const {
        const KnownDirections known = directions.known();
        if (keep.perpendicular && keep.parallel && !keep.regular &&
            isLinear(tmpl_, analysis_, known)) {
            auto linear = solveLinearly(tmpl_, analysis_, sighting_, anchors, known);
            if (!linear || linear->freedoms == 0 || operation == Operation::Cut) return linear;
        }
        if (options_.plain) return std::nullopt;
        const CameraPoints start = anchoredStart(tmpl_, analysis_, sighting_, anchors);
        // Anchors and directions are in the start already; it is never far from the solution.
        if (!(residualPx(sighting_, analysis_, start) <= tol::kStartResidual * most())) {
            return std::nullopt;
        }
        return solveAnchored(tmpl_, analysis_, sighting_,
                             keptRelations(tmpl_, analysis_, directions, keep), anchors, start);
    }

    /// A cut lies behind the faces that it opens in, an added body before the one it stands on.
    bool onItsSide(const Placement& p) const {
        Vec3 middle = Vec3::Zero();
        for (const Vec3& x : p.points) middle += x;
        middle /= static_cast<double>(p.points.size());
        const double sign = p.operation == Operation::Cut ? -1.0 : 1.0;
        return std::all_of(p.coinciding.begin(), p.coinciding.end(), [&](const auto& pair) {
            const CameraPlane plane = model_.plane(pair[1]);
            const double least = 1e-6 * sighting_.sizePx;
            // Flush sides lie on the other side of their plane.
            const bool base = pair[0] == p.coinciding.front()[0] || p.operation == Operation::Cut;
            return !base || sign * (plane.normal.dot(middle) - plane.offset) > least;
        });
    }

    /// A hole whose bottom is not to be seen goes through: the face across from its mouth lies in
    /// the farthest face of the solid that looks away from the mouth's.
    std::optional<Placement> reachThrough(const Placement& placed,
                                          const DirectionAssignment& directions,
                                          const KeptRelations& keep) const {
        FacePairs pairs = placed.coinciding;
        const CameraPlane mouth = model_.plane(pairs.front()[1]);
        int across = -1;
        for (std::size_t t = 0; t < tmpl_.shape.faces.size(); ++t) {
            if (coincides(pairs, static_cast<int>(t))) continue;
            if (analysis_.faceNormals[t].dot(analysis_.faceNormals[at(pairs.front()[0])]) <
                -1 + tol::kSolidDirection) {
                across = static_cast<int>(t);
            }
        }
        double deepest = 0;
        int bottom = -1;
        for (std::size_t f = 0; f < model_.solid().faces().size(); ++f) {
            const CameraPlane& plane = model_.plane(static_cast<int>(f));
            if (plane.normal.dot(mouth.normal) > -1 + tol::kSolidDirection) continue;
            const double depth = mouth.offset + plane.offset;
            if (depth > deepest) {
                deepest = depth;
                bottom = static_cast<int>(f);
            }
        }
        if (across < 0 || bottom < 0) return std::nullopt;
        pairs.push_back({across, bottom});
        return solve(pairs, placed.operation, directions, keep);
    }

    /// Faces that come within the distance threshold of a parallel face of the solid lie in it,
    /// walls of hollows out of sight only where the hand cannot tell the two apart.
    std::optional<Placement> snapFaces(const Placement& placed,
                                       const DirectionAssignment& directions,
                                       const KeptRelations& keep) const {
        FacePairs pairs = placed.coinciding;
        const std::size_t before = pairs.size();
        for (std::size_t t = 0; t < tmpl_.shape.faces.size(); ++t) {
            if (coincides(pairs, static_cast<int>(t))) continue;
            const auto& loop = tmpl_.shape.faces[t];
            const Vec3 n = (placed.points[at(loop[1])] - placed.points[at(loop[0])])
                               .cross(placed.points[at(loop[2])] - placed.points[at(loop[0])])
                               .normalized();
            double least = options_.thresholds.distancePx;
            int best = -1;
            for (std::size_t f = 0; f < model_.solid().faces().size(); ++f) {
                const CameraPlane& plane = model_.plane(static_cast<int>(f));
                if (plane.normal.cross(n).norm() > tol::kSolidDirection) continue;
                const double off =
                    std::abs(plane.normal.dot(placed.points[at(loop[0])]) - plane.offset);
                if (off < least && near(placed, loop, static_cast<int>(f)) &&
                    (off < options_.noisePx || model_.known(static_cast<int>(f)))) {
                    least = off;
                    best = static_cast<int>(f);
                }
            }
            if (best >= 0) pairs.push_back({static_cast<int>(t), best});
        }
        if (pairs.size() == before) return std::nullopt;
        return solve(pairs, placed.operation, directions, keep);
    }

    /// Does a face of the tool come near a face of the solid in space? Parallel planes far apart
    /// sideways are no reason to be flush. In the body's frame, where most faces lie along the
    /// axes.
    bool near(const Placement& p, const std::vector<int>& loop, int face) const {
        Eigen::AlignedBox3d tool;
        Eigen::AlignedBox3d other;
        for (const int v : loop) tool.extend(model_.toBody(p.points[at(v)]));
        for (const int v : model_.solid().faces()[at(face)].loops.front()) {
            other.extend(model_.solid().vertices()[at(v)]);
        }
        const double mm = (model_.toBody(Vec3::UnitX()) - model_.toBody(Vec3::Zero())).norm();
        const double reach = mm * options_.thresholds.distancePx;
        return tool.exteriorDistance(other) < reach;
    }

    const JointGraph& joint_;
    const JointReading& reading_;
    const GraphMatch& match_;
    const Template& tmpl_;
    const TemplateAnalysis& analysis_;
    const ModelView& model_;
    const PlacementOptions& options_;
    Sighting sighting_;
    Vec2 center_ = Vec2::Zero();
    std::vector<Placement> out_;
};

}  // namespace

std::vector<Placement> placementsOf(const JointGraph& joint, const JointReading& reading,
                                    const GraphMatch& match, const ModelView& model,
                                    const PlacementOptions& options) {
    return Placer(joint, reading, match, model, options).run();
}

std::vector<Placement> placementsOn(const Seat& seat, const JointGraph& joint,
                                    const JointReading& reading, const GraphMatch& match,
                                    const ModelView& model, const PlacementOptions& options) {
    return Placer(joint, reading, match, model, options).on(seat);
}

std::optional<Placement> adjustedPlacement(const JointGraph& joint, const JointReading& reading,
                                           const GraphMatch& match, const ModelView& model,
                                           const PlacementOptions& options,
                                           const Placement& placement, int face) {
    return Placer(joint, reading, match, model, options).adjusted(placement, face);
}

std::optional<Placement> clearPlacement(const JointGraph& joint, const JointReading& reading,
                                        const GraphMatch& match, const ModelView& model,
                                        const PlacementOptions& options, const Placement& placement,
                                        const std::vector<int>& faces) {
    return Placer(joint, reading, match, model, options).clearOf(placement, faces);
}

}  // namespace ew
