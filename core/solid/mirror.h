// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/base/result.h"
#include "core/solid/polyhedron_spec.h"
#include "core/solid/solid.h"

namespace ew {

/// A plane on both sides of which the same is done.
struct MirrorPlane {
    Vec3 point = Vec3::Zero();    ///< any point in it [mm]
    Vec3 normal = Vec3::UnitX();  ///< unit

    /// Signed distance [mm], positive on the normal's side.
    double height(const Vec3& p) const { return normal.dot(p - point); }
    Vec3 image(const Vec3& p) const { return p - 2.0 * height(p) * normal; }
    Mat3 reflection() const { return Mat3::Identity() - 2.0 * normal * normal.transpose(); }
    bool operator==(const MirrorPlane& o) const { return point == o.point && normal == o.normal; }
};

/// The plane with a unit normal, of which axis directions are exact.
/// Errors: BadValue (numbers that are not finite or over 1e12 mm, a normal without direction).
Result<MirrorPlane> mirrorPlane(const Vec3& point, const Vec3& normal);

/// The same plane in the frame of a body in this pose.
MirrorPlane inBody(const MirrorPlane& plane, const Pose& pose);

/// The mirror image, the right side out; vertices and faces keep their order.
PolyhedronSpec mirrored(const PolyhedronSpec& spec, const MirrorPlane& plane);

/// A body of which a face was drawn to lie in the plane, but does not quite: with that face in it.
/// The face's corners move along their edges to the other faces, so those stay where they are.
/// \param reach  how far off the face's corners may be [mm].
/// \return nothing where no face lies so, or its corners have no one edge each that leads away.
std::optional<PolyhedronSpec> metPlane(const PolyhedronSpec& spec, const MirrorPlane& plane,
                                       double reach);

}  // namespace ew
