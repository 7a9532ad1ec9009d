// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/fillet.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <string>
#include <unordered_map>

#include "core/base/tolerance.h"
#include "core/surface/box_tree.h"
#include "core/surface/fillet_build.h"
#include "core/surface/fillet_clamp.h"
#include "core/surface/self_intersection.h"
#include "core/surface/side_key.h"

namespace ew {
namespace {

using Kind = CageOrigin::Kind;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Result<std::vector<double>> readOptions(const Solid& solid, const FilletOptions& options) {
    if (options.edges.empty()) return fail(Errc::NoEdge, "No edge was chosen for the fillet.");
    if (options.segments < 1 || options.segments > kMaxFilletSegments) {
        return fail(Errc::BadValue, "A fillet has 1 to " + std::to_string(kMaxFilletSegments) +
                                        " segments, not " + std::to_string(options.segments) + ".");
    }
    std::vector<double> wanted(solid.edges().size(), 0.0);
    for (const FilletChoice& choice : options.edges) {
        const std::string name = "Edge " + std::to_string(choice.edge);
        if (choice.edge < 0 || at(choice.edge) >= wanted.size()) {
            return fail(Errc::BadValue, name + " does not exist.");
        }
        if (!std::isfinite(choice.setback) || choice.setback <= 0.0) {
            return fail(Errc::BadValue, name + " has a radius that is not a positive number.");
        }
        if (wanted[at(choice.edge)] > 0.0) return fail(Errc::BadValue, name + " is chosen twice.");
        wanted[at(choice.edge)] = choice.setback;
    }
    return wanted;
}

/// Fits, builds and checks, and gives way where the check finds fault, until it finds none.
class Maker {
  public:
    Maker(const Solid& solid, std::vector<double> wanted, int segments)
        : topology_(solid),
          requested_(wanted),
          wanted_(std::move(wanted)),
          segments_(segments),
          styles_(solid.vertices().size(), CornerStyle::Patch),
          taper_(solid.vertices().size(), kFirstTaper),
          limitingEdge_(wanted_.size(), -1),
          limitingVertex_(wanted_.size(), -1) {
        const auto box = solid.bounds();
        least_ = tol::kSamePlaneRelative * (box[1] - box[0]).norm();
    }

    FilletedCage run() {
        for (int round = 0;; ++round) {
            FilletedCage cage = build();
            round_ = round;
            const bool sharp =
                std::all_of(wanted_.begin(), wanted_.end(), [](double w) { return w <= 0.0; });
            if (!sharp && findFaults(cage)) continue;
            report(cage);
            return cage;
        }
    }

  private:
    static constexpr double kFirstTaper = 2.0;
    static constexpr double kLastTaper = 16.0;
    static constexpr double kShrink = 0.7;
    static constexpr int kPatience = 30;  ///< rounds after which edges at fault stay sharp
    static constexpr std::size_t kFaults = 1000;

    FilletedCage build() {
        // A single flat strip has no arc to be moved along.
        std::vector<bool> arcs(at(topology_.halfCount()), false);
        for (int h = 0; h < topology_.halfCount() && segments_ > 1; ++h) {
            arcs[at(h)] = goesRound(topology_, h, wanted_);
        }
        while (true) {
            std::vector<bool> filleted(wanted_.size());
            for (std::size_t e = 0; e < wanted_.size(); ++e) filleted[e] = wanted_[e] > 0.0;
            const FilletPlan plan(topology_, std::move(filleted), styles_, taper_, arcs);
            FilletFit fit = fitSetbacks(plan, wanted_);
            bool dropped = false;
            for (std::size_t e = 0; e < wanted_.size(); ++e) {
                if (fit.limitingEdge[e] >= 0) {
                    limitingEdge_[e] = fit.limitingEdge[e];
                    limitingVertex_[e] = fit.limitingVertex[e];
                }
                if (wanted_[e] <= 0.0 || fit.setbacks[e] > least_) continue;
                wanted_[e] = 0.0;
                dropped = true;
            }
            // Which setback is the largest is known only when all fit.
            for (int h = 0; h < topology_.halfCount(); ++h) {
                if (plan.sector(h).kind != FilletSector::Kind::Arc) continue;
                if (goesRound(topology_, h, fit.setbacks)) continue;
                arcs[at(h)] = false;
                dropped = true;
            }
            if (dropped) continue;
            setbacks_ = std::move(fit.setbacks);
            return buildFillet(plan, setbacks_, segments_);
        }
    }

