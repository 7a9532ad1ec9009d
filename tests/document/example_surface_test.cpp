// SPDX-License-Identifier: GPL-3.0-or-later
// What surfaces are held to on the examples that have one.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <algorithm>

#include "core/document/document.h"
#include "core/document/replay.h"
#include "core/document/resources.h"
#include "tests/surface/deviation.h"

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
    bool creased = false;
};

void make(Document& d, int levels, double tolerance) {
    SubdivisionSettings s = d.state().surface.subdivision;
    s.on = true;
    s.levels = levels;
    s.tolerance = tolerance;
    EXPECT_TRUE(d.subdivide(s));
}

Count countWith(Document& d, int levels, double tolerance) {
    make(d, levels, tolerance);
    Count sum;
    for (const BodyShape& body : d.shape()->bodies) {
        sum.positions += body.surface->positions.size();
        sum.triangles += body.surface->triangles.size();
        sum.creased |= !body.surface->normalTriangles.empty();
    }
    return sum;
}

/// How far the surface under way is from points of the limit surface, by body.
double deviationOf(const Document& d, const std::vector<std::vector<Vec3>>& limit, double reach) {
    double most = 0.0;
    for (std::size_t b = 0; b < limit.size(); ++b) {
        most = std::max(most, test::deviation(limit[b], *d.shape()->bodies[b].surface, reach));
    }
    return most;
}

/// Levels of subdivision that make enough points to measure by: 81 places of every quadrangle of
/// the cage, 289 where these are not too many.
int levelsToMeasureBy(Document& d) {
    constexpr std::size_t kMany = 50'000;
    return countWith(d, 1, 0.0).triangles > kMany ? 3 : 4;
}

/// Some 100,000 points of the limit surface of each body, by body; all places have their turn.
std::vector<std::vector<Vec3>> limitPoints(Document& d, int levels) {
    make(d, levels, 0.0);
    std::vector<std::vector<Vec3>> out;
    for (const BodyShape& body : d.shape()->bodies) {
        const std::vector<Vec3>& all = body.surface->positions;
        // A prime, so that it is in step with no pattern.
        const std::size_t step = all.size() < 200'000 ? 1 : 7;
        out.emplace_back();
        for (std::size_t i = 0; i < all.size(); i += step) out.back().push_back(all[i]);
    }
    return out;
}

class SmoothExample : public testing::TestWithParam<const char*> {
  protected:
    static std::unique_ptr<Document> example() {
        const auto resources = resourcesFolder();
        if (!resources) return nullptr;
        return smoothExample(*resources + QStringLiteral("/examples/") +
                             QString::fromUtf8(GetParam()));
    }
};

TEST_P(SmoothExample, AdaptiveNeedsHalfOfTheTrianglesAtEqualDeviation) {
    const auto d = example();
    ASSERT_TRUE(d);
    const int finest = levelsToMeasureBy(*d);
    const auto limit = limitPoints(*d, finest);
    for (int levels = 1; levels < finest; ++levels) {
        const std::size_t even = countWith(*d, levels, 0.0).triangles;
        const double reached = deviationOf(*d, limit, 0.01);
        // The coarsest adaptive surface that is as near, by the same points.
        double tolerance = 1.3 * reached;
        std::size_t adaptive = countWith(*d, levels, tolerance).triangles;
        while (deviationOf(*d, limit, 0.01) > reached && 2 * adaptive <= even) {
            tolerance *= 0.95;
            adaptive = countWith(*d, levels, tolerance).triangles;
        }
        EXPECT_LE(2 * adaptive, even) << levels << ": within " << reached << " mm";
    }
}

// Programs that draw a surface take a normal for a point of its own.
TEST_P(SmoothExample, EveryNormalBelongsToOnePoint) {
    const auto d = example();
    ASSERT_TRUE(d);
    for (const double tolerance : {0.0, 0.05}) {
        make(*d, 2, tolerance);
        for (const BodyShape& body : d->shape()->bodies) {
            const SurfaceMesh& mesh = *body.surface;
            const bool own = mesh.normalTriangles.empty();
            const auto& ids = own ? mesh.triangles : mesh.normalTriangles;
            std::vector<int> pointOf(mesh.normals.size(), -1);
            for (std::size_t t = 0; t < ids.size(); ++t) {
                for (std::size_t k = 0; k < 3; ++k) {
                    int& point = pointOf[static_cast<std::size_t>(ids[t][k])];
                    EXPECT_TRUE(point < 0 || point == mesh.triangles[t][k]);
                    point = mesh.triangles[t][k];
                }
            }
            EXPECT_EQ(std::count(pointOf.begin(), pointOf.end(), -1), 0);
        }
    }
}

TEST_P(SmoothExample, AdaptiveKeepsItsTolerance) {
    const auto d = example();
    ASSERT_TRUE(d);
    const auto limit = limitPoints(*d, levelsToMeasureBy(*d));
    for (const double tolerance : {0.05, 0.02, 0.005}) {
        make(*d, 1, tolerance);
        EXPECT_LE(deviationOf(*d, limit, tolerance), tolerance);
    }
}

INSTANTIATE_TEST_SUITE_P(
    ExampleSurface, SmoothExample, testing::Values("printer.json", "clock.json", "mouse.json"),
    [](const auto& example) {
        return QString::fromUtf8(example.param).section(QLatin1Char('.'), 0, 0).toStdString();
    });

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
