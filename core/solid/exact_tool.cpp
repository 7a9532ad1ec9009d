// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/exact_tool.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/tolerance.h"
#include "core/solid/assemble.h"
#include "core/solid/tool_fixing.h"
#include "core/solid/validity.h"

namespace ew {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

/// The target's exact lines, planes and points.
class TargetGeometry {
  public:
    explicit TargetGeometry(const Solid& target) : impl_(target.impl()) {}

    bool hasVertex(int v) const { return v >= 0 && idx(v) < impl_.vertices.size(); }
    bool hasEdge(int e) const { return e >= 0 && idx(e) < impl_.edges.size(); }
    bool hasFace(int f) const { return f >= 0 && idx(f) < impl_.faces.size(); }

    PointView point(int v) const {
        return {&impl_.surface.point(Mesh::VertexHandle(v)), impl_.vertices[idx(v)]};
    }
    RVec edgeDirection(int e) const {
        const auto& [a, b] = impl_.edges[idx(e)].ends;
        return minus(point(b), point(a));
    }
    RPlane plane(int f) const {
        if (impl_.planes[idx(f)]) return *impl_.planes[idx(f)];
        std::vector<PointView> loop;
        for (const int v : impl_.faces[idx(f)].loops[0]) loop.push_back(point(v));
        int sign = 0;
        return planeOfLoop(loop, sign).value_or(RPlane{});
    }
    /// Two directions that span the plane.
    std::array<RVec, 2> directionsIn(int f) const {
        const RPlane p = plane(f);
        std::array<RVec, 2> out;
        const auto k = idx(p.axis);
        for (std::size_t i = 0; i < 2; ++i) {
            const std::size_t u = (k + 1 + i) % 3;
            RVec d{0, 0, 0};
            d[u] = 1;
            d[k] = -p.normal[u];
            out[i] = d;
        }
        return out;
    }
    const Solid::Impl& impl() const { return impl_; }

  private:
    const Solid::Impl& impl_;
};

Unexpected<Error> badRule(const std::string& what) {
    return fail(Errc::BadValue, "A rule of the tool names " + what + " that does not exist.");
}

Result<void> addFaceRule(const TargetGeometry& target, const ToolFaceRule& rule, ToolFixing& fix) {
    using Kind = ToolFaceRule::Kind;
    if (!fix.hasFace(rule.face)) return badRule("a face of the tool");
    const bool ofEdge = rule.kind == Kind::NormalToEdge || rule.kind == Kind::AlongEdge;
    const bool ofVertex = rule.kind == Kind::ThroughVertex;
    if (ofEdge     ? !target.hasEdge(rule.index)
        : ofVertex ? !target.hasVertex(rule.index)
                   : !target.hasFace(rule.index)) {
        return badRule("a part of the solid");
    }
    switch (rule.kind) {
        case Kind::InFace:
            fix.faceIn(rule.face, target.plane(rule.index));
            break;
        case Kind::ParallelToFace:
            for (const RVec& d : target.directionsIn(rule.index)) fix.faceAlong(rule.face, d);
            break;
        case Kind::NormalToEdge: {
            const RVec n = target.edgeDirection(rule.index);
            // Any two directions perpendicular to the edge.
            std::size_t k = 0;
            for (std::size_t i = 1; i < 3; ++i) k = abs(n[i]) > abs(n[k]) ? i : k;
            for (const std::size_t u : {(k + 1) % 3, (k + 2) % 3}) {
                RVec d{0, 0, 0};
                d[u] = n[k];
                d[k] = -n[u];
                fix.faceAlong(rule.face, d);
            }
            break;
        }
        case Kind::AlongEdge:
            fix.faceAlong(rule.face, target.edgeDirection(rule.index));
            break;
        case Kind::AlongNormal:
            fix.faceAlong(rule.face, target.plane(rule.index).normal);
            break;
        case Kind::ThroughVertex:
            fix.faceThrough(rule.face, coordinates(target.point(rule.index)));
            break;
    }
    return {};
}

Result<void> addVertexRule(const TargetGeometry& target, const ToolVertexRule& rule,
                           ToolFixing& fix) {
    using Kind = ToolVertexRule::Kind;
    if (!fix.hasVertex(rule.vertex)) return badRule("a corner of the tool");
    switch (rule.kind) {
        case Kind::AtVertex:
            if (!target.hasVertex(rule.index)) return badRule("a corner of the solid");
            fix.vertexAt(rule.vertex, coordinates(target.point(rule.index)));
            break;
        case Kind::OnEdge:
            if (!target.hasEdge(rule.index)) return badRule("an edge of the solid");
            for (const int f : target.impl().edges[idx(rule.index)].faces) {
                fix.vertexOn(rule.vertex, target.plane(f));
            }
            break;
        case Kind::OnFace:
            if (!target.hasFace(rule.index)) return badRule("a face of the solid");
            fix.vertexOn(rule.vertex, target.plane(rule.index));
            break;
        case Kind::BetweenVertices: {
            if (!target.hasVertex(rule.index) || !target.hasVertex(rule.other)) {
                return badRule("a corner of the solid");
            }
            if (!std::isfinite(rule.t) || std::abs(rule.t) > tol::kMaxCoordinateMm) {
                return fail(Errc::BadValue, "A rule of the tool holds no usable number.");
            }
            RVec p = coordinates(target.point(rule.index));
            const RVec d = minus(target.point(rule.other), target.point(rule.index));
            for (std::size_t k = 0; k < 3; ++k) p[k] += Rational(rule.t) * d[k];
            fix.vertexAt(rule.vertex, p);
            break;
        }
    }
    return {};
}

Result<void> addEdgeRule(const TargetGeometry& target, const PolyhedronSpec& shape,
                         const ToolEdgeRule& rule, ToolFixing& fix) {
    using Kind = ToolEdgeRule::Kind;
    if (rule.kind == Kind::AlongNormal ? !target.hasFace(rule.index)
                                       : !target.hasEdge(rule.index)) {
        return badRule("a part of the solid");
    }
    if (rule.kind == Kind::AcrossEdge && !target.hasFace(rule.other)) {
        return badRule("a face of the solid");
    }
    const RVec direction = rule.kind == Kind::AlongNormal ? target.plane(rule.index).normal
                           : rule.kind == Kind::AlongEdge ? target.edgeDirection(rule.index)
                                                          : cross(target.plane(rule.other).normal,
                                                                  target.edgeDirection(rule.index));
    int faces = 0;
    for (std::size_t f = 0; f < shape.faces.size(); ++f) {
        const auto& loop = shape.faces[f];
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const std::array<int, 2> side{loop[k], loop[(k + 1) % loop.size()]};
            if (side != rule.ends && side != std::array{rule.ends[1], rule.ends[0]}) continue;
            fix.faceAlong(static_cast<int>(f), direction);
            ++faces;
        }
    }
    if (faces == 0) return badRule("an edge of the tool");
    return {};
}

