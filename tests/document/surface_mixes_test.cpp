// SPDX-License-Identifier: GPL-3.0-or-later
// Filleted and smoothed shapes as they are exported, and as another program reads them.
#include "tests/document/surface_mixes.h"

#include <gtest/gtest.h>

#include <QFile>
#include <filesystem>

#include "core/document/document.h"
#include "core/document/export_mesh.h"
#include "core/document/replay.h"
#include "core/document/resources.h"
#include "tests/support/random_modifications.h"

namespace ew::test {
namespace {

std::vector<Body> exampleBodies(const std::string& name) {
    const auto resources = resourcesFolder();
    EXPECT_TRUE(resources);
    QFile file(*resources + QStringLiteral("/examples/") + QString::fromStdString(name) +
               QStringLiteral(".json"));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    const auto script = readSketchScript(file.readAll().toStdString());
    const auto templates = loadTemplates();
    EXPECT_TRUE(script && templates);
    Document document(templates->library);
    EXPECT_EQ(replay(document, *script, {}).firstFailure(), nullptr);
    return document.state().bodies;
}

/// Every `step`-th mix, from `first` on: all are too many for a test (see bench/surface_sweep).
void expectSound(const std::vector<Body>& bodies, std::size_t first, std::size_t step) {
    const std::vector<SurfaceMix> mixes = allMixes();
    ShapeCache cache;
    for (std::size_t m = first; m < mixes.size(); m += step) {
        SCOPED_TRACE(mixes[m].name());
        const auto input = inputFor(bodies, mixes[m]);
        if (!input) continue;
        const ShapeFaults faults = faultsOf(*input, deriveShape(*input, cache));
        EXPECT_EQ(faults.badNormals, 0U);
        EXPECT_EQ(faults.reading.openEdges, 0U);
        EXPECT_EQ(faults.reading.withoutArea, 0U);
        EXPECT_EQ(faults.notManifold, 0U);
        EXPECT_EQ(faults.notMade, 0U);
    }
}

TEST(SurfaceMixes, ExamplesHaveUnitNormalsAndAreasAndAreClosed) {
    std::size_t first = 0;
    for (const char* name : {"cube", "l-prism", "triangular-prism", "triangular-pyramid",
                             "wedge-frustum", "clock", "mouse", "printer"}) {
        SCOPED_TRACE(name);
        expectSound(exampleBodies(name), first++, 23);
    }
}

TEST(SurfaceMixes, ConcaveEdgesAlone) {
    const std::vector<Body> bodies = exampleBodies("l-prism");
    const std::vector<SurfaceMix> mixes = allMixes();
    for (std::size_t m = 0; m < mixes.size(); ++m) {
        if (mixes[m].edges == SurfaceMix::Edges::Concave && mixes[m].levels < 3) {
            expectSound(bodies, m, mixes.size());
        }
    }
}

TEST(SurfaceMixes, RandomSolidsHaveUnitNormalsAndAreasAndAreClosed) {
    for (std::uint64_t n = 0; n < 8; ++n) {
        SCOPED_TRACE(n);
        Random random(Random::mix(n, 5));
        expectSound({{n % 2 == 0 ? randomSolid(n) : randomModifiedSolid(8, random), {}}}, n, 29);
    }
}

TEST(SurfaceMixes, WhatSinglePrecisionTearsIsNotWritten) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::path(testing::TempDir()) / "ew-single-precision";
    fs::create_directories(folder);
    // Two cubes and so far between them that a file with one origin has no digits for small radii.
    std::vector<Body> bodies = exampleBodies("cube");
    bodies.push_back(bodies[0]);
    const auto bounds = bodies[0].solid.bounds();
    const double size = bounds[1].x() - bounds[0].x();
    bodies[1].pose.translation += Vec3(5e3 * size, 0, 0);
    SurfaceMix mix;
    mix.radius = 1e-5;
    const auto input = inputFor(bodies, mix);
    ASSERT_TRUE(input);
    ShapeCache cache;
    const DerivedShape shape = deriveShape(*input, cache);
    EXPECT_TRUE(readsAsClosed(bodies, shape.bodies));
    const std::vector<MappedStroke> none;
    const auto torn = exportShape({bodies, shape, none}, (folder / "cubes.stl").string());
    ASSERT_FALSE(torn);
    EXPECT_EQ(torn.error().code, Errc::NotClosed);
    EXPECT_FALSE(fs::exists(folder / "cubes.stl"));
    // These give each body an origin, or have double precision.
    for (const char* name : {"cubes.glb", "cubes.3mf", "cubes.obj", "cubes.ply"}) {
        EXPECT_TRUE(exportShape({bodies, shape, none}, (folder / name).string())) << name;
    }
    fs::remove_all(folder);
}

}  // namespace
}  // namespace ew::test
