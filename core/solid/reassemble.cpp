// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/reassemble.h"

#include <algorithm>

#include "core/solid/crossing_check.h"
#include "core/solid/surface_build.h"
#include "core/solid/triangulate.h"
#include "core/solid/validity.h"
#include "core/solid/volume_check.h"

namespace ew {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

Result<Triangulated> triangulateChanged(const Solid::Impl& base, const ChangedBrep& changed) {
    std::vector<std::size_t> first(base.faces.size() + 1, base.triangles.size());
    for (std::size_t t = base.triangles.size(); t-- > 0;) first[idx(base.triangles[t].face)] = t;
    Triangulated out;
    out.triangles.reserve(base.triangles.size());
    for (std::size_t f = 0; f < changed.brep.faces.size(); ++f) {
        const int same = changed.sameAs[f];
        if (same >= 0) {
            for (std::size_t t = first[idx(same)]; t < first[idx(same) + 1]; ++t) {
                auto triangle = base.triangles[t].vertices;
                for (int& v : triangle) v = changed.vertexOf[idx(v)];
                out.triangles.push_back(triangle);
            }
        } else {
            auto triangles = triangulateFace(changed.brep.points, changed.brep.faces[f], f);
            if (!triangles) return fail(triangles.error());
            out.triangles.insert(out.triangles.end(), triangles->begin(), triangles->end());
        }
        out.regions.resize(out.triangles.size(), static_cast<int>(f));
    }
    return out;
}

/// Triangles that could meet something new.
std::vector<Mesh::FaceHandle> suspects(const ExactMesh& surface, const ChangedBrep& changed) {
    std::vector<Mesh::FaceHandle> out;
    for (const auto f : surface.mesh.faces()) {
        const auto face = idx(surface.regionOf(f));
        // Facets of a changed face may have moved within tolerance, wherever they are.
        bool suspect = changed.sameAs[face] < 0 && !changed.planes[face];
        if (!suspect) {
            Box3 box;
            for (const auto v : surface.mesh.fv_range(f)) {
                const auto& p = surface.mesh.point(v);
                box.extend(Vec3(p[0], p[1], p[2]));
            }
            suspect = box.intersects(changed.changed);
        }
        if (suspect) out.push_back(f);
    }
    return out;
}

Result<void> checkChanged(const ExactMesh& surface, const ChangedBrep& changed) {
    const bool flat = std::none_of(changed.planes.begin(), changed.planes.end(),
                                   [](const auto& plane) { return plane == nullptr; });
    if (flat) return checkCrossings(changed.brep, changed.planes, &changed.changed);
    return checkFaces(surface, suspects(surface, changed));
}

}  // namespace

Result<std::shared_ptr<const Solid::Impl>> reassemble(const Solid::Impl& base,
                                                      const ChangedBrep& changed) {
    auto triangles = triangulateChanged(base, changed);
    if (!triangles) return fail(triangles.error());
    ExactMesh surface;
    if (auto ok = fillMesh(changed.brep.points, *triangles, surface); !ok) return fail(ok.error());
    if (auto ok = checkChanged(surface, changed); !ok) return fail(ok.error());
    if (auto ok = checkShells(surface); !ok) return fail(ok.error());
    return finishSolid(std::move(surface), changed.brep, triangles->regions, changed.planes);
}

}  // namespace ew
