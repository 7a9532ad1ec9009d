// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/planar_triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>

namespace ew {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<int, Kernel>>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_tag>;

/// Marks triangles by the number of loops around them, from the infinite face inwards.
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
                if (g->info() < 0) (f->is_constrained(k) ? nextLevel : level).push_back(g);
            }
        }
        level.swap(nextLevel);
    }
}

Kernel::Point_2 flattened(const Vec3& p, int axis, bool flip) {
    return flip ? Kernel::Point_2(p[(axis + 2) % 3], p[(axis + 1) % 3])
                : Kernel::Point_2(p[(axis + 1) % 3], p[(axis + 2) % 3]);
}

/// Inserts further points; takes those off the list that are not inside.
/// \pre marked.
void insertPoints(Cdt& cdt, const std::vector<Vec3>& points, std::vector<int>& inside, int axis,
                  bool flip) {
    const auto place = [&](int i) {
        return flattened(points[static_cast<std::size_t>(i)], axis, flip);
    };
    Cdt::Locate_type where{};
    int side = 0;
    Cdt::Face_handle hint;
    std::erase_if(inside, [&](int i) {
        hint = cdt.locate(place(i), where, side, hint);
        const bool in = where == Cdt::FACE || (where == Cdt::EDGE && !hint->is_constrained(side));
        return !in || hint->info() % 2 == 0;
    });
    hint = {};
    std::erase_if(inside, [&](int i) {
        const auto face = cdt.locate(place(i), where, side, hint);
        if (where == Cdt::VERTEX) return true;
        const auto handle = cdt.insert(place(i), where, face, side);
        handle->info() = i;
        hint = handle->face();
        return false;
    });
}

/// Inserts the loops; false where they cross or touch.
bool insertLoops(Cdt& cdt, const std::vector<Vec3>& points,
                 std::span<const std::span<const int>> loops, int axis, bool flip) {
    std::vector<std::array<Cdt::Vertex_handle, 2>> sides;
    try {
        for (const auto loop : loops) {
            std::vector<Cdt::Vertex_handle> handles;
            Cdt::Face_handle hint;
            for (const int i : loop) {
                const Vec3& p = points[static_cast<std::size_t>(i)];
                const std::size_t before = cdt.number_of_vertices();
                const auto handle = cdt.insert(flattened(p, axis, flip), hint);
                hint = handle->face();
                if (cdt.number_of_vertices() > before) {
                    handle->info() = i;
                } else if (handle->info() != i) {
                    return false;
                }
                handles.push_back(handle);
            }
            for (std::size_t k = 0; k < handles.size(); ++k) {
                sides.push_back({handles[k], handles[(k + 1) % handles.size()]});
            }
        }
        for (const auto& [a, b] : sides) cdt.insert_constraint(a, b);
    } catch (const Cdt::Intersection_of_constraints_exception&) {
        return false;
    }
    // A side through another corner of the face was split there.
    return std::all_of(sides.begin(), sides.end(),
                       [&](const auto& side) { return cdt.is_edge(side[0], side[1]); });
}

}  // namespace

std::optional<std::vector<std::array<int, 3>>> triangulatePlanar(
    const std::vector<Vec3>& points, std::span<const std::span<const int>> loops,
    const Vec3& normal, std::vector<int>* inside) {
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    Cdt cdt;
    const bool flip = normal[axis] < 0.0;
    if (!insertLoops(cdt, points, loops, axis, flip)) return std::nullopt;
    markInside(cdt);
    if (inside) {
        insertPoints(cdt, points, *inside, axis, flip);
        markInside(cdt);
    }
    std::vector<std::array<int, 3>> out;
    std::size_t corners = inside ? 2 * inside->size() : 0;
    for (const auto loop : loops) corners += loop.size();
    out.reserve(corners + 2 * loops.size());
    for (auto f : cdt.finite_face_handles()) {
        if (f->info() % 2 == 0) continue;
        out.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
    }
    // Euler: another number means that a hole lies outside, or loops overlap.
    if (out.size() != corners + 2 * (loops.size() - 1) - 2) return std::nullopt;
    // An outline that runs the wrong way round encloses triangles all the same.
    const int a = loops[0][0];
    const int b = loops[0][1];
    for (const auto& t : out) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (t[k] == b && t[(k + 1) % 3] == a) return std::nullopt;
        }
    }
    return out;
}

}  // namespace ew
