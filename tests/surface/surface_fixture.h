// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/surface/subdivision.h"
#include "tests/surface/shapes.h"

namespace ew::test {

/// The control cage, which must be closed.
ControlCage controlOf(const FilletedCage& cage, const ControlOptions& options = {});

ControlCage smoothCage(const Solid& solid, SubdivisionScheme scheme);

ControlCage filletedCage(const Solid& solid, double setback, SubdivisionScheme scheme);

SurfaceMesh surfaceOf(const ControlCage& cage, const SubdivisionOptions& options);

PolyMesh asMesh(const SurfaceMesh& surface);

}  // namespace ew::test
