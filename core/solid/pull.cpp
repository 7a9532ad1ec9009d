// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/pull.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/base/tolerance.h"
#include "core/solid/assemble.h"
#include "core/solid/boolean.h"
#include "core/solid/exact_geometry.h"
#include "core/solid/exact_tool.h"

namespace ew {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

std::string millimetres(double value) {
    char text[40];
    std::snprintf(text, sizeof(text), "%.6g mm", value);
    return text;
}

Result<void> checkDistance(double distance) {
    if (!std::isfinite(distance) || std::abs(distance) > tol::kMaxCoordinateMm) {
        return fail(Errc::BadValue, "A face cannot be pulled so far.");
    }
    if (distance == 0.0) return fail(Errc::NoChange, "A pull by 0 mm changes nothing.");
    return {};
}

/// The point that three planes have in common, if it is one.
std::optional<RVec> commonPoint(const RPlane& a, const RPlane& b, const RPlane& c) {
    const RVec bc = cross(b.normal, c.normal);
    const Rational det = dot(a.normal, bc);
    if (det == 0) return std::nullopt;
    const RVec ca = cross(c.normal, a.normal);
    const RVec ab = cross(a.normal, b.normal);
    RVec out;
    for (std::size_t k = 0; k < 3; ++k) {
        out[k] = (a.offset * bc[k] + b.offset * ca[k] + c.offset * ab[k]) / det;
    }
    return out;
}

class Pull {
  public:
    Pull(const Solid& solid, int face, double distance)
        : solid_(solid), impl_(solid.impl()), face_(face), distance_(distance) {}

    Result<PullOutcome> run(PullWalls walls) {
        if (auto ok = begin(); !ok) return fail(ok.error());
        if (walls == PullWalls::Straight && wallsAreStraight()) walls = PullWalls::Follow;
        const auto corners = walls == PullWalls::Follow ? followed() : straight();
        if (!corners) return fail(corners.error());
        if (walls == PullWalls::Follow) {
            if (auto slid = slide(*corners)) return PullOutcome{*std::move(slid), true};
        }
        auto tool = sweep(*corners);
        if (!tool) return fail(tool.error());
        auto made = combine(solid_, *tool, distance_ > 0.0 ? BooleanKind::Add : BooleanKind::Cut);
        if (!made) return fail(made.error());
        return PullOutcome{std::move(made->solid), false};
    }

  private:
    using Corners = std::map<int, RVec>;  ///< by vertex of the face: where it comes to lie

    Result<void> begin() {
        if (face_ < 0 || idx(face_) >= impl_.faces.size()) {
            return fail(Errc::BadValue, "The solid has no such face to pull.");
        }
        if (auto ok = checkDistance(distance_); !ok) return ok;
        if (!impl_.planes[idx(face_)]) {
            return fail(Errc::NotPlanar,
                        "This face is not flat enough to be pulled: its corners lie in one plane "
                        "to the eye only.");
        }
        plane_ = moved_ = *impl_.planes[idx(face_)];
        // Parallel planes have one normal, so a move and its reverse are the same number.
        const Rational length(plane_.n.norm());
        shift_ = Rational(distance_) * length;
        if (plane_.n.dot(impl_.faces[idx(face_)].normal) < 0.0) shift_ = -shift_;
        moved_.offset += shift_;
        moved_.d = CGAL::to_double(moved_.offset);
        findNeighbours();
        return {};
    }

    void findNeighbours() {
        for (const SolidEdge& e : impl_.edges) {
            for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
                if (e.faces[side] != face_) continue;
                // As the face runs along it.
                const int from = e.ends[side];
                const int to = e.ends[1 - side];
                beside_[{from, to}] = e.faces[1 - side];
            }
        }
    }

    const RPlane* planeOf(int face) const { return impl_.planes[idx(face)].get(); }

    RVec point(int v) const {
        return coordinates(
            PointView{&impl_.surface.point(Mesh::VertexHandle(v)), impl_.vertices[idx(v)]});
    }

