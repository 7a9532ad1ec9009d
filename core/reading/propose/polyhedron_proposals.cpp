// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/polyhedron_proposals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

#include "core/reading/extract/axis_frames.h"
#include "core/reading/solve/cell_complex.h"
#include "core/reading/solve/cell_labels.h"
#include "core/reading/solve/cell_solid.h"
#include "core/reading/solve/cell_votes.h"
#include "core/reading/solve/closing_planes.h"
#include "core/reading/solve/face_lift.h"
#include "core/reading/solve/part_depths.h"
#include "core/reading/solve/simple_pieces.h"
#include "core/reading/types/reading_params.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class Completion {
  public:
    /// \param onePlane  planes no farther apart are one [spreads].
    Completion(const LineDrawing& drawing, const AxisFrame& frame, const FaceLift& lift,
               double spread, double onePlane)
        : drawing_(drawing), frame_(frame), lift_(lift), spread_(spread), onePlane_(onePlane) {}

    /// Planes that lie together are one, those of two faces with a step between them not.
    std::vector<std::vector<int>> onePlanes(const SolidPlanes& planes) const {
        std::vector<int> order(planes.planes.size());
        std::iota(order.begin(), order.end(), 0);
        const auto plane = [&](int i) -> const SolidPlane& { return planes.planes[at(i)]; };
        std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
            if (plane(a).direction != plane(b).direction) {
                return plane(a).direction < plane(b).direction;
            }
            return plane(a).offset < plane(b).offset;
        });
        std::vector<std::vector<int>> groups;
        for (const int i : order) {
            const bool same =
                !groups.empty() && plane(i).direction == plane(groups.back().front()).direction &&
                plane(i).offset - plane(groups.back().back()).offset < onePlane_ * spread_ &&
                !steps(planes, groups.back(), i);
            if (!same) groups.emplace_back();
            groups.back().push_back(i);
        }
        return groups;
    }

    std::vector<ShapeHypothesis> run(const SolidPlanes& planes) {
        std::vector<ShapeHypothesis> out;
        if (!cut(planes)) return out;
        const auto votes = cellVotes(*complex_, drawing_, planeOf_, spread_);
        for (const std::vector<bool>& solid : cellLabels(*complex_, votes)) {
            const auto made = cellSolid(*complex_, solid);
            if (!made) continue;
            auto h = hypothesis(*made);
            if (h && showsCorners(*h)) out.push_back(*std::move(h));
        }
        const auto unseen = [](const ShapeHypothesis& h) {
            return std::count(h.node.begin(), h.node.end(), -1);
        };
        std::stable_sort(out.begin(), out.end(),
                         [&](const ShapeHypothesis& a, const ShapeHypothesis& b) {
                             return unseen(a) < unseen(b);
                         });
        if (out.size() > kMostKept) out.resize(kMostKept);
        return out;
    }

  private:
    bool cut(const SolidPlanes& planes) {
        planeOf_.assign(drawing_.regions.size(), -1);
        begin();
        const auto groups = onePlanes(planes);
        return std::all_of(groups.begin(), groups.end(),
                           [&](const std::vector<int>& group) { return cutOne(planes, group); });
    }

    /// Is there a step between a face of a group and another one?
    bool steps(const SolidPlanes& planes, const std::vector<int>& group, int next) const {
        const int b = planes.planes[at(next)].region;
        if (b < 0) return false;
        return std::any_of(group.begin(), group.end(), [&](int i) {
            const int a = planes.planes[at(i)].region;
            if (a < 0) return false;
            for (std::size_t d = 0; d < drawing_.left.size(); ++d) {
                if (drawing_.left[d] == a && drawing_.left[d ^ 1U] == b) return true;
            }
            return false;
        });
    }

    bool cutOne(const SolidPlanes& planes, const std::vector<int>& group) {
        double sum = 0.0;
        double weight = 0.0;
        const bool seen = std::any_of(group.begin(), group.end(),
                                      [&](int i) { return planes.planes[at(i)].region >= 0; });
        for (const int i : group) {
            const SolidPlane& p = planes.planes[at(i)];
            if (seen && p.region < 0) continue;
            sum += p.weightPx * p.offset;
            weight += p.weightPx;
        }
        DrawnPlane plane;
        plane.normal = planes.directions[at(planes.planes[at(group.front())].direction)];
        plane.offset = sum / weight;
        for (const int i : group) {
            const int region = planes.planes[at(i)].region;
            if (region >= 0) planeOf_[at(region)] = static_cast<int>(complex_->planes().size());
        }
        return complex_->cut(plane, std::max(1e-6 * size_, kOnPlane * spread_));
    }

    /// A box round everything that the planes can make.
    void begin() {
        const auto [low, high] = drawing_.bounds();
        double near = std::numeric_limits<double>::infinity();
        double far = -near;
        for (std::size_t r = 0; r < drawing_.regions.size(); ++r) {
            for (const int d : drawing_.regions[r].loop) {
                const double z =
                    lift_.faces[r].depthAt(drawing_.nodes[at(drawing_.from[at(d)])].at);
                near = std::min(near, z);
                far = std::max(far, z);
            }
        }
        size_ = (high - low).norm() + far - near;
        constexpr double kRoom = 0.6;
        const Vec3 room = Vec3::Constant(kRoom * size_);
        complex_.emplace(Vec3(low.x(), low.y(), near) - room, Vec3(high.x(), high.y(), far) + room);
    }

    std::optional<ShapeHypothesis> hypothesis(const CellSolid& solid) const {
        ShapeHypothesis h;
        h.family = "polyhedron";
        h.rough.vertices = solid.vertices;
        h.frame = frame_.axes;
        for (const CellSolid::Face& f : solid.faces) {
            const auto pieces = simplePieces(solid.vertices, f.loops);
            if (pieces.empty()) return std::nullopt;
            h.rough.faces.insert(h.rough.faces.end(), pieces.begin(), pieces.end());
            const int face = h.pieceOf.empty() ? 0 : h.pieceOf.back() + 1;
            h.pieceOf.resize(h.rough.faces.size(), face);
        }
        findNodes(h);
        addStretches(h);
        return h;
    }

    /// Are most corners of the drawing corners of the solid?
    bool showsCorners(const ShapeHypothesis& h) const {
        const auto all =
            std::count_if(drawing_.nodes.begin(), drawing_.nodes.end(),
                          [](const LineDrawing::Node& n) { return n.stem < 0 && !n.out.empty(); });
        const auto shown =
            std::count_if(h.node.begin(), h.node.end(), [](int n) { return n >= 0; });
        return static_cast<double>(shown) >= kMostCorners * static_cast<double>(all);
    }

    /// Corners of the solid at corners of the drawing, at the depth of a face that meets there.
    void findNodes(ShapeHypothesis& h) const {
        struct Pair {
            double off;
            int vertex, node;
        };
        std::vector<Pair> pairs;
        for (std::size_t n = 0; n < drawing_.nodes.size(); ++n) {
            const LineDrawing::Node& node = drawing_.nodes[n];
            if (node.stem >= 0 || node.out.empty()) continue;
            for (std::size_t v = 0; v < h.rough.vertices.size(); ++v) {
                const Vec3& p = h.rough.vertices[v];
                const double off = (p.head<2>() - node.at).norm();
                if (off > kNearCorner * spread_) continue;
                const bool deep = std::any_of(node.out.begin(), node.out.end(), [&](int d) {
                    const int region = drawing_.left[at(d)];
                    if (region < 0) return false;
                    const DrawnPlane& face = lift_.faces[at(region)];
                    const double slope = face.normal.head<2>().norm() / -face.normal.z();
                    return std::abs(face.depthAt(p.head<2>()) - p.z()) <
                           kNearCorner * spread_ * (1.0 + slope);
                });
                if (deep) pairs.push_back({off, static_cast<int>(v), static_cast<int>(n)});
            }
        }
        std::sort(pairs.begin(), pairs.end(),
                  [](const Pair& a, const Pair& b) { return a.off < b.off; });
        h.node.assign(h.rough.vertices.size(), -1);
        std::vector<bool> taken(drawing_.nodes.size(), false);
        for (const Pair& p : pairs) {
            if (h.node[at(p.vertex)] >= 0 || taken[at(p.node)]) continue;
            h.node[at(p.vertex)] = p.node;
            taken[at(p.node)] = true;
        }
    }

    /// Where a line ends behind something it is part of the edge from its seen corner.
    void addStretches(ShapeHypothesis& h) const {
        for (const LineDrawing::Node& node : drawing_.nodes) {
            if (node.stem < 0) continue;
            const int other = drawing_.to(node.stem);
            const auto seen = std::find(h.node.begin(), h.node.end(), other);
            if (seen == h.node.end()) continue;
            const int v = static_cast<int>(seen - h.node.begin());
            const Vec2 from = h.rough.vertices[at(v)].head<2>();
            int best = -1;
            double least = kNearCorner * spread_;
            for (const auto& loop : h.rough.faces) {
                for (std::size_t k = 0; k < loop.size(); ++k) {
                    if (loop[k] != v) continue;
                    const int w = loop[(k + 1) % loop.size()];
                    const double off =
                        distanceToSegment(node.at, from, h.rough.vertices[at(w)].head<2>(), least);
                    if (off >= least) continue;
                    least = off;
                    best = w;
                }
            }
            if (best >= 0) h.stretches.push_back({{v, best}, node.at, spread_});
        }
    }

    static constexpr std::size_t kMostKept = 3;
    static constexpr double kMostCorners = 0.75;  ///< share of the drawing's corners
    static constexpr double kOnPlane = 1.0;       ///< corners so near a plane are on it [spreads]
    static constexpr double kNearCorner = 6.0;    ///< [spreads]

    const LineDrawing& drawing_;
    const AxisFrame& frame_;
    const FaceLift& lift_;
    double spread_;
    double onePlane_;
    double size_ = 1.0;
    std::optional<CellComplex> complex_;
    std::vector<int> planeOf_;
};

}  // namespace

