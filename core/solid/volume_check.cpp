// SPDX-License-Identifier: GPL-3.0-or-later
// The one file that includes CGAL's mesh algorithms; apart because they take long to compile.
#include "core/solid/volume_check.h"

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include <algorithm>
#include <optional>

#include "core/base/tolerance.h"
#include "core/solid/exact_geometry.h"

namespace ew {
namespace {

bool lexicographic(const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

}  // namespace

double volumeOf(const ExactMesh& surface) {
    // Relative to a corner, so that a solid far from the origin loses no digits; compensated.
    double sum = 0.0;
    double rest = 0.0;
    std::optional<Vec3> origin;
    for (const auto f : surface.mesh.faces()) {
        std::array<Vec3, 3> t;
        std::size_t k = 0;
        for (const auto v : surface.mesh.fv_range(f)) {
            const auto& p = surface.mesh.point(v);
            t[k++] = Vec3(p[0], p[1], p[2]);
        }
        // The same start for all ways that a mesh may have been made.
        std::rotate(t.begin(), std::min_element(t.begin(), t.end(), lexicographic), t.end());
        if (!origin) origin = t[0];
        const double term = (t[0] - *origin).dot((t[1] - *origin).cross(t[2] - *origin)) / 6.0;
        const double next = sum + term;
        rest += std::abs(sum) >= std::abs(term) ? (sum - next) + term : (term - next) + sum;
        sum = next;
    }
    return sum + rest;
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

namespace {

/// Six times the signed volume in doubles with a bound of its error.
struct Measure {
    double six = 0.0;
    double error = 0.0;
};

Measure measure(const std::vector<std::array<Vec3, 3>>& triangles) {
    Measure out;
    if (triangles.empty()) return out;
    const Vec3 origin = triangles[0][0];
    double reach = origin.cwiseAbs().maxCoeff();
    for (const auto& [a, b, c] : triangles) {
        const Vec3 p = a - origin;
        const Vec3 q = b - origin;
        const Vec3 r = c - origin;
        out.six += p.dot(q.cross(r));
        reach = std::max(
            {reach, p.cwiseAbs().maxCoeff(), q.cwiseAbs().maxCoeff(), r.cwiseAbs().maxCoeff()});
    }
    out.error = tol::kOrientError * static_cast<double>(triangles.size()) * reach * reach * reach;
    return out;
}

/// A shell with what the tests of nesting need.
struct Shell {
    std::vector<Mesh::FaceHandle> faces;
    std::vector<std::array<Vec3, 3>> triangles;
    Eigen::AlignedBox3d box;
};

std::vector<Shell> splitShells(const ExactMesh& surface) {
    std::vector<int> shellOfFace;
    std::vector<Shell> shells(static_cast<std::size_t>(shellsOf(surface.mesh, shellOfFace)));
    for (const auto f : surface.mesh.faces()) {
        Shell& shell =
            shells[static_cast<std::size_t>(shellOfFace[static_cast<std::size_t>(f.idx())])];
        std::array<Vec3, 3> triangle;
        std::size_t k = 0;
        for (const auto v : surface.mesh.fv_range(f)) {
            const auto& p = surface.mesh.point(v);
            triangle[k] = Vec3(p[0], p[1], p[2]);
            shell.box.extend(triangle[k++]);
        }
        shell.faces.push_back(f);
        shell.triangles.push_back(triangle);
    }
    return shells;
}

Rational exactVolume(const ExactMesh& surface, const std::vector<Mesh::FaceHandle>& faces) {
    // On plain rationals: a lazy sum would be a chain as long as the mesh, evaluated recursively.
    Rational sum = 0;
    std::optional<RVec> origin;
    for (const auto f : faces) {
        std::array<RVec, 3> t;
        std::size_t k = 0;
        for (const auto v : surface.mesh.fv_range(f)) {
            t[k] = coordinates(PointView{&surface.point(v), Vec3::Zero()});
            if (!origin) origin = t[k];
            for (std::size_t i = 0; i < 3; ++i) t[k][i] -= (*origin)[i];
            ++k;
        }
        sum += dot(t[0], cross(t[1], t[2]));
    }
    return sum / 6;
}

/// Does a shell enclose a point that is not on it? Counts the triangles above it, seen from a
/// place moved by (e, e^2) in x and y, so that the ray meets no edge.
bool encloses(const ExactMesh& surface, const Shell& shell, const PointView& p) {
    bool inside = false;
    for (std::size_t t = 0; t < shell.faces.size(); ++t) {
        const auto& corner = shell.triangles[t];
        Eigen::AlignedBox3d box;
        for (const Vec3& c : corner) box.extend(c);
        if (box.max().z() < p.r.z() || box.min().x() > p.r.x() || box.max().x() < p.r.x() ||
            box.min().y() > p.r.y() || box.max().y() < p.r.y()) {
            continue;
        }
        std::vector<PointView> loop;
        for (const auto v : surface.mesh.fv_range(shell.faces[t])) {
            const auto& q = surface.mesh.point(v);
            loop.push_back({&surface.point(v), Vec3(q[0], q[1], q[2])});
        }
        bool hit = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const PointView& a = loop[k];
            const PointView& b = loop[(k + 1) % 3];
            const bool up = compare(b, p, 1) > 0;
            if ((compare(a, p, 1) > 0) == up) continue;
            const int turn = orient2(a, b, p, 0, 1);
            if (up ? turn > 0 : turn < 0) hit = !hit;
        }
        if (!hit) continue;
        int sign = 0;
        const auto plane = planeOfLoop(loop, sign);
        if (plane && sideOf(*plane, p) * sgn(plane->normal[2]) < 0) inside = !inside;
    }
    return inside;
}

}  // namespace

Result<void> checkFaces(const ExactMesh& surface, const std::vector<Mesh::FaceHandle>& faces) {
    namespace pmp = CGAL::Polygon_mesh_processing;
    const Mesh& mesh = surface.mesh;
    const ExactPointMap<const Mesh*> points{&mesh, surface.exact};
    const auto options = CGAL::parameters::vertex_point_map(points);
    if (!pmp::does_self_intersect(faces, mesh, options)) return {};
    std::vector<std::pair<Mesh::FaceHandle, Mesh::FaceHandle>> pairs;
    pmp::self_intersections(faces, mesh, std::back_inserter(pairs), options);
    if (pairs.empty()) return fail(Errc::SelfIntersecting, "The solid cuts through itself.");
    const int a = surface.regionOf(pairs[0].first);
    const int b = surface.regionOf(pairs[0].second);
    return fail(Errc::SelfIntersecting, "Faces " + std::to_string(std::min(a, b)) + " and " +
                                            std::to_string(std::max(a, b)) +
                                            " cut through or touch each other.");
}

Result<void> checkShells(const ExactMesh& surface) {
    const std::vector<Shell> shells = splitShells(surface);
    for (const Shell& shell : shells) {
        const Measure volume = measure(shell.triangles);
        int sign = volume.six > 0 ? 1 : -1;
        if (std::abs(volume.six) <= volume.error) sign = sgn(exactVolume(surface, shell.faces));
        if (sign == 0) return fail(Errc::NoVolume, "The solid has no volume.");
        int depth = 0;
        for (const Shell& other : shells) {
            if (&other == &shell || !other.box.contains(shell.box)) continue;
            const auto v = *surface.mesh.cfv_iter(shell.faces[0]);
            const PointView p{&surface.point(v), shell.triangles[0][0]};
            depth += encloses(surface, other, p) ? 1 : 0;
        }
        if ((depth % 2 == 0) == (sign > 0)) continue;
        return fail(Errc::NotOriented, shells.size() > 1 ? "One shell of the solid is inside out."
                                                         : "The faces of the solid point inwards.");
    }
    return {};
}

}  // namespace ew
