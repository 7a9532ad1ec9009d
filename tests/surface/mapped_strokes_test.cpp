// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/mapped_strokes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/surface/subdivision.h"
#include "tests/surface/shapes.h"

namespace ew::test {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

struct Triangles {
    std::vector<Vec3> positions;
    std::vector<std::array<int, 3>> triangles;
};

Triangles of(const Solid& solid) {
    Triangles out{solid.vertices(), {}};
    for (const SolidTriangle& t : solid.triangles()) out.triangles.push_back(t.vertices);
    return out;
}

Triangles roundedBox(double tolerance) {
    const Solid box = solidOf(boxSpec({-40, -30, -20}, {40, 30, 20}));
    const auto cage = fillet(box, allEdges(box, 12.0, 2));
    EXPECT_TRUE(cage);
    const auto control = controlCage(*cage, {});
    EXPECT_TRUE(control);
    SubdivisionOptions options;
    options.tolerance = tolerance;
    auto surface = subdivide(*control, options);
    EXPECT_TRUE(surface);
    return {surface->positions, surface->triangles};
}

StrokeCanvas canvasOf(const Triangles& mesh, const OrthographicCamera& camera = {}) {
    auto canvas = StrokeCanvas::create(mesh.positions, mesh.triangles, camera);
    EXPECT_TRUE(canvas) << canvas.error().message;
    return *canvas;
}

Stroke line(const Vec2& a, const Vec2& b, int samples = 2) {
    Stroke stroke;
    for (int i = 0; i < samples; ++i) {
        const double t = static_cast<double>(i) / (samples - 1);
        stroke.samples.push_back({a + t * (b - a), 0.25 + 0.5 * t, 10.0 * i});
    }
    return stroke;
}

/// Depth of the first triangle under a pixel by brute force, in px; infinity where there is none.
double firstDepth(const Triangles& mesh, const OrthographicCamera& camera, const Vec2& px) {
    const Vec3 o = camera.unproject(px);
    double best = std::numeric_limits<double>::infinity();
    for (const auto& t : mesh.triangles) {
        const Vec3& a = mesh.positions[at(t[0])];
        const Vec3 e1 = mesh.positions[at(t[1])] - a;
        const Vec3 e2 = mesh.positions[at(t[2])] - a;
        const Vec3 p = camera.direction.cross(e2);
        const double det = e1.dot(p);
        if (std::abs(det) < 1e-12) continue;
        const double u = (o - a).dot(p) / det;
        const Vec3 q = (o - a).cross(e1);
        const double v = camera.direction.dot(q) / det;
        if (u < -1e-9 || v < -1e-9 || u + v > 1.0 + 1e-9) continue;
        best = std::min(best, e2.dot(q) / det / camera.worldPerPixel);
    }
    return best;
}

/// Every point is where it says it is, on its triangle, under the pen, and in front of all else;
/// the lines between points lie on the surface.
void check(const Triangles& mesh, const OrthographicCamera& camera, const MappedStrokes& mapped) {
    for (const MappedCurve& curve : mapped.curves) {
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            const MappedPoint& p = curve.points[i];
            const auto& t = mesh.triangles[at(p.triangle)];
            const Vec3 there = p.barycentric[0] * mesh.positions[at(t[0])] +
                               p.barycentric[1] * mesh.positions[at(t[1])] +
                               p.barycentric[2] * mesh.positions[at(t[2])];
            ASSERT_LT((there - p.position).norm(), 1e-9);
            ASSERT_GE(p.barycentric.minCoeff(), 0.0);
            ASSERT_NEAR(p.barycentric.sum(), 1.0, 1e-12);
            ASSERT_LE(p.normal.dot(camera.direction), 0.0);
            const auto visible = [&](const Vec3& q) {
                const double first = firstDepth(mesh, camera, camera.project(q));
                return camera.depthPx(q) < first + 0.3;
            };
            ASSERT_TRUE(visible(p.position));
            if (i == 0) continue;
            const Vec3 middle = 0.5 * (p.position + curve.points[i - 1].position);
            ASSERT_TRUE(visible(middle));
            const double first = firstDepth(mesh, camera, camera.project(middle));
            if (std::isfinite(first)) {
                ASSERT_NEAR(camera.depthPx(middle), first, 0.3);
            }
        }
    }
}

