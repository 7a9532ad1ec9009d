// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/assemble.h"

#include <algorithm>
#include <unordered_map>

#include "core/solid/brep.h"
#include "core/solid/crossing_check.h"
#include "core/solid/surface_build.h"
#include "core/solid/triangulate.h"
#include "core/solid/validity.h"
#include "core/solid/volume_check.h"

namespace ew {
namespace {

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

/// Mesh and gate for one brep.
Result<void> build(const ExactBrep& brep, ExactMesh& surface, FacePlanes& planes) {
    if (auto ok = checkLoops(brep.points.size(), brep.faces); !ok) return ok;
    std::vector<Vec3> points;
    points.reserve(brep.points.size());
    for (const Point3& p : brep.points) points.push_back(rounded(p));
    if (auto ok = checkCoordinates(points); !ok) return ok;
    if (auto ok = checkPlanar(points, brep.faces); !ok) return ok;
    auto triangles = triangulateAll(brep);
    if (!triangles) return fail(triangles.error());
    if (auto ok = checkTriangles(points.size(), *triangles); !ok) return ok;
    if (auto ok = fillMesh(brep.points, *triangles, surface); !ok) return ok;
    planes.clear();
    for (const FaceLoops& loops : brep.faces) planes.push_back(exactPlane(brep.points, loops));
    const bool flat = std::none_of(planes.begin(), planes.end(),
                                   [](const auto& plane) { return plane == nullptr; });
    if (flat) {
        if (auto ok = checkCrossings(brep, planes, nullptr); !ok) return ok;
    } else {
        std::vector<Mesh::FaceHandle> all;
        for (const auto f : surface.mesh.faces()) all.push_back(f);
        if (auto ok = checkFaces(surface, all); !ok) return ok;
    }
    return checkShells(surface);
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
        FacePlanes planes;
        if (auto ok = build(brep, surface, planes); !ok) return fail(ok.error());
        PersonView view = personView(surface, brep.faces.size());
        if (!view.changed && view.brep.faces == brep.faces) {
            return finishSolid(std::move(surface), view.brep, view.faceOfTriangle,
                               std::move(planes));
        }
        brep = std::move(view.brep);
    }
    return fail(Errc::Internal, "The faces of the solid could not be brought into one form.");
}

}  // namespace ew