    /// visit(before, corner, after) for every corner of the face.
    template <class Visit>
    void eachCorner(const Visit& visit) const {
        for (const std::vector<int>& loop : impl_.faces[idx(face_)].loops) {
            const std::size_t n = loop.size();
            for (std::size_t k = 0; k < n; ++k) {
                visit(loop[(k + n - 1) % n], loop[k], loop[(k + 1) % n]);
            }
        }
    }

    bool wallsAreStraight() const {
        return std::all_of(beside_.begin(), beside_.end(), [&](const auto& edge) {
            const RPlane* wall = planeOf(edge.second);
            return wall != nullptr && dot(wall->normal, plane_.normal) == 0;
        });
    }

    /// Where the planes beside the face cut the moved plane.
    Result<Corners> followed() const {
        Corners out;
        bool flat = true;
        eachCorner([&](int before, int corner, int after) {
            const RPlane* in = planeOf(beside_.at({before, corner}));
            const RPlane* away = planeOf(beside_.at({corner, after}));
            const auto p =
                in != nullptr && away != nullptr ? commonPoint(moved_, *in, *away) : std::nullopt;
            if (p)
                out[corner] = *p;
            else
                flat = false;
        });
        if (!flat) {
            return fail(Errc::NotPlanar,
                        "The faces beside this one do not tell where its corners would go; pull it "
                        "with straight walls.");
        }
        if (const auto most = vanishesAfter(out)) {
            return fail(Errc::OperationImpossible,
                        "The face would shrink to nothing after " + millimetres(*most) +
                            "; pull it less far, or with straight walls.");
        }
        return out;
    }

    /// The distance at which the first edge of the face has no length any more, if that is not
    /// farther than the pull. [mm]
    std::optional<double> vanishesAfter(const Corners& corners) const {
        std::optional<double> least;
        eachCorner([&](int, int corner, int after) {
            const RVec to = point(after);
            const RVec from = point(corner);
            RVec edge, then;
            for (std::size_t k = 0; k < 3; ++k) {
                edge[k] = to[k] - from[k];
                then[k] = corners.at(after)[k] - corners.at(corner)[k];
            }
            const Rational along = dot(edge, then);
            if (along > 0) return;
            const double left = CGAL::to_double(Rational(along / dot(edge, edge)));
            const double most = std::abs(distance_) / (1.0 - left);
            if (!least || most < *least) least = most;
        });
        return least;
    }

    /// Every corner moved along the normal.
    Result<Corners> straight() const {
        const Rational share = shift_ / dot(plane_.normal, plane_.normal);
        Corners out;
        eachCorner([&](int, int corner, int) {
            RVec p = point(corner);
            for (std::size_t k = 0; k < 3; ++k) p[k] += share * plane_.normal[k];
            out[corner] = p;
        });
        return out;
    }

    /// The solid with the face's corners moved and nothing else changed, where that is one.
    std::optional<Solid> slide(const Corners& corners) const {
        std::map<int, std::set<int>> facesAt;
        for (const SolidEdge& e : impl_.edges) {
            for (const int v : e.ends) facesAt[v].insert(e.faces.begin(), e.faces.end());
        }
        constexpr std::size_t kThree = 3;
        bool simple = true;
        eachCorner([&](int, int corner, int) { simple &= facesAt[corner].size() == kThree; });
        if (!simple) return std::nullopt;
        ExactBrep brep;
        for (std::size_t v = 0; v < impl_.vertices.size(); ++v) {
            const auto moved = corners.find(static_cast<int>(v));
            brep.points.push_back(moved == corners.end()
                                      ? impl_.surface.point(Mesh::VertexHandle(static_cast<int>(v)))
                                      : pointAt(moved->second));
        }
        for (const SolidFace& f : impl_.faces) brep.faces.push_back(f.loops);
        auto made = assemble(std::move(brep));
        if (!made) return std::nullopt;
        const Solid::Impl& after = **made;
        if (after.vertices.size() != impl_.vertices.size() || !sameEdges(after)) {
            return std::nullopt;
        }
        return Solid(std::move(*made));
    }

    bool sameEdges(const Solid::Impl& after) const {
        return std::equal(after.edges.begin(), after.edges.end(), impl_.edges.begin(),
                          impl_.edges.end(), [](const SolidEdge& a, const SolidEdge& b) {
                              return a.ends == b.ends && a.faces == b.faces;
                          });
    }

