// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include "tests/surface/shapes.h"

namespace ew::test {

std::string faultsByExactArithmetic(const std::vector<Vec3>& points,
                                    const std::vector<std::array<int, 3>>& triangles) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
    Mesh mesh;
    std::vector<Mesh::Vertex_index> ids(points.size(), Mesh::null_vertex());
    for (const auto& t : triangles) {
        std::array<Mesh::Vertex_index, 3> v;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto i = static_cast<std::size_t>(t[k]);
            if (!points[i].allFinite()) return "a point is not finite";
            if (ids[i] == Mesh::null_vertex()) {
                ids[i] = mesh.add_vertex({points[i].x(), points[i].y(), points[i].z()});
            }
            v[k] = ids[i];
        }
        if (mesh.add_face(v[0], v[1], v[2]) == Mesh::null_face()) return "not manifold or oriented";
    }
    if (!CGAL::is_closed(mesh)) return "not closed";
    for (const auto v : mesh.vertices()) {
        std::size_t around = 0;
        for (const auto h : CGAL::halfedges_around_target(mesh.halfedge(v), mesh)) {
            static_cast<void>(h);
            ++around;
        }
        if (around != mesh.degree(v)) return "a pinched point";
    }
    std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> pairs;
    CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
    if (!pairs.empty()) {
        return std::to_string(pairs.size()) + " self-intersections, first of triangles " +
               std::to_string(pairs[0].first) + " and " + std::to_string(pairs[0].second);
    }
    return {};
}

std::string faultsByExactArithmetic(const FilletedCage& cage) {
    if (auto closed = checkClosed(cage.mesh); !closed) return closed.error().message;
    const auto triangles = triangulate(cage.mesh);
    if (!triangles) return triangles.error().message;
    return faultsByExactArithmetic(cage.mesh.points, triangles->triangles);
}

}  // namespace ew::test
