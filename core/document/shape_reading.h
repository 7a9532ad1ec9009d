// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/derived_shape.h"
#include "core/surface/mesh_reading.h"

namespace ew {

/// What a program that reads the triangles of a shape in single precision finds wrong with them, as
/// a slicer does. O(n log n).
ReadingFaults readingFaults(const ShapeMesh& mesh);

/// Is the shape closed to such a program? It must have an area, too.
bool readsAsClosed(const ShapeMesh& mesh);

/// The same for all bodies. \param shapes  one a body.
bool readsAsClosed(const std::vector<Body>& bodies, const std::vector<BodyShape>& shapes);

}  // namespace ew