/// Rules for what the doubles show.
ToolSpec snapped(const Solid& target, const ToolSpec& spec) {
    ToolSpec out = spec;
    const double near =
        tol::kThinnestRelative * std::max(sizeOf(spec.shape.vertices), sizeOf(target.vertices()));
    for (std::size_t f = 0; f < spec.shape.faces.size(); ++f) {
        const auto& loop = spec.shape.faces[f];
        const Vec3 normal = newellNormal(spec.shape.vertices, loop);
        int parallel = -1;
        int in = -1;
        for (std::size_t g = 0; g < target.faces().size() && in < 0; ++g) {
            const SolidFace& face = target.faces()[g];
            if (face.normal.cross(normal).norm() > tol::kToolSnap) continue;
            if (parallel < 0) parallel = static_cast<int>(g);
            const bool all = std::all_of(loop.begin(), loop.end(), [&](int v) {
                return std::abs(face.normal.dot(spec.shape.vertices[idx(v)]) - face.offset) <= near;
            });
            if (all) in = static_cast<int>(g);
        }
        if (in >= 0) {
            out.faces.push_back({static_cast<int>(f), ToolFaceRule::Kind::InFace, in});
        } else if (parallel >= 0) {
            out.faces.push_back(
                {static_cast<int>(f), ToolFaceRule::Kind::ParallelToFace, parallel});
        }
    }
    for (std::size_t v = 0; v < spec.shape.vertices.size(); ++v) {
        const bool spoken = std::any_of(spec.vertices.begin(), spec.vertices.end(),
                                        [&](const auto& r) { return idx(r.vertex) == v; });
        if (spoken) continue;
        for (std::size_t w = 0; w < target.vertices().size(); ++w) {
            if ((target.vertices()[w] - spec.shape.vertices[v]).norm() > near) continue;
            out.vertices.push_back({static_cast<int>(v), ToolVertexRule::Kind::AtVertex,
                                    static_cast<int>(w), -1, 0.0});
            break;
        }
    }
    return out;
}

Result<Solid> made(const Solid& target, const ToolSpec& spec) {
    std::vector<FaceLoops> faces;
    for (const auto& face : spec.shape.faces) faces.push_back({face});
    if (auto ok = checkCoordinates(spec.shape.vertices); !ok) return fail(ok.error());
    if (auto ok = checkLoops(spec.shape.vertices.size(), faces); !ok) return fail(ok.error());
    // A tool is drawn, so its faces may be off by what a rule moves them.
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (newellNormal(spec.shape.vertices, spec.shape.faces[f]).isZero(0.0)) {
            return fail(Errc::NoVolume, "Face " + std::to_string(f) + " has no area.");
        }
    }
    ToolFixing fix(spec.shape);
    const TargetGeometry geometry(target);
    for (const auto& rule : spec.faces) {
        if (auto ok = addFaceRule(geometry, rule, fix); !ok) return fail(ok.error());
    }
    for (const auto& rule : spec.vertices) {
        if (auto ok = addVertexRule(geometry, rule, fix); !ok) return fail(ok.error());
    }
    for (const auto& rule : spec.edges) {
        if (auto ok = addEdgeRule(geometry, spec.shape, rule, fix); !ok) return fail(ok.error());
    }
    auto points = fix.solve();
    if (!points) return fail(points.error());
    ExactBrep brep;
    for (const RVec& p : *points) {
        brep.points.emplace_back(Exact(p[0]), Exact(p[1]), Exact(p[2]));
    }
    brep.faces = std::move(faces);
    auto impl = assemble(std::move(brep));
    if (!impl) return fail(impl.error());
    return Solid(std::move(*impl));
}

}  // namespace

Result<Solid> makeTool(const Solid& target, const ToolSpec& spec) {
    try {
        for (const Vec3& p : spec.shape.vertices) {
            if (!p.allFinite()) {
                return fail(Errc::BadValue, "A corner of the tool is not a usable number.");
            }
        }
        if (!spec.snap) return made(target, spec);
        auto tool = made(target, snapped(target, spec));
        // What is so near need not fit together.
        if (tool || tool.error().code != Errc::Contradiction) return tool;
        return made(target, spec);
    } catch (const std::exception& e) {
        return fail(Errc::Internal, std::string("The tool could not be made: ") + e.what());
    }
}

}  // namespace ew
