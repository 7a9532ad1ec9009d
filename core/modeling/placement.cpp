// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/modeling/placement.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>

#include "core/base/tolerance.h"
#include "core/modeling/anchor_start.h"
#include "core/modeling/model_directions.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

using FacePairs = std::vector<std::array<int, 2>>;

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
                for (const int f : facesUnder(ti, true)) attempt({{ti, f}}, Operation::Add);
            }
        } else {
            FacePairs pairs;
            for (const int t : match_.aspect->mouth) {
                const std::vector<int> faces = facesUnder(t, false);
                if (faces.empty()) return {};
                pairs.push_back({t, faces.front()});
            }
            attempt(pairs, Operation::Cut);
        }
        std::stable_sort(out_.begin(), out_.end(),
                         [](const Placement& a, const Placement& b) { return a.cost < b.cost; });
        return std::move(out_);
    }

  private:
    /// Faces of the solid that a template face may lie in, those with the most evidence first.
    std::vector<int> facesUnder(int t, bool outside) const {
        constexpr double kAsidePx = 4.0;
        Vec2 middle = Vec2::Zero();
        int count = 0;
        for (const int v : tmpl_.shape.faces[at(t)]) {
            if (!sighting_.seen[at(v)]) continue;
            middle += sighting_.vertexPx[at(v)];
            ++count;
        }
        if (count > 0) middle /= count;
        std::map<int, int> votes;
        for (std::size_t g = 0; g < reading_.graph.edges.size(); ++g) {
            const auto& faces = analysis_.edges[at(match_.edge[g])].faces;
            if (faces[0] != t && faces[1] != t) continue;
            if (const int m = reading_.edgeModel[g]; m >= 0) {
                for (const int f : model_.solid().edges()[at(m)].faces) votes[f] += 2;
            }
            const GraphEdge& e = reading_.graph.edges[g];
            for (const double share : {0.3, 0.5, 0.7}) {
                const Vec2 p = (1 - share) * e.tips[0] + share * e.tips[1];
                const Vec2 d = (e.tips[1] - e.tips[0]).normalized();
                Vec2 aside(-d.y(), d.x());
                const bool away = aside.dot(p - (outside ? center_ : middle)) > 0;
                if (away != outside) aside = -aside;
                if (const auto f = model_.faceAt(p + kAsidePx * aside)) ++votes[*f];
            }
        }
        std::vector<int> faces;
        for (const auto& [f, n] : votes) {
            if (model_.view().facing(f) == Facing::Front) faces.push_back(f);
        }
        std::stable_sort(faces.begin(), faces.end(),
                         [&](int a, int b) { return votes[a] > votes[b]; });
        if (faces.size() > 3) faces.resize(3);
        return faces;
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

    void addPlaces(Anchors& anchors, ToolSpec& tool, const FacePairs& pairs) const {
        for (std::size_t j = 0; j < reading_.junctionNode.size(); ++j) {
            const int v = match_.vertex[j];
            const JointNode& node = joint_.nodes[at(reading_.junctionNode[j])];
            if (v < 0) continue;
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

    /// What is drawn of a direction class on the screen.
    struct DrawnClass {
        Vec2 doubled = Vec2::Zero();  ///< sum of lengths times doubled direction
        double length = 0.0;
        std::vector<int> inFaces;  ///< faces of the solid that its edges lie in
        int modelEdge = -1;        ///< one of its edges is this edge of the solid
    };

    std::vector<DrawnClass> drawnClasses(const FacePairs& pairs) const {
        std::vector<DrawnClass> classes(at(analysis_.classCount));
        for (std::size_t g = 0; g < reading_.graph.edges.size(); ++g) {
            const AnalysedEdge& e = analysis_.edges[at(match_.edge[g])];
            DrawnClass& c = classes[at(e.directionClass)];
            const Vec2 d = reading_.graph.edges[g].tips[1] - reading_.graph.edges[g].tips[0];
            const double len = std::max(d.norm(), 1e-9);
            c.doubled += Vec2(d.x() * d.x() - d.y() * d.y(), 2 * d.x() * d.y()) / len;
            c.length += len;
            if (reading_.edgeModel[g] >= 0 &&
                (coincides(pairs, e.faces[0]) || coincides(pairs, e.faces[1]))) {
                c.modelEdge = reading_.edgeModel[g];
            }
        }
        for (const AnalysedEdge& e : analysis_.edges) {
            for (const auto& p : pairs) {
                if (e.faces[0] == p[0] || e.faces[1] == p[0]) {
                    classes[at(e.directionClass)].inFaces.push_back(p[1]);
                }
            }
        }
        return classes;
    }

    using Snaps = std::vector<std::optional<ModelDirection>>;  ///< per direction class

    Snaps snapDirections(const FacePairs& pairs) {
        std::vector<int> faces;
        for (const auto& p : pairs) faces.push_back(p[1]);
        const std::vector<ModelDirection> known = directionsNear(model_, faces);
        Snaps snaps;
        inFaces_.clear();
        for (const DrawnClass& c : drawnClasses(pairs)) {
            inFaces_.push_back(!c.inFaces.empty());
            std::optional<ModelDirection> best;
            if (c.modelEdge >= 0) {
                best = ModelDirection{model_.edgeDirection(c.modelEdge),
                                      ToolEdgeRule::Kind::AlongEdge, c.modelEdge};
            } else if (c.length > 0) {
                best = nearest(known, c, pairs);
            }
            snaps.push_back(best);
        }
        return snaps;
    }

    std::optional<ModelDirection> nearest(const std::vector<ModelDirection>& known,
                                          const DrawnClass& c, const FacePairs& pairs) const {
        constexpr double kRadian = 180.0 / std::numbers::pi;
        constexpr double kNormalBonusDeg = 2.0;
        const double drawn = 0.5 * std::atan2(c.doubled.y(), c.doubled.x());
        const double excuse = std::atan(options_.noisePx / std::max(0.5 * c.length, 1.0)) * kRadian;
        double least = options_.thresholds.angleDeg + excuse;
        std::optional<ModelDirection> best;
        for (const ModelDirection& d : known) {
            if (d.direction.head<2>().norm() < tol::kEndOnSine) continue;
            const bool lies = std::all_of(c.inFaces.begin(), c.inFaces.end(), [&](int f) {
                return std::abs(model_.plane(f).normal.dot(d.direction)) < tol::kSolidDirection;
            });
            if (!lies) continue;
            const double angle = std::atan2(d.direction.y(), d.direction.x());
            double off = std::abs(std::remainder(angle - drawn, std::numbers::pi)) * kRadian;
            // A wall is usually meant to stand upright on its face.
            const bool upright =
                c.inFaces.empty() && d.kind == ToolEdgeRule::Kind::AlongNormal &&
                std::any_of(pairs.begin(), pairs.end(), [&](const auto& p) {
                    return std::abs(model_.plane(p[1]).normal.dot(d.direction)) > 1 - 1e-9;
                });
            if (upright) off -= kNormalBonusDeg;
            if (off <= least) {
                least = off;
                best = d;
            }
        }
        return best;
    }

    /// Which directions are the model's, and which of its own relations the template keeps.
    struct Freedom {
        enum class Snap { All, InFaces, None };
        Snap snap = Snap::All;
        bool perpendicular = true;
        bool parallel = true;
    };

    SolverRelations relationsFor(const Snaps& snaps, const Freedom& freedom) const {
        const SolverRelations all = solverRelations(analysis_);
        SolverRelations r;
        if (freedom.parallel) {
            for (const auto& group : all.parallel) {
                if (!taken(snaps, group.front(), freedom)) r.parallel.push_back(group);
            }
        }
        if (!freedom.perpendicular) return r;
        for (const auto& pair : all.perpendicular) {
            // What the model says of two directions stands above the template.
            const bool told = taken(snaps, pair[0], freedom) && taken(snaps, pair[1], freedom);
            if (!told) r.perpendicular.push_back(pair);
        }
        return r;
    }

    bool taken(const Snaps& snaps, int edge, const Freedom& freedom) const {
        const AnalysedEdge& e = analysis_.edges[at(edge)];
        if (!snaps[at(e.directionClass)] || freedom.snap == Freedom::Snap::None) return false;
        return freedom.snap == Freedom::Snap::All || inFaces_[at(e.directionClass)];
    }

    /// Solves with less and less that is taken for granted; the cheapest explanation counts.
    void attempt(const FacePairs& pairs, Operation operation) {
        if (!distinctPlanes(pairs)) return;
        using Snap = Freedom::Snap;
        static const std::vector<Freedom> kFreedoms{
            {Snap::All, true, true},  {Snap::InFaces, true, true}, {Snap::None, true, true},
            {Snap::All, false, true}, {Snap::None, false, true},   {Snap::None, false, false}};
        const Snaps snaps = snapDirections(pairs);
        std::optional<Placement> best;
        Freedom with;
        for (const Freedom& f : kFreedoms) {
            if (options_.plain && &f != &kFreedoms.front()) break;
            auto placed = solve(pairs, operation, snaps, f);
            if (!placed) continue;
            if (placed->open > 0 && operation == Operation::Cut) {
                if (auto through = reachThrough(*placed, snaps, f)) placed = std::move(through);
            }
            if (!onItsSide(*placed)) continue;
            if (!best || placed->cost < best->cost) {
                best = std::move(placed);
                with = f;
            }
            // What agrees with the ink needs no second opinion.
            if (best->misfit <= static_cast<double>(sighting_.edges.size())) break;
        }
        if (!best) return;
        auto flush = snapFaces(*best, snaps, with);
        if (flush && onItsSide(*flush)) best = std::move(flush);
        out_.push_back(std::move(*best));
    }

    bool distinctPlanes(const FacePairs& pairs) const {
        std::set<int> faces;
        for (const auto& p : pairs) {
            if (!faces.insert(p[1]).second) return false;
        }
        return true;
    }

    std::optional<Placement> solve(const FacePairs& pairs, Operation operation, const Snaps& snaps,
                                   const Freedom& freedom) const {
        Anchors anchors;
        Placement out;
        out.operation = operation;
        out.coinciding = pairs;
        addPlanes(anchors, pairs);
        addPlaces(anchors, out.tool, pairs);
        for (std::size_t e = 0; e < analysis_.edges.size(); ++e) {
            if (!taken(snaps, static_cast<int>(e), freedom)) continue;
            const auto& snap = snaps[at(analysis_.edges[e].directionClass)];
            anchors.directions.push_back({static_cast<int>(e), snap->direction});
            out.tool.edges.push_back({analysis_.edges[e].ends, snap->kind, snap->index});
        }
        const CameraPoints start = anchoredStart(tmpl_, analysis_, sighting_, anchors);
        const double most = tol::kClearResidual * options_.thresholds.distancePx;
        // Anchors and directions are in the start already; it is never far from the solution.
        if (!(residualPx(sighting_, analysis_, start) <= tol::kStartResidual * most)) {
            return std::nullopt;
        }
        const auto solution = solveAnchored(tmpl_, analysis_, sighting_,
                                            relationsFor(snaps, freedom), anchors, start);
        if (!solution) return std::nullopt;
        out.points = solution->points;
        out.residualPx = residualPx(sighting_, analysis_, out.points);
        if (!(out.residualPx <= most)) return std::nullopt;
        out.misfit = misfit(out.points);
        out.open = solution->freedoms;
        const int strange = strangeDirections(out);
        out.cost = out.misfit + tol::kStrangeDirectionCost * strange +
                   tol::kFreedomCost * solution->parameters +
                   tol::kUnseenPlaneCost * solution->freedoms +
                   tol::kModelEdgeCost * reading_.modelEdges;
        return finishTool(out) ? std::optional<Placement>(std::move(out)) : std::nullopt;
    }

    /// Direction classes that come out along no direction of the model nearby.
    int strangeDirections(const Placement& p) const {
        std::vector<int> faces;
        for (const auto& pair : p.coinciding) faces.push_back(pair[1]);
        const std::vector<ModelDirection> known = directionsNear(model_, faces);
        std::vector<bool> strange(at(analysis_.classCount), true);
        for (const AnalysedEdge& e : analysis_.edges) {
            const Vec3 d = (p.points[at(e.ends[1])] - p.points[at(e.ends[0])]).normalized();
            if (std::any_of(known.begin(), known.end(), [&](const ModelDirection& k) {
                    return k.direction.cross(d).norm() < tol::kSolidDirection;
                })) {
                strange[at(e.directionClass)] = false;
            }
        }
        return static_cast<int>(std::count(strange.begin(), strange.end(), true));
    }

    double misfit(const CameraPoints& points) const {
        const double variance =
            std::max(options_.noisePx * options_.noisePx, tol::kNoiseFloorPx * tol::kNoiseFloorPx);
        double sum = 0;
        for (const DrawnEdge& d : sighting_.edges) {
            const auto& ends = analysis_.edges[at(d.edge)].ends;
            const Vec2 a = points[at(ends[0])].head<2>();
            const Vec2 u = points[at(ends[1])].head<2>() - a;
            for (const Vec2& tip : d.tips) {
                const double off = cross2(u, tip - a) / std::max(u.norm(), 1e-9);
                sum += off * off / variance;
            }
        }
        return sum;
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
    std::optional<Placement> reachThrough(const Placement& placed, const Snaps& snaps,
                                          const Freedom& freedom) const {
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
            const CameraPlane plane = model_.plane(static_cast<int>(f));
            if (plane.normal.dot(mouth.normal) > -1 + tol::kSolidDirection) continue;
            const double depth = mouth.offset + plane.offset;
            if (depth > deepest) {
                deepest = depth;
                bottom = static_cast<int>(f);
            }
        }
        if (across < 0 || bottom < 0) return std::nullopt;
        pairs.push_back({across, bottom});
        return solve(pairs, placed.operation, snaps, freedom);
    }

    /// Faces that come within the distance threshold of a parallel face of the solid lie in it.
    std::optional<Placement> snapFaces(const Placement& placed, const Snaps& snaps,
                                       const Freedom& freedom) const {
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
                const CameraPlane plane = model_.plane(static_cast<int>(f));
                if (plane.normal.cross(n).norm() > tol::kSolidDirection) continue;
                const double off =
                    std::abs(plane.normal.dot(placed.points[at(loop[0])]) - plane.offset);
                if (off < least) {
                    least = off;
                    best = static_cast<int>(f);
                }
            }
            if (best >= 0) pairs.push_back({static_cast<int>(t), best});
        }
        if (pairs.size() == before) return std::nullopt;
        return solve(pairs, placed.operation, snaps, freedom);
    }

    bool finishTool(Placement& p) const {
        ToolSpec& tool = p.tool;
        tool.shape.faces = tmpl_.shape.faces;
        double volume = 0;
        for (const Vec3& x : p.points) tool.shape.vertices.push_back(model_.toBody(x));
        for (const auto& loop : tool.shape.faces) {
            for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
                const Vec3 o = tool.shape.vertices[at(loop[0])] - tool.shape.vertices[0];
                volume += o.dot(
                    (tool.shape.vertices[at(loop[i])] - tool.shape.vertices[0])
                        .cross(tool.shape.vertices[at(loop[i + 1])] - tool.shape.vertices[0]));
            }
        }
        if (!std::isfinite(volume) || volume == 0.0) return false;
        if (volume < 0) {
            for (auto& loop : tool.shape.faces) std::reverse(loop.begin(), loop.end());
        }
        for (const auto& pair : p.coinciding) {
            tool.faces.push_back({pair[0], ToolFaceRule::Kind::InFace, pair[1]});
        }
        return true;
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
    std::vector<bool> inFaces_;  ///< per direction class: it has edges in faces of the solid
    std::vector<Placement> out_;
};

}  // namespace

std::vector<Placement> placementsOf(const JointGraph& joint, const JointReading& reading,
                                    const GraphMatch& match, const ModelView& model,
                                    const PlacementOptions& options) {
    return Placer(joint, reading, match, model, options).run();
}

}  // namespace ew
