// SPDX-License-Identifier: GPL-3.0-or-later
// Times of the stages from ink to candidates, on a drawing of a box in twelve strokes by a normal
// hand, with the shipped templates alone and with a thousand more.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <map>

#include "core/edge_graph/build.h"
#include "core/reading/interpret.h"
#include "core/tlib/library.h"
#include "core/tlib/matcher.h"
#include "tests/support/sketch_generator.h"
#include "tests/support/template_variations.h"

namespace ew::test {
namespace {

struct TwelveStrokes {
    OrthographicCamera camera;
    std::vector<Stroke> strokes;
};

/// The first drawing of a cube, counting seeds upwards, that has twelve strokes.
const TwelveStrokes& twelveStrokes() {
    static const TwelveStrokes drawing = [] {
        for (std::uint64_t seed = 1;; ++seed) {
            Random random(seed);
            const SketchCase sketch = randomSketch("cube", random);
            auto strokes = drawByHand(sketch.drawing.lines(), kNormalHand, random);
            if (strokes.size() == 12) return TwelveStrokes{sketch.camera, std::move(strokes)};
        }
    }();
    return drawing;
}

/// The shipped templates and so many more over polygons of at least so many corners.
const TemplateLibrary& libraryWith(int more, int fewestCorners) {
    static std::map<std::pair<int, int>, TemplateLibrary> libraries;
    const std::pair key(more, fewestCorners);
    const auto known = libraries.find(key);
    if (known != libraries.end()) return known->second;
    const auto shipped = loadLibrary(EDGEWRIGHT_SOURCE_DIR "/resources/templates");
    Random random(1);
    const auto all = shipped
                         ? shipped->library.withAll(templateVariations(more, random, fewestCorners))
                         : Result<TemplateLibrary>(fail(shipped.error()));
    if (!all) {
        std::fprintf(stderr, "%s\n", all.error().message.c_str());
        std::exit(2);
    }
    return libraries.emplace(key, *all).first->second;
}

void readInkOfTwelveStrokes(benchmark::State& state) {
    const double distancePx = Thresholds{}.distancePx;
    for (auto _ : state) benchmark::DoNotOptimize(readInk(twelveStrokes().strokes, distancePx));
}
BENCHMARK(readInkOfTwelveStrokes)->Unit(benchmark::kMillisecond);

void buildGraphOfTwelveStrokes(benchmark::State& state) {
    const double distancePx = Thresholds{}.distancePx;
    const InkReading ink = readInk(twelveStrokes().strokes, distancePx);
    for (auto _ : state) benchmark::DoNotOptimize(buildEdgeGraph(ink, distancePx));
}
BENCHMARK(buildGraphOfTwelveStrokes)->Unit(benchmark::kMillisecond);

void matchTwelveStrokes(benchmark::State& state) {
    const TemplateLibrary& library =
        libraryWith(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    const double distancePx = Thresholds{}.distancePx;
    const EdgeGraph graph =
        buildEdgeGraph(readInk(twelveStrokes().strokes, distancePx), distancePx);
    for (auto _ : state)
        benchmark::DoNotOptimize(matchGraph(graph, library.index(), MatchOptions{}));
}
BENCHMARK(matchTwelveStrokes)
    ->Args({0, 3})
    ->Args({1000, 5})
    ->Args({1000, 3})
    ->Unit(benchmark::kMillisecond);

/// All of it: the figure of the requirement (3 ms, and 15 ms with 1,000 templates). The arguments
/// are the number of further templates and the fewest corners of their polygons: from 5 on they
/// are other shapes, from 3 on a good part of them looks like a box from some side and has to be
/// weighed.
void interpretTwelveStrokes(benchmark::State& state) {
    const TemplateLibrary& library =
        libraryWith(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    InterpretOptions options;
    options.camera = twelveStrokes().camera;
    for (auto _ : state) {
        const Interpretation reading = interpret(twelveStrokes().strokes, library, options);
        if (reading.candidates.empty()) {
            state.SkipWithError("the drawing was not read");
            break;
        }
        benchmark::DoNotOptimize(reading.candidates.data());
    }
}
BENCHMARK(interpretTwelveStrokes)
    ->Args({0, 3})
    ->Args({1000, 5})
    ->Args({1000, 3})
    ->Unit(benchmark::kMillisecond)
    ->Repetitions(5)
    ->ReportAggregatesOnly();

/// Every further stroke is analysed with the others: the cost of a crowded sheet.
void interpretManyStrokes(benchmark::State& state) {
    const TemplateLibrary& library = libraryWith(0, 3);
    InterpretOptions options;
    std::vector<Stroke> strokes;
    for (std::uint64_t seed = 1; static_cast<int>(strokes.size()) < state.range(0); ++seed) {
        Random random(seed);
        const SketchCase sketch = randomSketch("l-prism", random);
        const Vec2 shift(random.uniform(-300, 300), random.uniform(-200, 200));
        for (Stroke& s : drawByHand(sketch.drawing.lines(), kNormalHand, random)) {
            for (PenSample& p : s.samples) p.position += shift;
            strokes.push_back(std::move(s));
        }
    }
    strokes.resize(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(interpret(strokes, library, options));
}
BENCHMARK(interpretManyStrokes)->Arg(50)->Arg(200)->Unit(benchmark::kMillisecond);

void deriveAspectsOfThousandTemplates(benchmark::State& state) {
    Random random(1);
    const std::vector<Template> templates = templateVariations(1000, random);
    for (auto _ : state) benchmark::DoNotOptimize(TemplateLibrary().withAll(templates));
}
BENCHMARK(deriveAspectsOfThousandTemplates)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace ew::test