TEST(MappedStrokes, ALineOverABoxBendsAtItsEdge) {
    const Triangles mesh = of(solidOf(boxSpec({-20, -20, -20}, {20, 20, 20})));
    const OrthographicCamera camera;
    const Vec2 onTop = camera.project({0, 0, 20});
    const Vec2 onSide = camera.project({20, 0, 0});
    const auto mapped = canvasOf(mesh, camera).map({line(onTop, onSide)});
    ASSERT_TRUE(mapped);
    ASSERT_EQ(mapped->curves.size(), 1U);
    check(mesh, camera, *mapped);
    const auto& points = mapped->curves[0].points;
    EXPECT_LT((points.front().position - Vec3(0, 0, 20)).norm(), 1e-9);
    EXPECT_LT((points.back().position - Vec3(20, 0, 0)).norm(), 1e-9);
    EXPECT_NEAR(points.front().pressure, 0.25, 1e-12);
    EXPECT_NEAR(points.back().pressure, 0.75, 1e-12);
    // It crosses the edge in the very edge.
    double nearest = 1.0;
    double length = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        nearest =
            std::min(nearest, std::hypot(points[i].position.x() - 20, points[i].position.z() - 20));
        if (i > 0) length += (points[i].position - points[i - 1].position).norm();
    }
    EXPECT_LT(nearest, 1e-9);
    // The picture's straight line crosses the edge in (20, -10, 20).
    EXPECT_NEAR(length, 2.0 * std::sqrt(500.0), 1e-6);
    EXPECT_LT(points.size(), 8U);  // no more than triangles demand
}

TEST(MappedStrokes, SplitsWhereABossStandsInFront) {
    // A box on a slab; the line on the slab passes behind the box.
    std::vector<bool> filled(18, false);
    for (std::size_t i = 0; i < 9; ++i) filled[i] = true;
    filled[13] = true;
    const std::vector<double> steps{-30, -10, 10, 30};
    const Triangles mesh =
        of(solidOf(cellsSpec({steps, steps, std::vector<double>{0, 5, 18}}, filled)));
    const OrthographicCamera camera;
    const auto straight =
        canvasOf(mesh, camera)
            .map({line(camera.project({-25, 20, 5}), camera.project({25, 20, 5}))});
    ASSERT_TRUE(straight);
    check(mesh, camera, *straight);
    // On the slab, then over the boss that hides it, then on the slab again.
    ASSERT_EQ(straight->curves.size(), 3U);
    EXPECT_NEAR(straight->curves[0].points.back().position.z(), 5.0, 1e-9);
    EXPECT_GT(straight->curves[1].points.front().position.z(), 5.0 + 1.0);
    EXPECT_NEAR(straight->curves[2].points.front().position.z(), 5.0, 1e-9);
}

TEST(MappedStrokes, EndsAtTheSilhouette) {
    const Triangles mesh = roundedBox(0.05);
    const OrthographicCamera camera;
    const auto mapped = canvasOf(mesh, camera).map({line({0, 400}, {1280, 400}, 200)});
    ASSERT_TRUE(mapped);
    check(mesh, camera, *mapped);
    ASSERT_EQ(mapped->curves.size(), 1U);
    const auto& points = mapped->curves[0].points;
    for (const MappedPoint* end : {&points.front(), &points.back()}) {
        const Vec2 px = camera.project(end->position);
        const double outwards = end == &points.front() ? -0.05 : 0.05;
        EXPECT_TRUE(std::isinf(firstDepth(mesh, camera, px + Vec2(outwards, 0))));
    }
}

TEST(MappedStrokes, ADotIsOnePoint) {
    const Triangles mesh = of(solidOf(boxSpec({-20, -20, -20}, {20, 20, 20})));
    Stroke dot;
    dot.samples.push_back({{640, 400}, 0.5, 0.0});
    const auto mapped = canvasOf(mesh).map({dot});
    ASSERT_TRUE(mapped);
    ASSERT_EQ(mapped->curves.size(), 1U);
    EXPECT_EQ(mapped->curves[0].points.size(), 1U);
}

TEST(MappedStrokes, ThroughCornersOfTheTriangulation) {
    // A line through mesh points and along mesh edges is one curve.
    const Triangles mesh = of(solidOf(bossesSpec(1)));
    OrthographicCamera camera;
    camera.direction = Vec3(0, 0, -1);
    camera.up = Vec3(0, 1, 0);
    camera.center = Vec3(1.5, 1.5, 0);
    camera.worldPerPixel = 0.01;
    const auto mapped = canvasOf(mesh, camera)
                            .map({line(camera.project({0.5, 0, 1}), camera.project({0.5, 3, 1})),
                                  line(camera.project({0, 0, 1}), camera.project({1, 1, 1})),
                                  line(camera.project({1, 1, 1.5}), camera.project({2, 1, 1.5}))});
    ASSERT_TRUE(mapped);
    EXPECT_EQ(mapped->curves.size(), 3U);
    check(mesh, camera, *mapped);
}