std::vector<ShapeHypothesis> polyhedronProposals(const LineDrawing& drawing, const AxisFrame& frame,
                                                 double spreadPx) {
    std::vector<ShapeHypothesis> out;
    int lifts = 0;
    // Lines that show no solid fall into many parts.
    constexpr int kMostParts = 8;
    for (const FaceLift& lift : liftFaces(drawing, frame, spreadPx)) {
        if (lift.parts > kMostParts) continue;
        const SolidPlanes planes = solidPlanes(drawing, frame, lift, spreadPx);
        for (const auto& [shifts, less] : partDepths(drawing, lift, planes, spreadPx)) {
            SolidPlanes moved = planes;
            FaceLift deep = lift;
            for (SolidPlane& p : moved.planes) {
                p.offset += shifts[at(p.part)] * moved.directions[at(p.direction)].z();
            }
            for (std::size_t r = 0; r < deep.faces.size(); ++r) {
                deep.faces[r].offset += shifts[at(deep.part[r])] * deep.faces[r].normal.z();
            }
            // What hangs on an attitude that is a little off lies farther apart.
            std::size_t before = 0;
            for (const double onePlane : {3.0, 6.0}) {
                Completion completion(drawing, frame, deep, spreadPx, onePlane);
                const std::size_t count = completion.onePlanes(moved).size();
                if (count == before) break;
                before = count;
                for (ShapeHypothesis& h : completion.run(moved)) {
                    h.lift = lifts;
                    h.price = params::kFreedomCost * less;
                    out.push_back(std::move(h));
                }
            }
            ++lifts;
        }
    }
    return out;
}

}  // namespace ew
