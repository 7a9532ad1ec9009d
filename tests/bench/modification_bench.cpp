// SPDX-License-Identifier: GPL-3.0-or-later
// Times of sketching on models of 6 to 10,000 faces that were made by real operations, each stage
// by itself and in sum: a box drawn on a boss of a slab with rows of bosses, by exact lines and by
// the model of a hand.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>

#include "core/edge_graph/build.h"
#include "core/reading/extract/joint_graph.h"
#include "core/reading/interpret.h"
#include "core/reading/propose/modification.h"
#include "core/solid/boolean.h"
#include "core/tlib/library.h"
#include "tests/support/modification_cases.h"

namespace ew::test {
namespace {

constexpr double kCell = 80.0;  // [mm]

/// A row of bosses as one tool of several shells.
PolyhedronSpec row(int count, int y) {
    PolyhedronSpec spec;
    for (int x = 0; x < count; ++x) {
        const PolyhedronSpec one =
            boxSpec(kCell * Vec3(x + 0.25, y + 0.25, 0.5), kCell * Vec3(x + 0.75, y + 0.75, 0.75));
        const int base = static_cast<int>(spec.vertices.size());
        spec.vertices.insert(spec.vertices.end(), one.vertices.begin(), one.vertices.end());
        for (std::vector<int> face : one.faces) {
            for (int& v : face) v += base;
            spec.faces.push_back(std::move(face));
        }
    }
    return spec;
}

/// What is drawn on the slab of side x side cells: 6 + 5 side^2 faces.
struct Scene {
    Body body;
    OrthographicCamera camera;
    Solid tool;
    std::vector<Stroke> exact, byHand;
};

const Scene& scene(int side) {
    static std::map<int, Scene> made;
    const auto known = made.find(side);
    if (known != made.end()) return known->second;
    const double reach = kCell * std::max(side, 1);
    Solid solid = solidOf(boxSpec(Vec3::Zero(), Vec3(reach, reach, 0.5 * kCell)));
    for (int y = 0; y < side; ++y) {
        solid = combine(solid, solidOf(row(side, y)), BooleanKind::Add)->solid;
    }
    // On a boss in the middle, or on the slab where it has none.
    const double x = kCell * (side / 2 + 0.375);
    const double z = kCell * (side > 0 ? 0.75 : 0.5);
    const PolyhedronSpec spec =
        boxSpec(Vec3(x, x, z), Vec3(x, x, z) + kCell * Vec3(0.25, 0.25, 0.2));
    Scene s{{solid, {}}, {}, solidOf(spec), {}, {}};
    s.camera = modificationCamera(0, Vec3(x, x, z), {});
    s.camera.worldPerPixel = 0.2;
    ModificationCase c{"slab", "box", 0, s.body, s.camera, Operation::Add, "cube", {}};
    c.lines =
        newVisibleLines(s.body, combine(s.body.solid, s.tool, BooleanKind::Add)->solid, s.camera);
    s.exact = exactStrokes(linesOnPlane(c));
    Random hand(7);
    s.byHand = drawByHand(linesOnPlane(c), kNormalHand, hand);
    return made.emplace(side, std::move(s)).first->second;
}

/// Sides of slabs with 6, 101, 986 and 10,131 faces.
void models(benchmark::internal::Benchmark* b) {
    b->Arg(0)->Arg(4)->Arg(14)->Arg(45)->Unit(benchmark::kMillisecond);
}

void tellFaces(benchmark::State& state, const Scene& s) {
    state.counters["faces"] = static_cast<double>(s.body.solid.faces().size());
}

void hiddenLines(benchmark::State& state) {
    const Scene& s = scene(static_cast<int>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(ModelView::make(s.body, s.camera));
    tellFaces(state, s);
}

void extraction(benchmark::State& state) {
    const Scene& s = scene(static_cast<int>(state.range(0)));
    const auto view = ModelView::make(s.body, s.camera);
    const InkReading ink = readInk(s.exact, Thresholds{}.distancePx);
    for (auto _ : state) {
        benchmark::DoNotOptimize(extractJointGraph(ink, *view, {Thresholds{}, {}}));
    }
    tellFaces(state, s);
}

void boolean(benchmark::State& state) {
    const Scene& s = scene(static_cast<int>(state.range(0)));
    for (auto _ : state) {
        benchmark::DoNotOptimize(combine(s.body.solid, s.tool, BooleanKind::Add));
    }
    tellFaces(state, s);
}

void whole(benchmark::State& state, bool byHand) {
    static const TemplateLibrary library =
        loadLibrary(EDGEWRIGHT_SOURCE_DIR "/resources/templates")->library;
    const Scene& s = scene(static_cast<int>(state.range(0)));
    InterpretOptions o;
    o.camera = s.camera;
    o.bodies = {s.body};
    int right = 0;
    int all = 0;
    for (auto _ : state) {
        const Interpretation r = interpret(byHand ? s.byHand : s.exact, library, o);
        ++all;
        right += r.accepted && r.candidates[static_cast<std::size_t>(*r.accepted)].operation ==
                                   Operation::Add
                     ? 1
                     : 0;
    }
    if (right < all) state.SkipWithError("the box was not read");
    tellFaces(state, s);
}
void wholeExact(benchmark::State& state) { whole(state, false); }
void wholeByHand(benchmark::State& state) { whole(state, true); }

BENCHMARK(hiddenLines)->Apply(models);
BENCHMARK(extraction)->Apply(models);
BENCHMARK(boolean)->Apply(models);
BENCHMARK(wholeExact)->Apply(models);
BENCHMARK(wholeByHand)->Apply(models);

}  // namespace
}  // namespace ew::test
