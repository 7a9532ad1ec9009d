// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/document/derived_shape.h"
#include "core/surface/mesh_reading.h"

namespace ew {

/// What a program that reads these triangles in single precision finds wrong with them, as a slicer
/// does.
/// \param points  from the origin of the file. O(n log n).
ReadingFaults readingFaults(std::span<const Vec3> points,
                            std::span<const std::array<int, 3>> triangles);

/// Is the shape closed to such a program? It must have an area, too.
bool readsAsClosed(std::span<const Vec3> points, std::span<const std::array<int, 3>> triangles);

/// The same for all bodies, each from its own origin where it lies far from the world's, as .glb
/// and .3mf have them.
/// \param shapes  one a body.
bool readsAsClosed(const std::vector<Body>& bodies, const std::vector<BodyShape>& shapes);

}  // namespace ew
