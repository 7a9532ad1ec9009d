// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/triangulate.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>

#include "core/solid/validity.h"

namespace ew {
namespace {

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<int, Kernel>>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_tag>;
using Point2 = Kernel::Point_2;

/// Drops one axis. With `flip` the other two change places, so that the face is counter-clockwise.
struct Projection {
    int axis = 2;
    bool flip = false;

    Point2 operator()(const Point3& p) const {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        return flip ? Point2(p[v], p[u]) : Point2(p[u], p[v]);
    }
};

/// Orientation of a simple loop, read at its smallest point, where it must turn its own way.
CGAL::Orientation loopOrientation(const std::vector<Point2>& loop) {
    const auto lowest = std::min_element(loop.begin(), loop.end(), Kernel::Less_xy_2());
    const std::size_t n = loop.size();
    const auto i = static_cast<std::size_t>(lowest - loop.begin());
    return CGAL::orientation(loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n]);
}

/// The projection along the largest axis of the normal in which the outer loop has an area.
bool chooseProjection(const std::vector<Point3>& points, const std::vector<int>& outer,
                      Projection& out) {
    Vec3 normal = Vec3::Zero();
    {
        std::vector<Vec3> loop;
        std::vector<int> all;
        for (const int i : outer) {
            loop.push_back(rounded(points[static_cast<std::size_t>(i)]));
            all.push_back(static_cast<int>(all.size()));
        }
        normal = newellNormal(loop, all).cwiseAbs();
    }
    std::array<int, 3> axes{0, 1, 2};
    std::sort(axes.begin(), axes.end(), [&](int a, int b) { return normal[a] > normal[b]; });
    for (const int axis : axes) {
        const Projection candidate{axis, false};
        std::vector<Point2> loop;
        for (const int i : outer) loop.push_back(candidate(points[static_cast<std::size_t>(i)]));
        const auto turn = loopOrientation(loop);
        if (turn == CGAL::COLLINEAR) continue;
        out = {axis, turn == CGAL::RIGHT_TURN};
        return true;
    }
    return false;
}

/// Marks the triangles inside an odd number of loops, from the infinite face inwards.
void markInside(Cdt& cdt) {
    for (auto f : cdt.all_face_handles()) f->info() = -1;
    std::vector<Cdt::Face_handle> level{cdt.infinite_face()};
    std::vector<Cdt::Face_handle> nextLevel;
    for (int depth = 0; !level.empty(); ++depth) {
        while (!level.empty()) {
            const auto f = level.back();
            level.pop_back();
            if (f->info() >= 0) continue;
            f->info() = depth;
            for (int k = 0; k < 3; ++k) {
                const auto g = f->neighbor(k);
                if (g->info() >= 0) continue;
                (f->is_constrained(k) ? nextLevel : level).push_back(g);
            }
        }
        level.swap(nextLevel);
    }
}

Unexpected<Error> touches(std::size_t face) {
    return fail(Errc::SelfIntersecting,
                "The outline of face " + std::to_string(face) + " crosses or touches itself.");
}

}  // namespace

Result<std::vector<std::array<int, 3>>> triangulateFace(const std::vector<Point3>& points,
                                                        const FaceLoops& loops, std::size_t face) {
    const auto point = [&](int i) -> const Point3& { return points[static_cast<std::size_t>(i)]; };
    const std::vector<int>& outer = loops[0];
    if (loops.size() == 1 && outer.size() == 3) {
        if (CGAL::collinear(point(outer[0]), point(outer[1]), point(outer[2]))) {
            return fail(Errc::NoVolume, "Face " + std::to_string(face) + " has no area.");
        }
        return std::vector<std::array<int, 3>>{{outer[0], outer[1], outer[2]}};
    }
    Projection project;
    if (!chooseProjection(points, outer, project)) {
        return fail(Errc::NoVolume, "Face " + std::to_string(face) + " has no area.");
    }
    Cdt cdt;
    std::size_t corners = 0;
    std::vector<std::array<Cdt::Vertex_handle, 2>> sides;
    try {
        for (const std::vector<int>& loop : loops) {
            std::vector<Cdt::Vertex_handle> handles;
            for (const int i : loop) {
                const std::size_t before = cdt.number_of_vertices();
                const auto v = cdt.insert(project(point(i)));
                if (cdt.number_of_vertices() > before) {
                    v->info() = i;
                } else if (v->info() != i) {
                    return touches(face);  // two points of the solid in one place
                }
                handles.push_back(v);
            }
            for (std::size_t k = 0; k < handles.size(); ++k) {
                sides.push_back({handles[k], handles[(k + 1) % handles.size()]});
                cdt.insert_constraint(sides.back()[0], sides.back()[1]);
            }
            corners += loop.size();
        }
    } catch (const Cdt::Intersection_of_constraints_exception&) {
        return touches(face);
    }
    // A side that runs through another point of the face was split there.
    for (const auto& [a, b] : sides) {
        if (!cdt.is_edge(a, b)) return touches(face);
    }
    markInside(cdt);
    std::vector<std::array<int, 3>> out;
    for (auto f : cdt.finite_face_handles()) {
        if (f->info() % 2 == 0) continue;
        out.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
    }
    // Euler: fewer or more triangles mean that a hole lies outside, or loops overlap.
    if (out.size() != corners + 2 * (loops.size() - 1) - 2) return touches(face);
    return out;
}

}  // namespace ew
