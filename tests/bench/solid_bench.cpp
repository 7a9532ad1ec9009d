// SPDX-License-Identifier: GPL-3.0-or-later
// Times of the solid room on models of 6 to 10,000 faces that were made by real operations: a slab
// with rows of bosses.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <map>

#include "core/solid/boolean.h"
#include "core/solid/exact_tool.h"
#include "core/solid/visibility.h"
#include "tests/bench/need.h"

namespace ew::test {
namespace {

PolyhedronSpec boxSpec(const Vec3& low, const Vec3& high) {
    PolyhedronSpec spec;
    for (const double z : {low.z(), high.z()}) {
        spec.vertices.emplace_back(low.x(), low.y(), z);
        spec.vertices.emplace_back(high.x(), low.y(), z);
        spec.vertices.emplace_back(high.x(), high.y(), z);
        spec.vertices.emplace_back(low.x(), high.y(), z);
    }
    spec.faces = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                  {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    return spec;
}

/// A row of bosses as one tool of several shells.
Solid row(int count, int y) {
    PolyhedronSpec spec;
    for (int x = 0; x < count; ++x) {
        const PolyhedronSpec one =
            boxSpec(Vec3(4 * x + 1, 4 * y + 1, 2), Vec3(4 * x + 3, 4 * y + 3, 3));
        const int base = static_cast<int>(spec.vertices.size());
        spec.vertices.insert(spec.vertices.end(), one.vertices.begin(), one.vertices.end());
        for (std::vector<int> face : one.faces) {
            for (int& v : face) v += base;
            spec.faces.push_back(std::move(face));
        }
    }
    return need(Solid::fromSpec(spec));
}

/// The slab of side x side cells with a boss on every cell: 6 + 5 side^2 faces.
const Solid& slab(int side) {
    static std::map<int, Solid> made;
    const auto known = made.find(side);
    if (known != made.end()) return known->second;
    const double reach = std::max(4 * side, 4);
    Solid solid = need(Solid::fromSpec(boxSpec(Vec3::Zero(), Vec3(reach, reach, 2))));
    for (int y = 0; y < side; ++y) {
        solid = need(combine(solid, row(side, y), BooleanKind::Add)).solid;
    }
    return made.emplace(side, std::move(solid)).first->second;
}

/// Sides of slabs with 6, 101, 986 and 10,131 faces.
void models(benchmark::internal::Benchmark* b) {
    b->Arg(0)->Arg(4)->Arg(14)->Arg(45)->Unit(benchmark::kMillisecond);
}

void tellFaces(benchmark::State& state, const Solid& solid) {
    state.counters["faces"] = static_cast<double>(solid.faces().size());
}

/// A boss between four bosses, flush with the slab's top.
ToolSpec smallBoss() {
    ToolSpec spec;
    spec.shape = boxSpec(Vec3(3.25, 3.25, 2), Vec3(3.75, 3.75, 2.5));
    spec.snap = true;
    return spec;
}

void toolOnFace(benchmark::State& state) {
    const Solid& solid = slab(static_cast<int>(state.range(0)));
    tellFaces(state, solid);
    for (auto _ : state) benchmark::DoNotOptimize(makeTool(solid, smallBoss()));
}
BENCHMARK(toolOnFace)->Apply(models);

void addBoss(benchmark::State& state) {
    const Solid& solid = slab(static_cast<int>(state.range(0)));
    const Solid tool = need(makeTool(solid, smallBoss()));
    tellFaces(state, solid);
    for (auto _ : state) benchmark::DoNotOptimize(need(combine(solid, tool, BooleanKind::Add)));
}
BENCHMARK(addBoss)->Apply(models);

/// A pocket that takes a corner off a boss.
void cutPocket(benchmark::State& state) {
    const Solid& solid = slab(static_cast<int>(state.range(0)));
    const Solid tool = need(Solid::fromSpec(boxSpec(Vec3(2.5, 2.5, 1), Vec3(3.5, 3.5, 4))));
    tellFaces(state, solid);
    for (auto _ : state) benchmark::DoNotOptimize(need(combine(solid, tool, BooleanKind::Cut)));
}
BENCHMARK(cutPocket)->Apply(models);

/// A slot across the whole slab, through a row of bosses.
void cutSlot(benchmark::State& state) {
    const Solid& solid = slab(static_cast<int>(state.range(0)));
    const double reach = solid.bounds()[1].x();
    const Solid tool = need(Solid::fromSpec(boxSpec(Vec3(-1, 1.5, 1), Vec3(reach + 1, 2.5, 4))));
    tellFaces(state, solid);
    for (auto _ : state) benchmark::DoNotOptimize(need(combine(solid, tool, BooleanKind::Cut)));
}
BENCHMARK(cutSlot)->Apply(models);

/// All bosses made lower at once: every one of them is changed.
void cutTops(benchmark::State& state) {
    const Solid& solid = slab(static_cast<int>(state.range(0)));
    const double reach = solid.bounds()[1].x();
    const double height = state.range(0) == 0 ? 1.5 : 2.5;
    const Solid tool =
        need(Solid::fromSpec(boxSpec(Vec3(-1, -1, height), Vec3(reach + 1, reach + 1, 4))));
    tellFaces(state, solid);
    for (auto _ : state) benchmark::DoNotOptimize(need(combine(solid, tool, BooleanKind::Cut)));
}
BENCHMARK(cutTops)->Apply(models);

/// The whole gate with triangulation and merging, without any boolean: what opening a file costs.
void wholeGate(benchmark::State& state) {
    const Solid& solid = slab(static_cast<int>(state.range(0)));
    const std::string text = solid.serialize();
    tellFaces(state, solid);
    for (auto _ : state) benchmark::DoNotOptimize(need(Solid::deserialize(text)));
}
BENCHMARK(wholeGate)->Apply(models);

OrthographicCamera cameraOn(const Solid& solid) {
    OrthographicCamera camera;
    camera.center = 0.5 * (solid.bounds()[0] + solid.bounds()[1]);
    camera.worldPerPixel = (solid.bounds()[1] - solid.bounds()[0]).norm() / 800.0;
    return camera;
}

/// Preparing the view and removing the hidden lines.
void hiddenLines(benchmark::State& state) {
    const Solid& solid = slab(static_cast<int>(state.range(0)));
    const OrthographicCamera camera = cameraOn(solid);
    tellFaces(state, solid);
    for (auto _ : state) {
        const SolidView view = need(SolidView::make(solid, Pose{}, camera));
        benchmark::DoNotOptimize(view.visiblePieces());
    }
}
BENCHMARK(hiddenLines)->Apply(models);

void pickFace(benchmark::State& state) {
    const Solid& solid = slab(static_cast<int>(state.range(0)));
    const SolidView view = need(SolidView::make(solid, Pose{}, cameraOn(solid)));
    tellFaces(state, solid);
    double x = 300.0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(view.pick(Vec2(x, 410.0)));
        x = x < 900.0 ? x + 0.37 : 300.0;
    }
}
BENCHMARK(pickFace)->Apply(models)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace ew::test
