// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/solid: brings OpenMesh and CGAL with it.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <gmpxx.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <array>
#include <boost/property_map/property_map.hpp>
#include <memory>
#include <type_traits>
#include <vector>

#include "core/base/vec.h"
#include "core/solid/solid.h"
#include "core/solid/validity.h"

namespace ew {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point3 = Kernel::Point_3;
using Exact = Kernel::FT;                   ///< lazy exact number
using Rational = Kernel::Exact_kernel::FT;  ///< the number behind it

static_assert(std::is_same_v<Rational, mpq_class>, "CGAL is to be built with GMP's C++ interface");

struct MeshTraits : public OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<MeshTraits>;

/// A closed triangle mesh. Vertex i is the solid's vertex i; its OpenMesh point is the rounded
/// exact point. Copies keep the property handles valid.
struct ExactMesh {
    Mesh mesh;
    OpenMesh::VPropHandleT<Point3> exact;  ///< body frame [mm]
    OpenMesh::FPropHandleT<int> region;    ///< the planar face that a triangle belongs to

    ExactMesh() {
        mesh.add_property(exact);
        mesh.add_property(region);
    }
    const Point3& point(Mesh::VertexHandle v) const { return mesh.property(exact, v); }
    int regionOf(Mesh::FaceHandle f) const { return mesh.property(region, f); }
};

/// The exact points as CGAL's vertex_point_map. CGAL's own map for OpenMesh goes through float.
/// Points are handed out by value: an algorithm may add vertices while it holds one.
template <class MeshPointer>
struct ExactPointMap {
    using key_type = Mesh::VertexHandle;
    using value_type = Point3;
    using reference = Point3;
    using category = boost::read_write_property_map_tag;

    MeshPointer mesh = nullptr;
    OpenMesh::VPropHandleT<Point3> exact;

    friend Point3 get(const ExactPointMap& map, key_type v) {
        return map.mesh->property(map.exact, v);
    }
    friend void put(const ExactPointMap& map, key_type v, const Point3& p) {
        map.mesh->property(map.exact, v) = p;
    }
};

using RVec = std::array<Rational, 3>;

/// normal . p = offset; the component of the normal with the largest magnitude (the first of them)
/// is 1, so a plane has one form only.
struct RPlane {
    RVec normal;
    Rational offset;
    int axis = 2;            ///< whose component is 1
    Vec3 n = Vec3::UnitZ();  ///< rounded
    double d = 0.0;          ///< rounded
    bool operator==(const RPlane& o) const { return normal == o.normal && offset == o.offset; }
};

/// By face; null where a face is planar within tolerance only.
using FacePlanes = std::vector<std::shared_ptr<const RPlane>>;

/// A solid's surface as exact points and planar faces: what every way of making a solid (from a
/// spec, from a file, from a boolean) hands to assemble().
struct ExactBrep {
    std::vector<Point3> points;
    std::vector<FaceLoops> faces;
};

inline Rational rational(const Exact& x) { return CGAL::exact(x); }

/// The double next to an exact number (the same one if it is a double). Not CGAL::to_double on the
/// lazy number: that is good to 1e-5 only.
inline double rounded(const Exact& x) { return CGAL::to_double(CGAL::exact(x)); }
inline Vec3 rounded(const Point3& p) {
    const auto& e = CGAL::exact(p);
    return {CGAL::to_double(e.x()), CGAL::to_double(e.y()), CGAL::to_double(e.z())};
}
inline Point3 exactPoint(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

struct Solid::Impl {
    ExactMesh surface;
    std::vector<Vec3> vertices;
    std::vector<SolidEdge> edges;
    std::vector<SolidFace> faces;
    std::vector<SolidTriangle> triangles;  ///< face by face
    FacePlanes planes;
    int shells = 0;
    int genus = 0;
    double volume = 0.0;
    double area = 0.0;
    std::array<Vec3, 2> bounds{Vec3::Zero(), Vec3::Zero()};
};

}  // namespace ew
