// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/solid/solid.h"
#include "core/surface/fillet.h"
#include "tests/support/random.h"

namespace ew::test {

/// The solid of a spec; stops the program where it is none.
Solid solidOf(const PolyhedronSpec& spec);

PolyhedronSpec boxSpec(const Vec3& low, const Vec3& high);
PolyhedronSpec prismSpec(int sides, double bottomRadius, double topRadius, double height);
PolyhedronSpec pyramidSpec(int sides, double height);
PolyhedronSpec bipyramidSpec(int sides, double height);
/// The L of 2 x 2 without a corner of 1 x 1, extruded by 1 along y.
PolyhedronSpec lPrismSpec();

/// The union of the filled cells of a grid, as quadrangles; cells count along x, then y, then z.
/// \param lines  coordinates of the grid planes along each axis.
PolyhedronSpec cellsSpec(const std::array<std::vector<double>, 3>& lines,
                         const std::vector<bool>& filled);

/// A block of n x n x 1 bosses on a slab, as in the benchmark.
PolyhedronSpec bossesSpec(int n);

/// Random solids: unions of cells (bosses, pockets, holes, notches and tunnels of every kind of
/// corner), prisms, frusta, pyramids and bipyramids, moved by a random projective map that keeps
/// planes plane. The same number gives the same solid.
Solid randomSolid(std::uint64_t number);

/// All edges with one setback.
FilletOptions allEdges(const Solid& solid, double setback, int segments);
/// The edges that are convex, or those that are not.
FilletOptions edgesOfKind(const Solid& solid, bool convex, double setback, int segments);

/// Volume by the divergence theorem over the polygons' own triangles.
double volumeOf(const FilletedCage& cage);

/// What CGAL's exact arithmetic says of the triangulated cage: empty if it is closed, manifold,
/// oriented and free of self-intersection, else what is wrong.
std::string faultsByExactArithmetic(const std::vector<Vec3>& points,
                                    const std::vector<std::array<int, 3>>& triangles);
std::string faultsByExactArithmetic(const FilletedCage& cage);

}  // namespace ew::test