    /// False where the cage is sound; else something was changed that may make it so.
    bool findFaults(const FilletedCage& cage) {
        styled_.clear();
        shrunk_.clear();
        std::vector<int> broken;
        const auto triangles = triangulate(cage.mesh, &broken);
        if (!triangles) {
            wanted_.assign(wanted_.size(), 0.0);
            return true;
        }
        if (!broken.empty()) readNeighbours(cage);
        for (const int f : broken) {
            if (!untangle(cage, f)) giveWay(cage.origins[at(f)], cage.origins[at(f)]);
        }
        auto pairs =
            selfIntersections(cage.mesh.points, triangles->triangles, triangles->face, kFaults);
        std::erase_if(pairs, [&](const auto& pair) { return isOwn(cage, *triangles, pair); });
        for (const auto& [a, b] : pairs) {
            giveWay(cage.origins[at(triangles->face[at(a)])],
                    cage.origins[at(triangles->face[at(b)])]);
        }
        if (broken.empty() && pairs.empty()) return false;
        // Faults that nothing was found for end here too: sharp edges are always sound.
        if (styled_.empty() && shrunk_.empty()) wanted_.assign(wanted_.size(), 0.0);
        return true;
    }

    /// Two faces that come as near to each other as rounding goes where no fillet is to blame: the
    /// solid itself has them so.
    static bool isOwn(const FilletedCage& cage, const PolyTriangles& triangles,
                      const std::pair<int, int>& pair) {
        const auto isFace = [&](int t) {
            return cage.origins[at(triangles.face[at(t)])].kind == Kind::Face;
        };
        return isFace(pair.first) && isFace(pair.second) &&
               !meetExactly(cage.mesh.points, triangles.triangles[at(pair.first)],
                            triangles.triangles[at(pair.second)]);
    }

    /// The face on the left of every directed edge of the cage.
    void readNeighbours(const FilletedCage& cage) {
        left_.clear();
        for (int f = 0; f < cage.mesh.faceCount(); ++f) {
            for (int l = 0; l < cage.mesh.loopCount(f); ++l) {
                const auto loop = cage.mesh.loop(f, l);
                for (std::size_t k = 0; k < loop.size(); ++k) {
                    left_[sideKey(loop[k], loop[(k + 1) % loop.size()])] = f;
                }
            }
        }
    }

    /// Finds the sides of a planar face that cross, and what lies beyond them. False where none do.
    bool untangle(const FilletedCage& cage, int face) {
        if (cage.origins[at(face)].kind != Kind::Face) return false;
        const Vec3 normal = topology_.solid().faces()[at(cage.origins[at(face)].index)].normal;
        std::vector<std::array<int, 2>> sides;
        std::vector<Box3> boxes;
        for (int l = 0; l < cage.mesh.loopCount(face); ++l) {
            const auto loop = cage.mesh.loop(face, l);
            for (std::size_t k = 0; k < loop.size(); ++k) {
                sides.push_back({loop[k], loop[(k + 1) % loop.size()]});
                Box3 box(cage.mesh.point(sides.back()[0]));
                box.extend(cage.mesh.point(sides.back()[1]));
                boxes.push_back(box);
            }
        }
        const auto turn = [&](int a, int b, int c) {
            const Vec3& p = cage.mesh.point(a);
            return (cage.mesh.point(b) - p).cross(cage.mesh.point(c) - p).dot(normal);
        };
        bool found = false;
        BoxTree(boxes).overlappingPairs([&](int i, int k) {
            const auto [a, b] = sides[at(i)];
            const auto [c, d] = sides[at(k)];
            if (a == c || a == d || b == c || b == d) return;
            if (turn(a, b, c) * turn(a, b, d) > 0.0 || turn(c, d, a) * turn(c, d, b) > 0.0) return;
            const auto one = left_.find(sideKey(b, a));
            const auto other = left_.find(sideKey(d, c));
            if (one == left_.end() || other == left_.end()) return;
            giveWay(cage.origins[at(one->second)], cage.origins[at(other->second)]);
            found = true;
        });
        return found && !(styled_.empty() && shrunk_.empty());
    }

