// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/surface/surface_fixture.h"

#include <gtest/gtest.h>

namespace ew::test {

ControlCage controlOf(const FilletedCage& cage, const ControlOptions& options) {
    auto control = controlCage(cage, options);
    EXPECT_TRUE(control) << control.error().message;
    EXPECT_TRUE(checkClosed(control->mesh));
    return *control;
}

ControlCage smoothCage(const Solid& solid, SubdivisionScheme scheme) {
    ControlOptions options;
    options.scheme = scheme;
    options.edgeSharpness.assign(solid.edges().size(), 0.0);
    return controlOf(sharpCage(solid), options);
}

ControlCage filletedCage(const Solid& solid, double setback, SubdivisionScheme scheme) {
    auto cage = fillet(solid, allEdges(solid, setback, 2));
    EXPECT_TRUE(cage);
    ControlOptions options;
    options.scheme = scheme;
    return controlOf(*cage, options);
}

SurfaceMesh surfaceOf(const ControlCage& cage, const SubdivisionOptions& options) {
    auto surface = subdivide(cage, options);
    EXPECT_TRUE(surface) << surface.error().message;
    EXPECT_EQ(surface->origin.size(), surface->triangles.size());
    return *surface;
}

PolyMesh asMesh(const SurfaceMesh& surface) {
    PolyMesh mesh;
    mesh.points = surface.positions;
    for (const auto& t : surface.triangles) mesh.addFace({t[0], t[1], t[2]});
    return mesh;
}

}  // namespace ew::test
