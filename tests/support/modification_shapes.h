// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/base/camera.h"
#include "core/solid/solid.h"

namespace ew::test {

using Lines3 = std::vector<std::array<Vec3, 2>>;  ///< body frame [mm]

/// Throws std::runtime_error where the spec is no solid.
Solid solidOf(const PolyhedronSpec& spec);

/// Between two opposite corners, the first with the smaller coordinates.
PolyhedronSpec boxSpec(const Vec3& a, const Vec3& b);

/// A prism over a polygon that does not bend inwards, moved along a vector.
PolyhedronSpec prismSpec(const std::vector<Vec3>& outline, const Vec3& along);

PolyhedronSpec pyramidSpec(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& apex);

/// A box whose top is drawn in by so much on both sides along x and along y.
PolyhedronSpec frustumSpec(const Vec3& low, const Vec3& high, double drawnInX, double drawnInY);

/// The lines from point to point.
Lines3 polyline(const std::vector<Vec3>& points);
Lines3 joined(Lines3 a, const Lines3& b);

/// What is new in the result and can be seen: visible edges that lie on no edge of the target.
Lines3 newVisibleLines(const Body& target, const Solid& result, const OrthographicCamera& camera);

}  // namespace ew::test
