// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/boolean.h"

#include <algorithm>

#include "core/base/tolerance.h"
#include "core/solid/brep.h"
#include "core/solid/face_tracer.h"
#include "core/solid/near_miss.h"
#include "core/solid/reassemble.h"
#include "core/solid/simplify.h"

namespace ew {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

Box3 boxOf(const Solid& solid, double margin) {
    const auto [low, high] = solid.bounds();
    return {low - Vec3::Constant(margin), high + Vec3::Constant(margin)};
}

Unexpected<Error> noChange(BooleanKind kind) {
    switch (kind) {
        case BooleanKind::Add:
            return fail(Errc::NoChange,
                        "The new part lies inside the solid: nothing would change.");
        case BooleanKind::Cut:
            return fail(Errc::NoChange,
                        "The part to cut out lies beside the solid: nothing would change.");
        default:
            return fail(Errc::NoChange, "The solid lies inside the part: nothing would change.");
    }
}

Unexpected<Error> sliver() {
    return fail(Errc::Sliver,
                "Two parts would all but touch: a wall, gap or step thinner than a hair would be "
                "left that nobody can see. Make the new part a little larger or smaller.");
}

/// A corner of one solid that all but lies in a face of the other.
bool allButTouches(const Operand& solid, const Operand& other, double reach) {
    for (const Facet& facet : solid.facets()) {
        const double scale = facet.plane->n.norm();
        for (const OperandEdge& edge : other.edges()) {
            for (const int v : edge.ends) {
                const PointView p = other.point(v);
                const double gap = (facet.plane->n.dot(p.r) - facet.plane->d) / scale;
                if (std::abs(gap) > reach || facet.box.exteriorDistance(p.r) > reach) continue;
                if (sideOf(*facet.plane, p) != 0) return true;
            }
        }
    }
    return false;
}

/// Faces side by side in all but one plane: the edge between them would be no edge to anyone.
bool allButFlush(const Operand& target, const Operand& tool, double reach) {
    for (const Facet& f : target.facets()) {
        for (const Facet& g : tool.facets()) {
            if (f.box.exteriorDistance(g.box) > reach) continue;
            const double sine = f.plane->n.normalized().cross(g.plane->n.normalized()).norm();
            if (sine > tol::kParallelSine || *f.plane == *g.plane) continue;
            for (const std::vector<int>& loop : *g.loops) {
                for (const int v : loop) {
                    const Vec3 p = tool.point(v).r;
                    const double gap = f.plane->n.dot(p) - f.plane->d;
                    if (std::abs(gap) <= reach && f.box.exteriorDistance(p) <= reach) return true;
                }
            }
        }
    }
    return false;
}

/// Faces that no part of the other solid comes near, as they were.
void keepFarFaces(const Operand& solid, const std::vector<bool>& replaced, bool fromTool, int first,
                  std::vector<TracedFace>& faces) {
    for (std::size_t f = 0; f < replaced.size(); ++f) {
        if (replaced[f]) continue;
        TracedFace face{
            solid.solid().faces[f].loops, {fromTool, static_cast<int>(f)}, solid.solid().planes[f]};
        for (std::vector<int>& loop : face.loops) {
            for (int& v : loop) v += first;
        }
        faces.push_back(std::move(face));
    }
}

bool isBefore(const TracedFace& a, const TracedFace& b) {
    if (a.origin.fromTool != b.origin.fromTool) return b.origin.fromTool;
    if (a.origin.face != b.origin.face) return a.origin.face < b.origin.face;
    return a.loops < b.loops;
}

class Combiner {
  public:
    Combiner(const Solid& target, const Solid& tool, BooleanKind kind)
        : kind_(kind),
          size_(std::max(diagonal(target), diagonal(tool))),
          targetSolid_(target),
          target_(target.impl(), boxOf(tool, tol::kSliverRelative * size_)),
          tool_(tool.impl(), boxOf(target, tol::kSliverRelative * size_)) {}

    Result<BooleanOutcome> run() {
        const double reach = tol::kSliverRelative * size_;
        if (allButTouches(target_, tool_, reach) || allButTouches(tool_, target_, reach) ||
            allButFlush(target_, tool_, reach)) {
            return sliver();
        }
        overlay_ = overlay(target_, tool_, kind_);
        auto traced = traceFaces(overlay_, target_, tool_);
        if (!traced) return fail(traced.error());
        faces_ = std::move(*traced);
        if (kind_ != BooleanKind::Intersect) {
            keepFarFaces(target_, overlay_.targetReplaced, false, 0, faces_);
        }
        if (kind_ == BooleanKind::Add) {
            keepFarFaces(tool_, overlay_.toolReplaced, true, overlay_.firstTool, faces_);
        }
        std::sort(faces_.begin(), faces_.end(), isBefore);
        if (faces_.empty()) {
            return fail(Errc::NothingLeft, kind_ == BooleanKind::Cut
                                               ? "Nothing of the solid would be left."
                                               : "The two parts have nothing in common.");
        }
        return build();
    }

