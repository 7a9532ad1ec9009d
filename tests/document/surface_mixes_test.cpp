// SPDX-License-Identifier: GPL-3.0-or-later
// Filleted and smoothed shapes as they are exported, and as another program reads them.
#include "tests/document/surface_mixes.h"

#include <gtest/gtest.h>

#include <QFile>
#include <algorithm>
#include <filesystem>

#include "core/document/document.h"
#include "core/document/export_mesh.h"
#include "core/document/replay.h"
#include "core/document/resources.h"
#include "tests/support/modification_shapes.h"
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

void expectSound(const std::vector<Body>& bodies, const std::string& name) {
    const std::vector<SurfaceMix> mixes = allMixes();
    const auto mix = std::find_if(mixes.begin(), mixes.end(),
                                  [&](const SurfaceMix& m) { return m.name() == name; });
    ASSERT_NE(mix, mixes.end()) << name;
    expectSound(bodies, static_cast<std::size_t>(mix - mixes.begin()), mixes.size());
}

TEST(SurfaceMixes, PointsThatAreAllButOnOneLineHaveAreasBetweenThem) {
    const std::vector<Body> bodies = exampleBodies("clock");
    expectSound(bodies, "picked_r0.5_s5_cc3");
    expectSound(bodies, "all_r0.1_s1_loop3");
}

TEST(SurfaceMixes, APointWithNoAreaRoundItHasANormalAllTheSame) {
    Random random(Random::mix(15, 5));
    expectSound({{randomModifiedSolid(8, random), {}}}, "convex_r2_s1_cc3");
}

TEST(SurfaceMixes, ACornerOfTwoFacesHasTwoTrianglesAnEdge) {
    Random random(Random::mix(7, 5));
    expectSound({{randomModifiedSolid(8, random), {}}}, "picked_r0.1_s1_cc1");
}

TEST(SurfaceMixes, LowTrianglesMakeRoomForOneWithoutAnArea) {
    Random random(Random::mix(2, 5));
    const std::vector<Body> bodies{{randomModifiedSolid(8, random), {}}};
    expectSound(bodies, "picked_r0.1_s5_loop3");
    expectSound(bodies, "convex_r0.1_s5_cc3");
}

TEST(SurfaceMixes, RandomSolidsHaveUnitNormalsAndAreasAndAreClosed) {
    for (std::uint64_t n = 0; n < 8; ++n) {
        SCOPED_TRACE(n);
        Random random(Random::mix(n, 5));
        expectSound({{randomModifiedSolid(2 + static_cast<int>(n), random), {}}}, n, 29);
    }
}

TEST(SurfaceMixes, WhatSinglePrecisionTearsIsNotWritten) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::path(testing::TempDir()) / "ew-single-precision";
    fs::create_directories(folder);
    // A sheet so thin that both its sides have the same coordinates in single precision.
    auto sheet = Solid::fromSpec(boxSpec(Vec3(0, 0, 0), Vec3(10, 10, 1e-6)));
    ASSERT_TRUE(sheet);
    std::vector<Body> bodies{{*sheet, {}}};
    bodies[0].pose.translation = Vec3(0, 0, 100);
    EXPECT_FALSE(readsAsClosed(bodies, std::vector<BodyShape>(1)));
    for (const char* name : {"sheet.stl", "sheet.glb", "sheet.3mf"}) {
        const auto torn = exportBodies(bodies, (folder / name).string());
        ASSERT_FALSE(torn) << name;
        EXPECT_EQ(torn.error().code, Errc::NotClosed) << name;
        EXPECT_FALSE(fs::exists(folder / name)) << name;
    }
    // These have double precision.
    EXPECT_TRUE(exportBodies(bodies, (folder / "sheet.obj").string()));
    EXPECT_TRUE(exportBodies(bodies, (folder / "sheet.ply").string()));
    fs::remove_all(folder);
}

}  // namespace
}  // namespace ew::test
