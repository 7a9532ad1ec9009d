// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/solid.h"

#include "core/solid/assemble.h"
#include "core/solid/mesh_kernel.h"
#include "core/solid/realize.h"
#include "core/solid/validity.h"

namespace ew {
namespace {

Result<std::shared_ptr<const Solid::Impl>> fromFaces(const PolyhedronSpec& spec) {
    std::vector<FaceLoops> faces;
    for (const auto& face : spec.faces) faces.push_back({face});
    if (auto ok = checkCoordinates(spec.vertices); !ok) return fail(ok.error());
    if (auto ok = checkLoops(spec.vertices.size(), faces); !ok) return fail(ok.error());
    auto brep = realize(spec);
    if (!brep) return fail(brep.error());
    return assemble(std::move(*brep));
}

}  // namespace

Result<Solid> Solid::fromSpec(const PolyhedronSpec& spec) {
    try {
        auto impl = fromFaces(spec);
        if (!impl) return fail(impl.error());
        return Solid(std::move(*impl));
    } catch (const std::exception& e) {
        return fail(Errc::Internal, std::string("The solid could not be built: ") + e.what());
    }
}

const std::vector<Vec3>& Solid::vertices() const { return impl_->vertices; }
const std::vector<SolidEdge>& Solid::edges() const { return impl_->edges; }
const std::vector<SolidFace>& Solid::faces() const { return impl_->faces; }
const std::vector<SolidTriangle>& Solid::triangles() const { return impl_->triangles; }
int Solid::shellCount() const { return impl_->shells; }
int Solid::genus() const { return impl_->genus; }
double Solid::volume() const { return impl_->volume; }
double Solid::area() const { return impl_->area; }
std::array<Vec3, 2> Solid::bounds() const { return impl_->bounds; }

bool Solid::identicalTo(const Solid& other) const {
    if (impl_ == other.impl_) return true;
    const Impl& a = *impl_;
    const Impl& b = *other.impl_;
    if (a.vertices != b.vertices || a.faces.size() != b.faces.size() ||
        a.triangles.size() != b.triangles.size()) {
        return false;
    }
    for (std::size_t f = 0; f < a.faces.size(); ++f) {
        if (a.faces[f].loops != b.faces[f].loops) return false;
    }
    for (std::size_t t = 0; t < a.triangles.size(); ++t) {
        if (a.triangles[t].vertices != b.triangles[t].vertices ||
            a.triangles[t].face != b.triangles[t].face) {
            return false;
        }
    }
    for (const auto v : a.surface.mesh.vertices()) {
        if (a.surface.point(v) != b.surface.point(v)) return false;
    }
    return true;
}

}  // namespace ew
