// SPDX-License-Identifier: GPL-3.0-or-later
// What surfaces are held to on the examples that have one.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>

#include "core/document/document.h"
#include "core/document/replay.h"
#include "core/document/resources.h"

namespace ew {
namespace {

/// The example replayed; nullptr where it has no surface.
std::unique_ptr<Document> smoothExample(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll();
    if (!text.contains("subdivide")) return nullptr;
    const auto script = readSketchScript(text.toStdString());
    const auto templates = loadTemplates();
    EXPECT_TRUE(script && templates);
    if (!script || !templates) return nullptr;
    auto d = std::make_unique<Document>(templates->library);
    EXPECT_EQ(replay(*d, *script, {}).firstFailure(), nullptr) << path.toStdString();
    return d;
}

struct Count {
    std::size_t positions = 0;
    std::size_t triangles = 0;
    double deviation = 0.0;
    bool creased = false;
};

Count countWith(Document& d, int levels, double tolerance) {
    SubdivisionSettings s = d.state().surface.subdivision;
    s.on = true;
    s.levels = levels;
    s.tolerance = tolerance;
    EXPECT_TRUE(d.subdivide(s));
    Count sum;
    for (const BodyShape& body : d.shape()->bodies) {
        sum.positions += body.surface->positions.size();
        sum.triangles += body.surface->triangles.size();
        sum.deviation = std::max(sum.deviation, estimatedDeviation(*body.surface));
        sum.creased |= !body.surface->normalTriangles.empty();
    }
    return sum;
}

// On the mouse; the printer and the clock do not reach it yet.
TEST(ExampleSurface, AdaptiveNeedsHalfOfTheTrianglesOfASmoothShape) {
    const auto resources = resourcesFolder();
    ASSERT_TRUE(resources);
    const auto d = smoothExample(*resources + QStringLiteral("/examples/mouse.json"));
    ASSERT_TRUE(d);
    for (const int levels : {2, 3}) {
        const Count even = countWith(*d, levels, 0.0);
        // Deviations are estimates: compared is what is equally near by the same estimate.
        double tolerance = even.deviation;
        Count adaptive = countWith(*d, levels, tolerance);
        for (int i = 0; i < 10 && adaptive.deviation > even.deviation; ++i) {
            tolerance *= 0.9;
            adaptive = countWith(*d, levels, tolerance);
        }
        EXPECT_LE(adaptive.deviation, even.deviation) << levels;
        EXPECT_LE(2 * adaptive.triangles, even.triangles) << levels;
    }
}

TEST(ExampleSurface, LevelSixFitsOrIsRefused) {
    const auto resources = resourcesFolder();
    ASSERT_TRUE(resources);
    const QDir folder(*resources + QStringLiteral("/examples"));
    int examples = 0;
    for (const QString& name : folder.entryList({QStringLiteral("*.json")})) {
        const auto d = smoothExample(folder.filePath(name));
        if (!d) continue;
        ++examples;
        // Three levels more are 64 times as much.
        const Count third = countWith(*d, 3, 0.0);
        const std::size_t bytes =
            surfaceBytes(64 * third.positions, 64 * third.triangles, third.creased);
        if (name == QStringLiteral("printer.json")) {
            EXPECT_LT(bytes, std::size_t{1} << 30U);
        }
        d->setSurfaceMemoryLimit(bytes / 2);
        SubdivisionSettings finest = d->state().surface.subdivision;
        finest.levels = kMaxSubdivisionLevels;
        const auto refused = d->subdivide(finest);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, Errc::TooMuchMemory);
        EXPECT_NE(refused.error().message.find("MiB"), std::string::npos);
        EXPECT_EQ(d->state().surface.subdivision.levels, 3) << "nothing changed";
    }
    EXPECT_EQ(examples, 3);
}

}  // namespace
}  // namespace ew
