// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/solid.
#pragma once

#include <vector>

#include "core/base/vec.h"
#include "core/solid/polyhedron_spec.h"

namespace ew {

/// A plane for one or more faces of a spec, with coefficients that are few-bit doubles:
/// normal . p = offset. The normal is not of unit length: its largest component is 1.
struct FittedPlane {
    Vec3 normal = Vec3::Zero();
    double offset = 0.0;      ///< [mm]
    int axis = -1;            ///< 0..2 where all points share that coordinate to the bit, else -1
    std::vector<int> points;  ///< all points of its faces, ascending, each once
    std::vector<int> faces;   ///< of the spec
};

/// Planes of all faces. Faces with parallel normals (tol::kParallelSine) share one normal, faces in
/// one plane (tol::kSamePlaneRelative) share the plane; coefficients are rounded to
/// tol::kPlaneGrid.
/// \pre every face has an area.
std::vector<FittedPlane> fitPlanes(const PolyhedronSpec& spec);

}  // namespace ew
