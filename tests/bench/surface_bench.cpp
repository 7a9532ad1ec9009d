// SPDX-License-Identifier: GPL-3.0-or-later
// Times of fillet, subdivision and strokes on slabs with n x n bosses.
#include <benchmark/benchmark.h>

#include "core/surface/mapped_strokes.h"
#include "core/surface/subdivision.h"
#include "tests/surface/shapes.h"

namespace {

using namespace ew;
using namespace ew::test;

/// All edges, as the whole operation: clamping, building and the final check.
void fillet(benchmark::State& state) {
    const Solid solid = solidOf(bossesSpec(static_cast<int>(state.range(0))));
    const FilletOptions options = allEdges(solid, 0.1, static_cast<int>(state.range(1)));
    int faces = 0;
    for (auto _ : state) {
        const auto cage = ew::fillet(solid, options);
        if (!cage || !cage->clamped.empty()) state.SkipWithError("the fillet does not fit");
        faces = cage->mesh.faceCount();
    }
    state.counters["edges"] = static_cast<double>(solid.edges().size());
    state.counters["faces"] = faces;
}
BENCHMARK(fillet)
    ->ArgsProduct({{1, 8, 24}, {1, 2}})
    ->ArgNames({"bosses", "segments"})
    ->Unit(benchmark::kMillisecond);

/// Every radius far too big, so that every edge is clamped.
void filletClamped(benchmark::State& state) {
    const Solid solid = solidOf(bossesSpec(static_cast<int>(state.range(0))));
    const FilletOptions options = allEdges(solid, 1e3, 2);
    for (auto _ : state) benchmark::DoNotOptimize(ew::fillet(solid, options));
}
BENCHMARK(filletClamped)->Arg(8)->Arg(24)->Unit(benchmark::kMillisecond);

ControlCage controlOf(const Solid& solid, bool filleted) {
    ControlOptions options;
    if (!filleted) options.edgeSharpness.assign(solid.edges().size(), 0.0);
    const auto cage = filleted ? *ew::fillet(solid, allEdges(solid, 0.1, 2)) : sharpCage(solid);
    return *controlCage(cage, options);
}

void runSubdivision(benchmark::State& state, const ControlCage& cage,
                    const SubdivisionOptions& options) {
    std::size_t triangles = 0;
    for (auto _ : state) {
        const auto surface = subdivide(cage, options);
        if (!surface) {
            state.SkipWithError(surface.error().message.c_str());
            return;
        }
        triangles = surface->triangles.size();
    }
    state.counters["cage_faces"] = cage.mesh.faceCount();
    state.counters["triangles"] = static_cast<double>(triangles);
    state.counters["triangles_per_second"] = benchmark::Counter(
        static_cast<double>(triangles), benchmark::Counter::kIsIterationInvariantRate);
}

/// The solid's own faces as the cage, as the peer has it.
void uniform(benchmark::State& state) {
    const ControlCage cage =
        controlOf(solidOf(bossesSpec(static_cast<int>(state.range(0)))), state.range(2) != 0);
    SubdivisionOptions options;
    options.levels = static_cast<int>(state.range(1));
    options.memoryLimit = std::size_t{8} << 30U;
    runSubdivision(state, cage, options);
}
BENCHMARK(uniform)
    ->ArgsProduct({{8}, {3, 5}, {0}})
    ->Args({8, 3, 1})
    ->ArgNames({"bosses", "level", "filleted"})
    ->Unit(benchmark::kMillisecond);

void adaptive(benchmark::State& state) {
    const ControlCage cage = controlOf(solidOf(bossesSpec(static_cast<int>(state.range(0)))), true);
    SubdivisionOptions options;
    options.tolerance = 1e-6 * static_cast<double>(state.range(1));
    options.memoryLimit = std::size_t{8} << 30U;
    runSubdivision(state, cage, options);
}
BENCHMARK(adaptive)
    ->Args({1, 100})
    ->Args({1, 10})
    ->Args({8, 1000})
    ->Args({8, 100})
    ->ArgNames({"bosses", "tolerance_nm"})
    ->Unit(benchmark::kMillisecond);

void strokes(benchmark::State& state) {
    const ControlCage cage = controlOf(solidOf(bossesSpec(8)), true);
    const auto surface = subdivide(cage, {});
    OrthographicCamera camera;
    camera.center = Vec3(8.5, 8.5, 0.5);
    camera.worldPerPixel = 0.03;
    const auto canvas = StrokeCanvas::create(surface->positions, surface->triangles, camera);
    std::vector<Stroke> pen(1);
    for (int i = 0; i <= 200; ++i) {
        const double t = i / 200.0;
        pen[0].samples.push_back({Vec2(340 + 600 * t, 400 + 60 * std::sin(12 * t)), 1.0, 8.0 * i});
    }
    for (auto _ : state) {
        const auto mapped = canvas->map(pen);
        if (!mapped) state.SkipWithError("no surface under the stroke");
        benchmark::DoNotOptimize(mapped);
    }
    state.counters["triangles"] = static_cast<double>(surface->triangles.size());
}
BENCHMARK(strokes)->Unit(benchmark::kMillisecond);

}  // namespace