    bool filleted(int edge) const { return wanted_[at(edge)] > 0.0; }
    std::array<int, 2> endsOf(int edge) const { return topology_.solid().edges()[at(edge)].ends; }
    bool isEnd(int vertex, int edge) const {
        return endsOf(edge)[0] == vertex || endsOf(edge)[1] == vertex;
    }
    bool touches(int vertex, int face) const {
        const auto ring = topology_.ring(vertex);
        return std::any_of(ring.begin(), ring.end(),
                           [&](int h) { return topology_.half(h).face == face; });
    }
    bool bounds(int edge, int face) const {
        const int h = topology_.ofEdge(edge);
        return topology_.half(h).face == face ||
               topology_.half(topology_.half(h).twin).face == face;
    }

    /// The corner that two parts have in common; -1 where they have none, or where it is the whole
    /// edge that they share.
    int sharedCorner(const CageOrigin& a, const CageOrigin& b) const {
        if (a.kind == Kind::Corner) {
            const bool local = b.kind == Kind::Corner  ? a.index == b.index
                               : b.kind == Kind::Strip ? isEnd(a.index, b.index)
                                                       : touches(a.index, b.index);
            return local ? a.index : -1;
        }
        if (b.kind == Kind::Corner) return sharedCorner(b, a);
        if (a.kind == Kind::Strip && b.kind == Kind::Strip && a.index != b.index) {
            for (const int v : endsOf(a.index)) {
                if (isEnd(v, b.index)) return v;
            }
        }
        if (a.kind == Kind::Strip && b.kind == Kind::Face && !bounds(a.index, b.index)) {
            for (const int v : endsOf(a.index)) {
                if (touches(v, b.index)) return v;
            }
        }
        if (a.kind == Kind::Face && b.kind == Kind::Strip) return sharedCorner(b, a);
        return -1;
    }

    void giveWay(const CageOrigin& a, const CageOrigin& b) {
        const int corner = sharedCorner(a, b);
        if (corner >= 0 && simplify(corner)) return;
        if (a.kind == Kind::Face || b.kind == Kind::Face || a == b) {
            shrinkAll(a, b);
            shrinkAll(b, a);
            return;
        }
        // Of two fillets that meet, the larger one gives way.
        const double sizeA = largest(a);
        const double sizeB = largest(b);
        if (sizeA >= kShrink * sizeB) shrinkAll(a, b);
        if (sizeB >= kShrink * sizeA) shrinkAll(b, a);
    }

    /// A simpler corner; false where there is none left.
    bool simplify(int vertex) {
        if (styled_.contains(vertex)) return true;
        CornerStyle& style = styles_[at(vertex)];
        if (style == CornerStyle::Taper && taper_[at(vertex)] >= kLastTaper) return false;
        if (round_ >= kPatience) return false;
        if (style == CornerStyle::Taper) taper_[at(vertex)] *= 2.0;
        if (style == CornerStyle::Apex) style = CornerStyle::Taper;
        if (style == CornerStyle::Patch) style = CornerStyle::Apex;
        styled_.insert(vertex);
        return true;
    }

    std::vector<int> edgesOf(const CageOrigin& part) const {
        std::vector<int> out;
        const auto add = [&](int e) {
            if (filleted(e)) out.push_back(e);
        };
        if (part.kind == Kind::Strip) add(part.index);
        if (part.kind == Kind::Corner) {
            for (const int h : topology_.ring(part.index)) add(topology_.half(h).edge);
        }
        if (part.kind == Kind::Face) {
            for (const int first : topology_.loops(part.index)) {
                int h = first;
                do {
                    // Its own edges, and those whose strips end in it.
                    for (const int g : topology_.ring(topology_.half(h).origin)) {
                        add(topology_.half(g).edge);
                    }
                    h = topology_.half(h).next;
                } while (h != first);
            }
        }
        return out;
    }