    static Point3 pointAt(const RVec& p) { return {Exact(p[0]), Exact(p[1]), Exact(p[2])}; }

    /// What the face sweeps on its way.
    Result<Solid> sweep(const Corners& corners) const {
        ExactBrep brep;
        std::map<int, int> from, to;  // by vertex of the face: its index in the sweep
        for (const auto& [v, p] : corners) {
            from[v] = static_cast<int>(brep.points.size());
            brep.points.push_back(impl_.surface.point(Mesh::VertexHandle(v)));
            to[v] = static_cast<int>(brep.points.size());
            brep.points.push_back(pointAt(p));
        }
        const bool outwards = distance_ > 0.0;
        FaceLoops start, end;
        for (const std::vector<int>& loop : impl_.faces[idx(face_)].loops) {
            start.emplace_back();
            end.emplace_back();
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const int a = loop[k];
                const int b = loop[(k + 1) % loop.size()];
                start.back().push_back(from.at(a));
                end.back().push_back(to.at(a));
                std::vector<int> wall{from.at(a), from.at(b), to.at(b), to.at(a)};
                if (!outwards) std::reverse(wall.begin(), wall.end());
                brep.faces.push_back({std::move(wall)});
            }
            std::vector<int>& back = outwards ? start.back() : end.back();
            std::reverse(back.begin(), back.end());
        }
        brep.faces.push_back(std::move(start));
        brep.faces.push_back(std::move(end));
        auto made = assemble(std::move(brep));
        if (!made) return fail(made.error());
        return Solid(std::move(*made));
    }

    const Solid& solid_;
    const Solid::Impl& impl_;
    int face_;
    double distance_;
    RPlane plane_;    ///< of the face
    RPlane moved_;    ///< where it comes to lie
    Rational shift_;  ///< between the two, in units of the plane's normal
    std::map<std::pair<int, int>, int> beside_;  ///< by directed edge of the face: the other face
};

}  // namespace

Result<PullOutcome> pullFace(const Solid& solid, int face, double distance, PullWalls walls) {
    try {
        return Pull(solid, face, distance).run(walls);
    } catch (const std::exception& e) {
        return fail(Errc::Internal, std::string("The face could not be pulled: ") + e.what());
    }
}

Result<PullOutcome> pullProfile(const Solid& solid, int face, const std::vector<Vec3>& corners,
                                double distance) {
    if (face < 0 || idx(face) >= solid.faces().size() || corners.size() < 3) {
        return fail(Errc::BadValue, "The solid has no such face to pull.");
    }
    if (auto ok = checkDistance(distance); !ok) return fail(ok.error());
    const int n = static_cast<int>(corners.size());
    ToolSpec spec;
    std::vector<int> base, top;
    spec.shape.vertices = corners;
    for (int k = 0; k < n; ++k) {
        spec.shape.vertices.push_back(corners[idx(k)] + distance * solid.faces()[idx(face)].normal);
        base.push_back(k);
        top.push_back(n + k);
        std::vector<int> wall{k, (k + 1) % n, n + (k + 1) % n, n + k};
        if (distance < 0.0) std::reverse(wall.begin(), wall.end());
        spec.shape.faces.push_back(std::move(wall));
        spec.edges.push_back({{k, n + k}, ToolEdgeRule::Kind::AlongNormal, face, -1});
    }
    std::vector<int>& back = distance > 0.0 ? base : top;
    std::reverse(back.begin(), back.end());
    spec.faces.push_back({n, ToolFaceRule::Kind::InFace, face});
    spec.shape.faces.push_back(std::move(base));
    spec.shape.faces.push_back(std::move(top));
    spec.snap = true;
    const auto tool = makeTool(solid, spec);
    if (!tool) return fail(tool.error());
    auto made = combine(solid, *tool, distance > 0.0 ? BooleanKind::Add : BooleanKind::Cut);
    if (!made) return fail(made.error());
    return PullOutcome{std::move(made->solid), false};
}

}  // namespace ew
