// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/solid/polyhedron_spec.h"

namespace ew::test {

/// A box from `low` to `high`.
PolyhedronSpec box(const Vec3& low, const Vec3& high);

/// A right prism of `sides` sides and height 1 on the circle of radius 1 in z = 0.
PolyhedronSpec prism(int sides);

/// A pyramid of `sides` sides with its apex at height 1.
PolyhedronSpec pyramid(int sides);

/// A pyramid cut off at half its height; the upper ring has `topRadius`.
PolyhedronSpec frustum(int sides, double topRadius);

/// Two pyramids on one base; 4 sides make an octahedron.
PolyhedronSpec bipyramid(int sides);

/// Rings of `sides` points at z = 0 and 1, turned against each other, with triangles between.
PolyhedronSpec antiprism(int sides);

/// The L of 2 x 2 without a corner of 1 x 1, extruded by 1.
PolyhedronSpec lPrism();

/// A square block of 4 x 4 x 1 with a square hole of 2 x 2 through it, every face in quadrangles.
PolyhedronSpec squareRing();

/// A ring of `segments` bevelled pieces with a cross-section of `corners` corners: all faces are
/// trapezoids, four at every point, no two in one plane.
PolyhedronSpec torus(int segments, int corners);

/// Both in one spec; the second one's faces come after the first one's.
PolyhedronSpec together(const PolyhedronSpec& a, const PolyhedronSpec& b);

/// All faces turned round.
PolyhedronSpec insideOut(PolyhedronSpec spec);

/// Rotated about an oblique axis, scaled and shifted.
PolyhedronSpec moved(PolyhedronSpec spec, double angleRad, double scale, const Vec3& shift);

/// Volume in doubles, by the divergence theorem.
double plainVolume(const PolyhedronSpec& spec);

}  // namespace ew::test
