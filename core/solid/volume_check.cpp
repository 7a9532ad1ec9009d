// SPDX-License-Identifier: GPL-3.0-or-later
// The one file that includes CGAL's mesh algorithms; apart because they take long to compile.
#include "core/solid/volume_check.h"

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

namespace ew {

Rational exactVolume(const ExactMesh& surface) {
    // On plain rationals: a lazy sum would be a chain as long as the mesh, evaluated recursively.
    const auto& mesh = surface.mesh;
    std::vector<std::array<Rational, 3>> points;
    points.reserve(mesh.n_vertices());
    for (const auto v : mesh.vertices()) {
        const auto& e = CGAL::exact(surface.point(v));
        points.push_back({e.x(), e.y(), e.z()});
        if (v.idx() > 0) {
            for (std::size_t k = 0; k < 3; ++k) points.back()[k] -= points.front()[k];
        }
    }
    if (points.empty()) return 0;
    points.front() = {Rational(0), Rational(0), Rational(0)};
    Rational sum = 0;
    for (const auto f : mesh.faces()) {
        std::array<std::size_t, 3> t{};
        std::size_t k = 0;
        for (const auto v : mesh.fv_range(f)) t[k++] = static_cast<std::size_t>(v.idx());
        if (t[0] == 0 || t[1] == 0 || t[2] == 0) continue;
        const auto& [ax, ay, az] = points[t[0]];
        const auto& [bx, by, bz] = points[t[1]];
        const auto& [cx, cy, cz] = points[t[2]];
        sum += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
    }
    return sum / 6;
}

int shellsOf(const Mesh& mesh, std::vector<int>& shellOfFace) {
    shellOfFace.assign(mesh.n_faces(), -1);
    int shells = 0;
    std::vector<Mesh::FaceHandle> pending;
    for (const auto seed : mesh.faces()) {
        if (shellOfFace[static_cast<std::size_t>(seed.idx())] >= 0) continue;
        shellOfFace[static_cast<std::size_t>(seed.idx())] = shells;
        pending.push_back(seed);
        while (!pending.empty()) {
            const auto f = pending.back();
            pending.pop_back();
            for (const auto g : mesh.ff_range(f)) {
                int& shell = shellOfFace[static_cast<std::size_t>(g.idx())];
                if (shell >= 0) continue;
                shell = shells;
                pending.push_back(g);
            }
        }
        ++shells;
    }
    return shells;
}

Result<void> checkVolume(const ExactMesh& surface) {
    namespace pmp = CGAL::Polygon_mesh_processing;
    const Mesh& mesh = surface.mesh;
    const ExactPointMap<const Mesh*> points{&mesh, surface.exact};
    const auto options = CGAL::parameters::vertex_point_map(points);
    if (pmp::does_self_intersect(mesh, options)) {
        std::vector<std::pair<Mesh::FaceHandle, Mesh::FaceHandle>> pairs;
        pmp::self_intersections(mesh, std::back_inserter(pairs), options);
        if (pairs.empty()) return fail(Errc::SelfIntersecting, "The solid cuts through itself.");
        const int a = surface.regionOf(pairs[0].first);
        const int b = surface.regionOf(pairs[0].second);
        return fail(Errc::SelfIntersecting, "Faces " + std::to_string(std::min(a, b)) + " and " +
                                                std::to_string(std::max(a, b)) +
                                                " cut through or touch each other.");
    }
    std::vector<int> shellOfFace;
    if (shellsOf(mesh, shellOfFace) > 1 && !pmp::does_bound_a_volume(mesh, options)) {
        return fail(Errc::NotOriented, "One shell of the solid is inside out.");
    }
    // Shells alternate by now, so one sign decides for all of them.
    const Rational volume = exactVolume(surface);
    if (volume < 0) return fail(Errc::NotOriented, "The faces of the solid point inwards.");
    if (volume == 0) return fail(Errc::NoVolume, "The solid has no volume.");
    return {};
}

}  // namespace ew