    double largest(const CageOrigin& part) const {
        double out = 0.0;
        for (const int e : edgesOf(part)) out = std::max(out, setbacks_[at(e)]);
        return out;
    }

    void shrinkAll(const CageOrigin& part, const CageOrigin& because) {
        // A face by itself is in nobody's way: what stands on it is.
        if (part.kind == Kind::Face && because.kind != Kind::Face) return;
        for (const int e : edgesOf(part)) {
            if (!shrunk_.insert(e).second) continue;
            const bool hopeless =
                round_ >= kPatience ||
                setbacks_[at(e)] < 1e-3 * std::min(requested_[at(e)], wanted_[at(e)]);
            wanted_[at(e)] = hopeless ? 0.0 : kShrink * setbacks_[at(e)];
            limitingEdge_[at(e)] = because.kind == Kind::Strip ? because.index : -1;
            limitingVertex_[at(e)] = because.kind == Kind::Corner ? because.index : -1;
            if (because.kind == Kind::Face) {
                limitingEdge_[at(e)] = topology_.half(topology_.loops(because.index)[0]).edge;
            }
        }
    }

    void report(FilletedCage& cage) const {
        for (std::size_t e = 0; e < requested_.size(); ++e) {
            const double used = wanted_[e] > 0.0 ? setbacks_[e] : 0.0;
            if (used >= requested_[e] * (1.0 - tol::kSamePlaneRelative)) continue;
            cage.clamped.push_back(
                {static_cast<int>(e), requested_[e], used, limitingEdge_[e], limitingVertex_[e]});
        }
    }

    FilletTopology topology_;
    std::vector<double> requested_;
    std::vector<double> wanted_;
    std::vector<double> setbacks_;
    int segments_;
    std::vector<CornerStyle> styles_;
    std::vector<double> taper_;
    std::vector<int> limitingEdge_;
    std::vector<int> limitingVertex_;
    std::unordered_map<std::uint64_t, int> left_;  ///< face by directed edge, of a faulty cage
    std::set<int> styled_;                         ///< in this round
    std::set<int> shrunk_;
    double least_ = 0.0;
    int round_ = 0;
};

}  // namespace

Result<FilletedCage> fillet(const Solid& solid, const FilletOptions& options) {
    auto wanted = readOptions(solid, options);
    if (!wanted) return fail(wanted.error());
    return Maker(solid, std::move(*wanted), options.segments).run();
}

FilletedCage sharpCage(const Solid& solid) {
    FilletedCage cage;
    cage.mesh.points = solid.vertices();
    for (std::size_t f = 0; f < solid.faces().size(); ++f) {
        for (const std::vector<int>& loop : solid.faces()[f].loops) {
            cage.mesh.corners.insert(cage.mesh.corners.end(), loop.begin(), loop.end());
            cage.mesh.closeLoop();
        }
        cage.mesh.closeFace();
        cage.origins.push_back({Kind::Face, static_cast<int>(f)});
    }
    for (std::size_t e = 0; e < solid.edges().size(); ++e) {
        const auto& ends = solid.edges()[e].ends;
        cage.sharpEdges.push_back({ends[0], ends[1], static_cast<int>(e)});
    }
    cage.vertexPoints.resize(solid.vertices().size());
    std::iota(cage.vertexPoints.begin(), cage.vertexPoints.end(), 0);
    cage.setbacks.assign(solid.edges().size(), 0.0);
    return cage;
}

double radiusForSetback(const Solid& solid, int edge, double setback) {
    const SolidEdge& e = solid.edges()[at(edge)];
    const Vec3& a = solid.faces()[at(e.faces[0])].normal;
    const Vec3& b = solid.faces()[at(e.faces[1])].normal;
    // The normals differ by the supplement of the angle between the faces.
    const double turn = std::atan2(a.cross(b).norm(), a.dot(b));
    return setback / std::tan(0.5 * turn);
}

double setbackForRadius(const Solid& solid, int edge, double radius) {
    return radius / radiusForSetback(solid, edge, 1.0);
}

}  // namespace ew
