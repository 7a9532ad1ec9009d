// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/transform.h"

#include <algorithm>
#include <array>
#include <string>

#include "core/solid/assemble.h"
#include "core/solid/exact_geometry.h"

namespace ew {
namespace {

std::array<RVec, 3> rowsOf(const Mat3& m) {
    std::array<RVec, 3> rows;
    for (int r = 0; r < 3; ++r) rows[static_cast<std::size_t>(r)] = coordinates(Vec3(m.row(r)));
    return rows;
}

Result<Solid> moved(const Solid::Impl& impl, const Mat3& linear, const Vec3& shift) {
    if (!linear.allFinite() || !shift.allFinite()) {
        return fail(Errc::BadValue, "A solid can be moved by numbers only.");
    }
    const std::array<RVec, 3> rows = rowsOf(linear);
    const RVec offset = coordinates(shift);
    const Rational det = dot(rows[0], cross(rows[1], rows[2]));
    if (det == 0) {
        return fail(Errc::BadValue, "A solid cannot be scaled to nothing.");
    }
    ExactBrep brep;
    for (std::size_t v = 0; v < impl.vertices.size(); ++v) {
        const Point3& p = impl.surface.point(Mesh::VertexHandle(static_cast<int>(v)));
        const RVec q = coordinates(PointView{&p, impl.vertices[v]});
        brep.points.emplace_back(Exact(dot(rows[0], q) + offset[0]),
                                 Exact(dot(rows[1], q) + offset[1]),
                                 Exact(dot(rows[2], q) + offset[2]));
    }
    for (const SolidFace& f : impl.faces) {
        brep.faces.push_back(f.loops);
        if (det > 0) continue;
        for (std::vector<int>& loop : brep.faces.back()) std::reverse(loop.begin(), loop.end());
    }
    auto made = assemble(std::move(brep));
    if (!made) return fail(made.error());
    return Solid(std::move(*made));
}

}  // namespace

Result<Solid> transformed(const Solid& solid, const Mat3& linear, const Vec3& shift) {
    try {
        return moved(solid.impl(), linear, shift);
    } catch (const std::exception& e) {
        return fail(Errc::Internal, std::string("The solid could not be moved: ") + e.what());
    }
}

}  // namespace ew
