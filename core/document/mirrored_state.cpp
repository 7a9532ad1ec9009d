// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/mirrored_state.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/document/applied_state.h"
#include "core/document/body_list.h"
#include "core/solid/boolean.h"
#include "core/solid/exact_tool.h"
#include "core/solid/mirror.h"
#include "core/solid/transform.h"

namespace ew {
namespace {

using State = Result<std::shared_ptr<const DocumentState>>;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Combines a shape with a solid: exactly in the planes of the solid that it nearly lies in.
Result<Solid> combinedWith(const Solid& solid, const PolyhedronSpec& shape, BooleanKind kind) {
    const auto tool = makeTool(solid, {shape, {}, {}, {}, true});
    if (!tool) return fail(tool.error());
    auto made = combine(solid, *tool, kind);
    if (!made && made.error().code == Errc::NoChange) return solid;  // it is symmetric already
    if (!made) return fail(made.error());
    return std::move(made->solid);
}

/// The lowest and the highest corner over the plane [mm].
std::array<double, 2> extentOver(const std::vector<Vec3>& points, const MirrorPlane& plane) {
    std::array<double, 2> out{plane.height(points.front()), plane.height(points.front())};
    for (const Vec3& p : points) {
        out[0] = std::min(out[0], plane.height(p));
        out[1] = std::max(out[1], plane.height(p));
    }
    return out;
}

State created(const DocumentState& before, const Candidate& c, double reach) {
    auto after = std::make_shared<DocumentState>(before);
    const MirrorPlane plane = inBody(*before.mirror, c.pose);
    for (const PolyhedronSpec& drawn : separateBodies(c.spec)) {
        const PolyhedronSpec spec = metPlane(drawn, plane, reach).value_or(drawn);
        auto solid = Solid::fromSpec(spec);
        if (!solid) return fail(solid.error());
        const auto [low, high] = extentOver(spec.vertices, plane);
        const double touching = 1e-9 * (high - low);
        if (low > touching || high < -touching) {
            auto image = transformed(*solid, plane.reflection(), plane.image(Vec3::Zero()));
            if (!image) return fail(image.error());
            after->bodies.push_back({*std::move(solid), c.pose});
            after->bodies.push_back({*std::move(image), c.pose});
            continue;
        }
        auto both = combinedWith(*solid, mirrored(spec, plane), BooleanKind::Add);
        if (!both) return fail(both.error());
        after->bodies.push_back({*std::move(both), c.pose});
    }
    return std::shared_ptr<const DocumentState>(std::move(after));
}

/// What was added or cut, with its face in the plane where it was drawn so.
Result<Solid> ownSide(const Solid& before, const Candidate& c, const MirrorPlane& plane,
                      double reach, BooleanKind kind, PolyhedronSpec& shape) {
    const auto met = metPlane(c.spec, plane, reach);
    if (met) {
        auto made = combinedWith(before, *met, kind);
        if (made) {
            shape = *met;
            return made;
        }
    }
    return *c.result;
}

}  // namespace

State withMirrorImage(const DocumentState& before, std::shared_ptr<const DocumentState> after,
                      const Candidate& c, double reach) {
    if (c.operation == Operation::Create) return created(before, c, reach);
    if (c.operation != Operation::Add && c.operation != Operation::Cut) return after;
    const BooleanKind kind = c.operation == Operation::Add ? BooleanKind::Add : BooleanKind::Cut;
    auto out = std::make_shared<DocumentState>(*after);
    const Body& old = before.bodies[at(c.body)];
    const MirrorPlane plane = inBody(*before.mirror, old.pose);
    PolyhedronSpec shape = c.spec;
    const auto own = ownSide(old.solid, c, plane, reach, kind, shape);
    if (!own) return fail(own.error());
    auto both = combinedWith(*own, mirrored(shape, plane), kind);
    if (!both) return fail(both.error());
    if (kind == BooleanKind::Add && both->shellCount() > own->shellCount()) {
        return fail(Errc::OperationImpossible,
                    "The mirror image would hang in the air; move the mirror plane, or drop it.");
    }
    auto& edges = out->surface.edges;
    if (at(c.body) < edges.size()) {
        edges[at(c.body)] = carriedOver(old.solid, edgesOf(before, c.body), *both);
    }
    out->bodies[at(c.body)].solid = *std::move(both);
    out->surface.tidy();
    return std::shared_ptr<const DocumentState>(std::move(out));
}

std::optional<int> mirrorFace(const std::vector<Body>& bodies, int body, const Vec3& point,
                              const Vec3& normal, const MirrorPlane& plane) {
    const Vec3 image = plane.image(point);
    const auto found = nearestFace(bodies, image, body);
    if (!found) return std::nullopt;
    const Body& in = bodies[at(found->body)];
    const SolidFace& face = in.solid.faces()[at(found->face)];
    const Vec3 outward = in.pose.rotation * face.normal;
    const Vec3 corner = in.pose.toWorld(in.solid.vertices()[at(face.loops.front()[0])]);
    const double off = std::abs(outward.dot(image - corner));
    constexpr double kSame = 1e-6;
    const bool same = outward.dot(plane.reflection() * normal) > 1.0 - kSame &&
                      off <= kSame * std::max(1.0, (image - corner).norm());
    if (!same) return std::nullopt;
    return found->face;
}

std::vector<EdgeRef> withMirrorEdges(const std::vector<Body>& bodies, std::vector<EdgeRef> edges,
                                     const MirrorPlane& plane) {
    const auto ends = [&](const Body& body, std::size_t edge) {
        const auto& e = body.solid.edges()[edge].ends;
        return std::array<Vec3, 2>{body.pose.toWorld(body.solid.vertices()[at(e[0])]),
                                   body.pose.toWorld(body.solid.vertices()[at(e[1])])};
    };
    const std::size_t given = edges.size();
    for (std::size_t i = 0; i < given; ++i) {
        const auto own = ends(bodies[at(edges[i].body)], at(edges[i].edge));
        const Vec3 a = plane.image(own[0]);
        const Vec3 b = plane.image(own[1]);
        const double reach = 1e-6 * std::max(1.0, (a - b).norm());
        for (std::size_t body = 0; body < bodies.size(); ++body) {
            for (std::size_t e = 0; e < bodies[body].solid.edges().size(); ++e) {
                const auto other = ends(bodies[body], e);
                const double off = std::min((other[0] - a).norm() + (other[1] - b).norm(),
                                            (other[0] - b).norm() + (other[1] - a).norm());
                if (off > reach) continue;
                const EdgeRef image{static_cast<int>(body), static_cast<int>(e)};
                const bool known = std::any_of(edges.begin(), edges.end(), [&](const EdgeRef& k) {
                    return k.body == image.body && k.edge == image.edge;
                });
                if (!known) edges.push_back(image);
            }
        }
    }
    return edges;
}

}  // namespace ew
