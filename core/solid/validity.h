// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/solid. The part of the gate that needs no mesh.
#pragma once

#include <array>
#include <vector>

#include "core/base/result.h"
#include "core/base/vec.h"

namespace ew {

/// The loops of one planar face: [0] outer, counter-clockwise from outside, the others holes.
using FaceLoops = std::vector<std::vector<int>>;

/// Coordinates are finite and within tol::kMaxCoordinateMm, the size is at least tol::kMinSizeMm.
/// Must be asked before any exact number is made: CGAL answers NaN with a signal.
Result<void> checkCoordinates(const std::vector<Vec3>& points);

/// Diagonal of the bounding box [mm].
double sizeOf(const std::vector<Vec3>& points);

/// Faces as index loops: every index exists and every point is used, loops have at least three
/// distinct points, every edge lies between two faces that run along it in opposite directions.
/// Errors: BadValue, NotClosed, NotManifold, NotOriented; the message names the face or edge.
Result<void> checkLoops(std::size_t pointCount, const std::vector<FaceLoops>& faces);

/// Every face is planar within tol::kPlanarRelative of the size. Errors: NotPlanar, and NoVolume
/// for a face without area; the message names the face.
Result<void> checkPlanar(const std::vector<Vec3>& points, const std::vector<FaceLoops>& faces);

/// The triangles round every point form one fan (2-manifold at vertices). Error: NotManifold.
/// \pre the triangles pass checkLoops.
Result<void> checkFans(std::size_t pointCount, const std::vector<std::array<int, 3>>& triangles);

/// Unit normal by Newell's sum over the outer loop, zero where the loop has no area.
Vec3 newellNormal(const std::vector<Vec3>& points, const std::vector<int>& loop);

}  // namespace ew
