// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/solid/solid.h"

namespace ew {

/// Most bytes of a body's name.
inline constexpr std::size_t kMaxBodyName = 200;

/// Errc::BadValue for a name that is too long or has control characters.
Result<void> checkBodyName(const std::string& name);

/// What a body is called: its name, else "Solid 1", "Solid 2" by its place.
/// \pre body < bodies.size()
std::string bodyName(const std::vector<Body>& bodies, std::size_t body);

/// The body with this name. Errc::BadValue.
Result<int> findBody(const std::vector<Body>& bodies, const std::string& name);

/// Those that are not hidden, and where each stands in the list.
std::pair<std::vector<Body>, std::vector<int>> visibleBodies(const std::vector<Body>& bodies);

/// A planar face of one of the bodies.
struct FaceRef {
    int body = -1;
    int face = -1;  ///< index into Solid::faces()
    bool operator==(const FaceRef&) const = default;
};

/// The face nearest to a world point; of equally near ones the first.
/// \param body  only this body's faces where not -1, else only those that are not hidden.
/// Errors: NoSolid, BadValue where there is no such body. O(triangles).
Result<FaceRef> nearestFace(const std::vector<Body>& bodies, const Vec3& world, int body = -1);

/// A world point well inside a face.
Vec3 pointInFace(const Body& body, int face);

/// A motion of a body. Its parts happen in the order in which they stand here.
struct BodyMove {
    Vec3 scale = Vec3::Ones();  ///< along the world's axes, each > 0
    Vec3 axis = Vec3::UnitZ();  ///< world, of any length
    double degrees = 0.0;       ///< counter-clockwise seen against the axis
    struct Mirror {
        Vec3 point = Vec3::Zero();    ///< world [mm]
        Vec3 normal = Vec3::UnitX();  ///< world, of any length
    };
    std::optional<Mirror> mirror;
    Vec3 translate = Vec3::Zero();  ///< world [mm]
    std::optional<Vec3> center;     ///< of scaling and turning [mm]; not set: the middle of the
                                    ///< body's bounding box in the world
    bool copy = false;              ///< the body stays, and another one is moved
};

/// A body after a motion, with an exact solid: turning and moving leave it as it is, scaling and
/// mirroring make another one with the same faces and corners. Name and visibility stay.
/// Errors: BadValue, and those of transformed().
Result<Body> movedBody(const Body& body, const BodyMove& move);

/// Least and greatest corner of the bounding box in the world [mm].
std::array<Vec3, 2> worldBounds(const Body& body);

/// The middle of the bounding box in the world [mm].
Vec3 middleOf(const Body& body);

}  // namespace ew