  private:
    static double diagonal(const Solid& s) { return (s.bounds()[1] - s.bounds()[0]).norm(); }

    /// Numbers the points that are left: the target's, the tool's, new ones.
    Result<void> number(ChangedBrep& changed) {
        const int count = overlay_.firstNew + static_cast<int>(overlay_.fresh.size());
        std::vector<int> index(idx(count), -1);
        for (const TracedFace& face : faces_) {
            for (const auto& loop : face.loops) {
                for (const int p : loop) index[idx(p)] = 0;
            }
        }
        for (int p = 0; p < count; ++p) {
            if (index[idx(p)] < 0) continue;
            index[idx(p)] = static_cast<int>(changed.brep.points.size());
            changed.brep.points.push_back(*overlay_.point(p, target_, tool_).exact);
        }
        for (TracedFace& face : faces_) {
            for (auto& loop : face.loops) {
                for (int& p : loop) p = index[idx(p)];
            }
        }
        index.resize(idx(overlay_.firstTool));
        changed.vertexOf = std::move(index);
        return {};
    }

    /// Does the change bring parts so near to each other that they should touch or keep apart?
    /// What the solid had before is not the change's doing.
    bool allButMeets(const ChangedBrep& changed) const {
        std::vector<Vec3> points;
        points.reserve(changed.brep.points.size());
        for (const Point3& p : changed.brep.points) points.push_back(rounded(p));
        const double reach = tol::kThinnestRelative * sizeOf(points);
        const auto places = nearMisses(points, changed.brep.faces, changed.changed, reach);
        if (places.empty()) return false;
        std::vector<FaceLoops> before;
        for (const SolidFace& face : target_.solid().faces) before.push_back(face.loops);
        const auto known =
            nearMisses(target_.solid().vertices, before, changed.changed, 2.0 * reach);
        return std::any_of(places.begin(), places.end(), [&](const Vec3& p) {
            return std::none_of(known.begin(), known.end(),
                                [&](const Vec3& q) { return (p - q).norm() <= 2.0 * reach; });
        });
    }

    Result<BooleanOutcome> build() {
        ChangedBrep changed;
        const auto& before = target_.solid().faces;
        bool anyChange = faces_.size() != before.size();
        for (const TracedFace& face : faces_) {
            const bool known = !face.origin.fromTool;
            const bool kept = known && face.loops == before[idx(face.origin.face)].loops;
            anyChange |= !kept;
            changed.sameAs.push_back(kept ? face.origin.face : -1);
            changed.planes.push_back(face.plane);
        }
        if (!anyChange) {
            return noChange(kind_);
        }
        if (auto ok = number(changed); !ok) return fail(ok.error());
        for (const TracedFace& face : faces_) changed.brep.faces.push_back(face.loops);
        changed.changed = target_.reach();
        if (allButMeets(changed)) return sliver();
        std::vector<int> same = changed.sameAs;
        auto impl = reassembleSimplified(target_.solid(), std::move(changed));
        if (!impl) return fail(impl.error());
        BooleanOutcome out{Solid(std::move(*impl)), {}};
        out.report.shells = out.solid.shellCount();
        out.report.genus = out.solid.genus();
        out.report.shellsBefore = targetSolid_.shellCount();
        for (std::size_t f = 0; f < faces_.size(); ++f) {
            out.report.faceOrigin.push_back(faces_[f].origin);
            out.report.faceUnchanged.push_back(same[f] >= 0);
        }
        return out;
    }

    BooleanKind kind_;
    double size_;
    const Solid& targetSolid_;
    Operand target_;
    Operand tool_;
    Overlay overlay_;
    std::vector<TracedFace> faces_;
};

}  // namespace

Result<BooleanOutcome> combine(const Solid& target, const Solid& tool, BooleanKind kind) {
    try {
        return Combiner(target, tool, kind).run();
    } catch (const std::exception& e) {
        return fail(Errc::Internal, std::string("The solids could not be combined: ") + e.what());
    }
}

}  // namespace ew
