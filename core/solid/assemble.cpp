// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/assemble.h"

#include <algorithm>
#include <unordered_map>

#include "core/solid/brep.h"
#include "core/solid/triangulate.h"
#include "core/solid/validity.h"
#include "core/solid/volume_check.h"

namespace ew {
namespace {

struct Triangulated {
    std::vector<std::array<int, 3>> triangles;
    std::vector<int> regions;
};

Result<Triangulated> triangulateAll(const ExactBrep& brep) {
    Triangulated out;
    for (std::size_t f = 0; f < brep.faces.size(); ++f) {
        auto triangles = triangulateFace(brep.points, brep.faces[f], f);
        if (!triangles) return fail(triangles.error());
        out.triangles.insert(out.triangles.end(), triangles->begin(), triangles->end());
        out.regions.resize(out.triangles.size(), static_cast<int>(f));
    }
    return out;
}

/// A diagonal that runs where an edge or another diagonal runs: the faces overlap there.
Result<void> checkTriangles(std::size_t pointCount, const Triangulated& surface) {
    std::vector<FaceLoops> faces;
    faces.reserve(surface.triangles.size());
    for (const auto& t : surface.triangles) faces.push_back({{t[0], t[1], t[2]}});
    if (auto ok = checkLoops(pointCount, faces); !ok) {
        return fail(Errc::SelfIntersecting, "Faces of the solid overlap.");
    }
    return checkFans(pointCount, surface.triangles);
}

Result<void> fillMesh(const ExactBrep& brep, const Triangulated& from, ExactMesh& to) {
    Mesh& mesh = to.mesh;
    mesh.reserve(brep.points.size(), 3 * from.triangles.size() / 2, from.triangles.size());
    for (const Point3& p : brep.points) {
        const Vec3 r = rounded(p);
        const auto v = mesh.add_vertex({r.x(), r.y(), r.z()});
        mesh.property(to.exact, v) = p;
    }
    for (std::size_t t = 0; t < from.triangles.size(); ++t) {
        const auto& [a, b, c] = from.triangles[t];
        const auto f =
            mesh.add_face(Mesh::VertexHandle(a), Mesh::VertexHandle(b), Mesh::VertexHandle(c));
        if (!f.is_valid()) {
            return fail(Errc::Internal, "The faces could not be joined into one surface.");
        }
        mesh.property(to.region, f) = from.regions[t];
    }
    return {};
}

/// Mesh and gate for one brep.
Result<void> build(const ExactBrep& brep, ExactMesh& surface) {
    if (auto ok = checkLoops(brep.points.size(), brep.faces); !ok) return ok;
    std::vector<Vec3> points;
    points.reserve(brep.points.size());
    for (const Point3& p : brep.points) points.push_back(rounded(p));
    if (auto ok = checkCoordinates(points); !ok) return ok;
    if (auto ok = checkPlanar(points, brep.faces); !ok) return ok;
    auto triangles = triangulateAll(brep);
    if (!triangles) return fail(triangles.error());
    if (auto ok = checkTriangles(points.size(), *triangles); !ok) return ok;
    if (auto ok = fillMesh(brep, *triangles, surface); !ok) return ok;
    return checkVolume(surface);
}

// The person's view
// --------------------------------------------------------------------------------

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
    impl.volume = CGAL::to_double(exactVolume(impl.surface));
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

std::shared_ptr<const Solid::Impl> finish(ExactMesh surface, const PersonView& view) {
    auto impl = std::make_shared<Solid::Impl>();
    impl->surface = std::move(surface);
    ExactMesh& s = impl->surface;
    for (const auto f : s.mesh.faces()) {
        s.mesh.property(s.region, f) = view.faceOfTriangle[static_cast<std::size_t>(f.idx())];
        SolidTriangle t;
        std::size_t k = 0;
        for (const auto v : s.mesh.fv_range(f)) t.vertices[k++] = v.idx();
        // Start every triangle at its smallest index: a form that does not depend on the mesh.
        std::rotate(t.vertices.begin(), std::min_element(t.vertices.begin(), t.vertices.end()),
                    t.vertices.end());
        t.face = s.regionOf(f);
        impl->triangles.push_back(t);
    }
    for (const Point3& p : view.brep.points) impl->vertices.push_back(rounded(p));
    fillFaces(view.brep, *impl);
    fillEdges(*impl);
    fillMeasures(*impl);
    return impl;
}

}  // namespace

Result<std::shared_ptr<const Solid::Impl>> assemble(ExactBrep brep) {
    // The order of the loops decides between equally good diagonals; with one order for all, a
    // solid read back from a file has the same triangles.
    for (FaceLoops& loops : brep.faces) {
        const bool usable = std::all_of(loops.begin(), loops.end(),
                                        [](const std::vector<int>& loop) { return !loop.empty(); });
        if (usable) orderLoops(loops);
    }
    // What was merged and dropped is triangulated anew, and then nothing is left to merge.
    for (int round = 0; round < 3; ++round) {
        ExactMesh surface;
        if (auto ok = build(brep, surface); !ok) return fail(ok.error());
        PersonView view = personView(surface, brep.faces.size());
        if (!view.changed && view.brep.faces == brep.faces) {
            return finish(std::move(surface), view);
        }
        brep = std::move(view.brep);
    }
    return fail(Errc::Internal, "The faces of the solid could not be brought into one form.");
}

}  // namespace ew
