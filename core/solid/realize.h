// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/solid.
#pragma once

#include "core/base/result.h"
#include "core/solid/mesh_kernel.h"

namespace ew {

/// Moves the points of a polyhedron (at most tol::kPlanarRelative of its size) so that its faces
/// are planar in exact arithmetic.
///
/// Points whose faces are exactly planar already stay as they are, to the bit. Else every plane is
/// fitted and rounded (an axis plane exactly, parallel faces with one normal, coplanar faces with
/// one plane), and points and planes are fixed one after the other in an order in which each new
/// one is bound by at most three earlier ones: a point by planes that it lies on, a plane by points
/// that it goes through. Such an order exists for every polyhedron of genus 0, because the plane
/// graph of incidences and all its subgraphs have an element of degree three or less. Where it
/// leads to an ill-conditioned intersection or does not exist, the points stay and the faces become
/// exact facets of one region each, planar within tolerance.
///
/// \pre loops checked (checkLoops), coordinates checked (checkCoordinates).
/// Errors: NotPlanar, NoVolume for a face without area.
Result<ExactBrep> realize(const PolyhedronSpec& spec);

}  // namespace ew
