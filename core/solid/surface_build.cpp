// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/surface_build.h"

#include <algorithm>
#include <unordered_map>

#include "core/solid/exact_geometry.h"
#include "core/solid/validity.h"
#include "core/solid/volume_check.h"

namespace ew {
namespace {

// The person's view ------------------------------------------------------------------------------

/// True where the solid is convex along a halfedge: the far corner of the neighbour lies behind
/// the plane of the near triangle.
bool isConvex(const ExactMesh& s, Mesh::HalfedgeHandle h) {
    const Mesh& m = s.mesh;
    const auto o = m.opposite_halfedge_handle(h);
    const auto tip = [&](Mesh::HalfedgeHandle x) -> const Point3& {
        return s.point(m.to_vertex_handle(x));
    };
    return CGAL::orientation(tip(o), tip(h), tip(m.next_halfedge_handle(h)),
                             tip(m.next_halfedge_handle(o))) == CGAL::NEGATIVE;
}

void fillFaces(const ExactBrep& brep, Solid::Impl& impl) {
    for (const FaceLoops& loops : brep.faces) {
        SolidFace face;
        face.loops = loops;
        face.normal = newellNormal(impl.vertices, loops[0]);
        face.offset = face.normal.dot(impl.vertices[static_cast<std::size_t>(loops[0][0])]);
        impl.faces.push_back(std::move(face));
    }
}

void fillEdges(Solid::Impl& impl) {
    const Mesh& mesh = impl.surface.mesh;
    std::unordered_map<std::uint64_t, std::size_t> known;
    for (std::size_t f = 0; f < impl.faces.size(); ++f) {
        for (const std::vector<int>& loop : impl.faces[f].loops) {
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const int a = loop[k];
                const int b = loop[(k + 1) % loop.size()];
                const auto low = static_cast<std::uint64_t>(std::min(a, b));
                const auto key = (low << 32U) | static_cast<std::uint64_t>(std::max(a, b));
                const auto [it, fresh] = known.emplace(key, impl.edges.size());
                if (!fresh) {
                    impl.edges[it->second].faces[1] = static_cast<int>(f);
                    continue;
                }
                const auto h = mesh.find_halfedge(Mesh::VertexHandle(a), Mesh::VertexHandle(b));
                SolidEdge edge;
                edge.ends = {a, b};
                edge.faces = {static_cast<int>(f), -1};
                edge.convex = isConvex(impl.surface, h);
                impl.edges.push_back(edge);
            }
        }
    }
}

void fillMeasures(Solid::Impl& impl) {
    const Mesh& mesh = impl.surface.mesh;
    std::vector<int> shellOfFace;
    impl.shells = shellsOf(mesh, shellOfFace);
    const auto euler = static_cast<int>(mesh.n_vertices()) - static_cast<int>(mesh.n_edges()) +
                       static_cast<int>(mesh.n_faces());
    impl.genus = impl.shells - euler / 2;
    impl.volume = volumeOf(impl.surface);
    Eigen::AlignedBox3d box;
    for (const Vec3& p : impl.vertices) box.extend(p);
    impl.bounds = {box.min(), box.max()};
    for (const SolidTriangle& t : impl.triangles) {
        const auto corner = [&](std::size_t k) -> const Vec3& {
            return impl.vertices[static_cast<std::size_t>(t.vertices[k])];
        };
        impl.area += 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
    }
}

}  // namespace

Result<void> fillMesh(const std::vector<Point3>& points, const Triangulated& from, ExactMesh& to) {
    Mesh& mesh = to.mesh;
    mesh.reserve(points.size(), 3 * from.triangles.size() / 2, from.triangles.size());
    for (const Point3& p : points) {
        const Vec3 r = rounded(p);
        const auto v = mesh.add_vertex({r.x(), r.y(), r.z()});
        mesh.property(to.exact, v) = p;
    }
    for (std::size_t t = 0; t < from.triangles.size(); ++t) {
        const auto& [a, b, c] = from.triangles[t];
        const auto f =
            mesh.add_face(Mesh::VertexHandle(a), Mesh::VertexHandle(b), Mesh::VertexHandle(c));
        if (!f.is_valid()) {
            return fail(Errc::NotManifold, "The faces do not join into one closed surface.");
        }
        mesh.property(to.region, f) = from.regions[t];
    }
    for (const auto e : mesh.edges()) {
        if (mesh.is_boundary(e)) return fail(Errc::NotClosed, "The surface has a gap.");
    }
    return {};
}

std::shared_ptr<const RPlane> exactPlane(const std::vector<Point3>& points,
                                         const FaceLoops& loops) {
    const auto view = [&](int i) {
        const Point3& p = points[static_cast<std::size_t>(i)];
        return PointView{&p, rounded(p)};
    };
    std::vector<PointView> outer;
    for (const int i : loops[0]) outer.push_back(view(i));
    int sign = 0;
    const auto plane = planeOfLoop(outer, sign);
    if (!plane) return nullptr;
    for (const std::vector<int>& loop : loops) {
        for (const int i : loop) {
            if (sideOf(*plane, view(i)) != 0) return nullptr;
        }
    }
    return std::make_shared<const RPlane>(*plane);
}

std::shared_ptr<const Solid::Impl> finishSolid(ExactMesh surface, const ExactBrep& brep,
                                               const std::vector<int>& faceOfTriangle,
                                               FacePlanes planes) {
    auto impl = std::make_shared<Solid::Impl>();
    impl->surface = std::move(surface);
    ExactMesh& s = impl->surface;
    for (const auto f : s.mesh.faces()) {
        s.mesh.property(s.region, f) = faceOfTriangle[static_cast<std::size_t>(f.idx())];
        SolidTriangle t;
        std::size_t k = 0;
        for (const auto v : s.mesh.fv_range(f)) t.vertices[k++] = v.idx();
        // Start every triangle at its smallest index: a form that does not depend on the mesh.
        std::rotate(t.vertices.begin(), std::min_element(t.vertices.begin(), t.vertices.end()),
                    t.vertices.end());
        t.face = s.regionOf(f);
        impl->triangles.push_back(t);
    }
    impl->planes = std::move(planes);
    for (const Point3& p : brep.points) impl->vertices.push_back(rounded(p));
    fillFaces(brep, *impl);
    fillEdges(*impl);
    fillMeasures(*impl);
    return impl;
}

}  // namespace ew
