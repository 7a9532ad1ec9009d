// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/fillet_build.h"

#include <algorithm>
#include <cmath>

#include "core/base/tolerance.h"
#include "core/surface/fillet_corner.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class Builder {
  public:
    Builder(const FilletPlan& plan, const std::vector<double>& setbacks, int segments)
        : plan_(plan),
          topology_(plan.topology()),
          setbacks_(setbacks),
          segments_(segments),
          chains_(at(topology_.halfCount())),
          curves_(at(topology_.halfCount())),
          cornerIds_(topology_.solid().vertices().size(), -1) {
        weights_.resize(at(segments) + 1);
    }

    FilletedCage run() {
        for (int h = 0; h < topology_.halfCount(); ++h) makeChain(h);
        for (int h = 0; h < topology_.halfCount(); ++h) {
            if (plan_.filleted(h)) makeCurve(h);
        }
        for (int v = 0; at(v) < cornerIds_.size(); ++v) {
            if (plan_.isCap(v)) makeCapChain(v);
        }
        for (int f = 0; at(f) < topology_.solid().faces().size(); ++f) addFace(f);
        for (int e = 0; at(e) < setbacks_.size(); ++e) {
            if (setbacks_[at(e)] > 0.0) {
                addStrip(e);
            } else {
                const int h = topology_.ofEdge(e);
                cage_.sharpEdges.push_back({sharpStart(h), sharpStart(half(h).twin), e});
            }
        }
        for (int v = 0; at(v) < cornerIds_.size(); ++v) {
            if (plan_.filletedAt(v) == 0 || plan_.isCap(v)) continue;
            addCorner(v);
            note(CageOrigin::Kind::Corner, v);
        }
        cage_.vertexPoints = std::move(cornerIds_);
        cage_.setbacks = setbacks_;
        return std::move(cage_);
    }

  private:
    /// A run of ids in the pool.
    struct Run {
        std::size_t first = 0;
        std::size_t count = 0;
    };

    PolyMesh& mesh() { return cage_.mesh; }
    const FilletHalfEdge& half(int h) const { return topology_.half(h); }
    const Vec3& corner(int h) const { return topology_.position(half(h).origin); }
    double setback(int h) const { return setbacks_[at(half(h).edge)]; }
    std::span<const int> ids(const Run& run) const { return {pool_.data() + run.first, run.count}; }
    std::span<const int> chain(int h) const { return ids(chains_[at(h)]); }
    std::span<const int> curve(int h) const { return ids(curves_[at(h)]); }
    void note(CageOrigin::Kind kind, int index) {
        cage_.origins.resize(at(cage_.mesh.faceCount()), {kind, index});
    }

    int cornerId(int vertex) {
        int& id = cornerIds_[at(vertex)];
        if (id < 0) id = mesh().addPoint(topology_.position(vertex));
        return id;
    }

    /// The point on the sharp edge of `h` at u, shared by the faces that cut it in one place.
    int cutPoint(int h, double u, bool fromAcross) {
        const double other =
            fromAcross ? plan_.start(h, setbacks_) : plan_.startAcross(h, setbacks_);
        const FilletSector& sector = plan_.sector(fromAcross ? h : topology_.cw(h));
        const bool cutThere = sector.kind == FilletSector::Kind::Cut && !sector.keepsCorner;
        const auto& there = chains_[at(fromAcross ? h : topology_.cw(h))];
        if (cutThere && there.count > 0 &&
            std::abs(other - u) <= tol::kFilletSamePoint * std::abs(u)) {
            return fromAcross ? ids(there).front() : ids(there).back();
        }
        return mesh().addPoint(corner(h) + u * half(h).dir);
    }

    void makeChain(int h) {
        using Kind = FilletSector::Kind;
        const FilletSector& s = plan_.sector(h);
        const int g = topology_.ccw(h);
        const int v = half(h).origin;
        std::array<int, kMaxFilletSegments + 1> out{};
        std::size_t n = 0;
        const auto side = [&](int slot, double t, const Vec3& inward) {
            return mesh().addPoint(corner(slot) + t * half(slot).dir + setback(slot) * inward);
        };
        const auto first = [&] { return side(h, plan_.start(h, setbacks_), half(h).inward); };
        const auto last = [&] {
            return side(g, plan_.startAcross(g, setbacks_), half(half(g).twin).inward);
        };
        if (s.kind == Kind::Miter) {
            out[n++] = first();
        } else if (s.kind == Kind::Step) {
            out[n++] = first();
            const double gap = std::abs(setback(h) - setback(g));
            if (gap > tol::kFilletSamePoint * setback(h)) out[n++] = last();
        } else if (s.kind == Kind::Cut) {
            const bool own = plan_.filleted(h);
            const int id = own ? cutPoint(g, plan_.startAcross(g, setbacks_), true)
                               : cutPoint(h, plan_.start(h, setbacks_), false);
            if (!own && s.keepsCorner) out[n++] = cornerId(v);
            out[n++] = id;
            if (own && s.keepsCorner) out[n++] = cornerId(v);
        } else if (s.kind == Kind::End) {
            if (plan_.filleted(h)) out[n++] = first();
            out[n++] = cornerId(v);
            if (plan_.filleted(g)) out[n++] = last();
        } else if (s.kind == Kind::Arc) {
            out[n++] = first();
            const FaceArc arc = faceArc(h);
            for (int j = 1; j < segments_; ++j) {
                out[n++] = mesh().addPoint(arc.at(static_cast<double>(j) / segments_));
            }
            out[n++] = last();
        } else if (!plan_.isCap(v)) {
            out[n++] = cornerId(v);
        }
        chains_[at(h)] = {pool_.size(), n};
        pool_.insert(pool_.end(), out.begin(), out.begin() + static_cast<std::ptrdiff_t>(n));
    }

    FaceArc faceArc(int h) const {
        const int g = topology_.ccw(h);
        FaceArc arc;
        arc.corner = corner(h);
        arc.along = {half(h).dir, half(g).dir};
        arc.inward = {half(h).inward, half(half(g).twin).inward};
        arc.start = {plan_.start(h, setbacks_), plan_.startAcross(g, setbacks_)};
        arc.setback = {setback(h), setback(g)};
        arc.angle = half(h).angle;
        return arc;
    }

    /// Ends of the strip of h at its origin: on the face across, and on its own.
    int rightEnd(int h) const { return chain(topology_.cw(h)).back(); }
    int leftEnd(int h) const { return chain(h).front(); }

    /// The ends of strips lie in planes through the corner, save around a rounded patch.
    bool endsSquare(int v) const {
        return plan_.filletedAt(v) > 2 && !plan_.keepsCorner(v) && !plan_.isCap(v) &&
               plan_.style(v) == CornerStyle::Patch;
    }

    void setWeights(int h) {
        const double cosine = foldCosine(topology_, half(h).edge);
        if (cosine == weightsFor_) return;
        weightsFor_ = cosine;
        for (int j = 0; j <= segments_; ++j) {
            weights_[at(j)] = arcWeights(cosine, static_cast<double>(j) / segments_);
        }
    }

    Vec3 curvePoint(int h, double t, const std::array<double, 2>& w) const {
        const double right = plan_.startAcross(h, setbacks_);
        const double left = plan_.start(h, setbacks_);
        const double along =
            endsSquare(half(h).origin) ? (1.0 - t) * right + t * left : w[0] * right + w[1] * left;
        return corner(h) + along * half(h).dir +
               setback(h) * (w[0] * half(half(h).twin).inward + w[1] * half(h).inward);
    }

    void makeCurve(int h) {
        Run& run = curves_[at(h)];
        const int right = rightEnd(h);
        const int left = leftEnd(h);
        // Two strips alone that end in the same two points may have one end in common.
        std::span<const int> twin;
        const int v = half(h).origin;
        if (plan_.filletedAt(v) == 2 && !plan_.keepsCorner(v)) {
            for (const int g : topology_.ring(v)) {
                if (g != h && plan_.filleted(g)) twin = curve(g);
            }
            if (!twin.empty() && (twin.front() != left || twin.back() != right)) twin = {};
        }
        setWeights(h);
        std::array<int, kMaxFilletSegments + 1> out{};
        out[0] = right;
        for (int j = 1; j < segments_; ++j) {
            const Vec3 p = curvePoint(h, static_cast<double>(j) / segments_, weights_[at(j)]);
            int id = -1;
            if (!twin.empty()) {
                const int other = twin[at(segments_ - j)];
                if ((mesh().point(other) - p).norm() <= tol::kFilletSamePoint * setback(h))
                    id = other;
            }
            out[at(j)] = id >= 0 ? id : mesh().addPoint(p);
        }
        out[at(segments_)] = left;
        run = {pool_.size(), at(segments_) + 1};
        pool_.insert(pool_.end(), out.begin(), out.begin() + segments_ + 1);
    }

    void makeCapChain(int vertex) {
        for (const int h : topology_.ring(vertex)) {
            if (!plan_.filleted(h)) continue;
            const auto end = curve(h);
            const std::vector<int> reversed(end.rbegin(), end.rend());
            addSharpEnd(cage_, reversed, half(topology_.ccw(h)).edge);
            chains_[at(topology_.ccw(h))] = {pool_.size(), reversed.size()};
            pool_.insert(pool_.end(), reversed.begin(), reversed.end());
        }
    }

    /// A sharp edge of a corner, -1 where all are filleted.
    int sharpEdgeAt(int vertex) const {
        for (const int h : topology_.ring(vertex)) {
            if (!plan_.filleted(h)) return half(h).edge;
        }
        return -1;
    }

    // Faces -------------------------------------------------------------------------------------

    void addFace(int face) {
        for (const int firstHalf : topology_.loops(face)) {
            const std::size_t begin = mesh().corners.size();
            const auto put = [&](int id) {
                auto& corners = mesh().corners;
                if (corners.size() == begin || corners.back() != id) corners.push_back(id);
            };
            const auto along = [&](int id, int h) {
                return (mesh().point(id) - corner(h)).dot(half(h).dir);
            };
            int h = firstHalf;
            do {
                // What the face on the other side of a sharp edge has on it.
                const int in = topology_.ccw(h);
                const auto own = chain(h);
                if (!plan_.filleted(in) && leftEnd(in) != own.back() &&
                    along(leftEnd(in), in) > along(own.back(), in)) {
                    put(leftEnd(in));
                }
                for (auto it = own.rbegin(); it != own.rend(); ++it) put(*it);
                if (!plan_.filleted(h) && rightEnd(h) != own.front() &&
                    along(rightEnd(h), h) > along(own.front(), h)) {
                    put(rightEnd(h));
                }
                h = half(h).next;
            } while (h != firstHalf);
            auto& corners = mesh().corners;
            if (corners.size() > begin + 1 && corners.back() == corners[begin]) corners.pop_back();
            mesh().closeLoop();
        }
        mesh().closeFace();
        note(CageOrigin::Kind::Face, face);
    }

    /// Where a sharp edge begins to be an edge of both its faces.
    int sharpStart(int h) {
        const auto along = [&](int id) { return (mesh().point(id) - corner(h)).dot(half(h).dir); };
        return along(rightEnd(h)) > along(leftEnd(h)) ? rightEnd(h) : leftEnd(h);
    }

    void addStrip(int edge) {
        const int h = topology_.ofEdge(edge);
        const auto here = curve(h);
        const auto there = curve(half(h).twin);
        const auto k = at(segments_);
        for (std::size_t j = 0; j < k; ++j) {
            mesh().addFace({here[j], there[k - j], there[k - j - 1], here[j + 1]});
        }
        note(CageOrigin::Kind::Strip, edge);
    }

    // Corners -----------------------------------------------------------------------------------

    std::vector<HoleSide> holeOf(int v, int sharp) {
        std::vector<HoleSide> sides;
        links_.clear();
        links_.reserve(8 * topology_.ring(v).size());
        const auto link = [&](int a, int b) {
            if (a == b) return;
            if (sharp >= 0) cage_.sharpEnds.push_back({a, b, sharp});
            links_.push_back(a);
            links_.push_back(b);
            sides.push_back({{links_.data() + links_.size() - 2, 2}});
        };
        for (const int h : topology_.ring(v)) {
            if (plan_.filleted(h)) {
                sides.push_back({curve(h), h, HoleSide::Kind::Strip});
            } else {
                link(rightEnd(h), leftEnd(h));
            }
            const auto c = chain(h);
            if (plan_.sector(h).kind == FilletSector::Kind::Arc) {
                sides.push_back({c, h, HoleSide::Kind::Arc});
                continue;
            }
            for (std::size_t k = 0; k + 1 < c.size(); ++k) link(c[k], c[k + 1]);
        }
        return sides;
    }

    void addCorner(int v) {
        const int sharp = sharpEdgeAt(v);
        const std::vector<HoleSide> sides = holeOf(v, sharp);
        const bool straight = std::any_of(sides.begin(), sides.end(), [](const HoleSide& s) {
            return s.kind == HoleSide::Kind::Straight;
        });
        if (plan_.keepsCorner(v) || plan_.style(v) != CornerStyle::Patch) {
            addFans(cage_, cornerId(v), sides, sharp);
        } else if (plan_.filletedAt(v) == 2) {
            addBridge(cage_, sides, sharp);
        } else if (straight || segments_ == 1) {
            addPolygon(cage_.mesh, sides);
        } else if (!addSweep(v, sides)) {
            std::vector<PatchSide> patch;
            for (const HoleSide& side : sides) {
                patch.push_back(side.kind == HoleSide::Kind::Arc ? arcSide(side) : patchSide(side));
            }
            addCornerPatch(mesh(), patch);
        }
    }

    /// Where two strips go round the end of a third one, as on a bent tube. False where they do
    /// not.
    bool addSweep(int v, std::span<const HoleSide> sides) {
        if (sides.size() != 4) return false;
        const auto arc = std::find_if(sides.begin(), sides.end(), [](const HoleSide& s) {
            return s.kind == HoleSide::Kind::Arc;
        });
        if (arc == sides.end()) return false;
        const auto side = [&](std::ptrdiff_t k) {
            return sides[at(static_cast<int>((arc - sides.begin() + k + 4) % 4))].ids;
        };
        const FaceArc face = faceArc(arc->half);
        if (std::min(face.start[0], face.start[1]) <= 0.0) return false;
        addSweptPatch(mesh(), {topology_.position(v),
                               {face.start[0] * face.along[0], face.start[1] * face.along[1]},
                               side(-1),
                               arc->ids,
                               side(1),
                               side(2)});
        return true;
    }

    PatchSide arcSide(const HoleSide& side) const {
        const FaceArc arc = faceArc(side.half);
        PatchSide out;
        out.ids.assign(side.ids.begin(), side.ids.end());
        out.middle = arc.at(0.5);
        const Vec3 chord = arc.at(1.0) - arc.at(0.0);
        const Vec3 normal = topology_.solid().faces()[at(half(side.half).face)].normal;
        out.inward = normal.cross(chord).normalized();
        return out;
    }

    PatchSide patchSide(const HoleSide& side) const {
        const int h = side.half;
        PatchSide out;
        out.ids.assign(side.ids.begin(), side.ids.end());
        const double cosine = foldCosine(topology_, half(h).edge);
        out.middle = curvePoint(h, 0.5, arcWeights(cosine, 0.5));
        out.inward = -half(h).dir;
        const double right = plan_.startAcross(h, setbacks_);
        const double left = plan_.start(h, setbacks_);
        out.square =
            std::abs(right - left) <= tol::kFilletSamePoint * setback(h) && cosine > -0.999;
        out.convex = topology_.solid().edges()[at(half(h).edge)].convex;
        out.center = corner(h) + left * half(h).dir +
                     setback(h) / (1.0 + cosine) * (half(h).inward + half(half(h).twin).inward);
        out.radius = (out.middle - out.center).norm();
        return out;
    }

    const FilletPlan& plan_;
    const FilletTopology& topology_;
    const std::vector<double>& setbacks_;
    int segments_;
    FilletedCage cage_;
    std::vector<Run> chains_;  ///< by half-edge, from its side of the sector to the other
    std::vector<Run> curves_;  ///< by filleted half-edge, from the face across to its own
    std::vector<int> pool_;
    std::vector<int> links_;
    std::vector<int> cornerIds_;
    std::vector<std::array<double, 2>> weights_;
    double weightsFor_ = 2.0;
};

}  // namespace

FilletedCage buildFillet(const FilletPlan& plan, const std::vector<double>& setbacks,
                         int segments) {
    return Builder(plan, setbacks, segments).run();
}

}  // namespace ew