const std::array<Vec2, 5> kAround{Vec2(0, 0), Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)};

RC_GTEST_PROP(MappedStrokesProperty, CurvesLieOnWhatIsSeen, ()) {
    const auto number = *rc::gen::inRange<std::uint64_t>(0, 1'000'000);
    Random random(Random::mix(number, 21));
    const Solid solid = randomSolid(number);
    const Triangles mesh = of(solid);
    const auto box = solid.bounds();
    OrthographicCamera camera;
    camera.center = 0.5 * (box[0] + box[1]);
    camera.worldPerPixel = (box[1] - box[0]).norm() / 300.0;
    Vec3 direction(random.normal(), random.normal(), random.normal());
    camera.direction = direction.normalized();
    camera.up = std::abs(camera.direction.z()) > 0.9 ? Vec3(1, 0, 0) : Vec3(0, 0, 1);
    std::vector<Stroke> strokes;
    for (int s = 0; s < 3; ++s) {
        Stroke stroke;
        Vec2 p = Vec2(640, 400) + random.inDisc(150);
        for (int i = 0; i < 10; ++i) {
            stroke.samples.push_back({p, random.uniform(), 8.0 * i});
            p += random.inDisc(40);
        }
        strokes.push_back(stroke);
    }
    const auto mapped = canvasOf(mesh, camera).map(strokes);
    if (!mapped) {
        RC_ASSERT(mapped.error().code == Errc::NoSurface);
        return;
    }
    check(mesh, camera, *mapped);
    RC_ASSERT(!::testing::Test::HasFatalFailure());
    // Nothing that is seen under a sample is left out.
    for (std::size_t s = 0; s < strokes.size(); ++s) {
        for (const PenSample& sample : strokes[s].samples) {
            // A sample that only grazes the rim, by less than can be seen, makes no curve.
            constexpr double kGrazed = 0.05;
            const bool seen = std::all_of(kAround.begin(), kAround.end(), [&](const Vec2& d) {
                return std::isfinite(firstDepth(mesh, camera, sample.position + kGrazed * d));
            });
            if (!seen) continue;
            double nearest = 1e9;
            for (const MappedCurve& curve : mapped->curves) {
                if (curve.stroke != static_cast<int>(s)) continue;
                for (const MappedPoint& p : curve.points) {
                    nearest =
                        std::min(nearest, (camera.project(p.position) - sample.position).norm());
                }
            }
            RC_ASSERT(nearest < 0.1);
        }
    }
}

TEST(MappedStrokes, BadInputIsRefusedWithACode) {
    const Triangles mesh = of(solidOf(boxSpec({-20, -20, -20}, {20, 20, 20})));
    const StrokeCanvas canvas = canvasOf(mesh);
    EXPECT_EQ(canvas.map({}).error().code, Errc::EmptySketch);
    const auto beside = canvas.map({line({1, 1}, {20, 30})});
    ASSERT_FALSE(beside);
    EXPECT_EQ(beside.error().code, Errc::NoSurface);
    EXPECT_EQ(errcName(beside.error().code), "no-surface");
    EXPECT_EQ(beside.error().where.size(), 1U);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(canvas.map({line({nan, 1}, {20, 30})}).error().code, Errc::BadCoordinates);
    const auto both = canvas.map({line({1, 1}, {20, 30}), line({600, 400}, {660, 410})});
    ASSERT_TRUE(both);
    EXPECT_EQ(both->missed, std::vector<int>{0});
    OrthographicCamera camera;
    camera.worldPerPixel = 0.0;
    EXPECT_FALSE(StrokeCanvas::create(mesh.positions, mesh.triangles, camera));
    Triangles bad = mesh;
    bad.triangles[0][1] = 99;
    EXPECT_EQ(StrokeCanvas::create(bad.positions, bad.triangles, {}).error().code, Errc::BadValue);
    bad = mesh;
    bad.positions[0].x() = nan;
    EXPECT_EQ(StrokeCanvas::create(bad.positions, bad.triangles, {}).error().code, Errc::BadValue);
}

}  // namespace
}  // namespace ew::test
