// SPDX-License-Identifier: GPL-3.0-or-later
// Times of documents: opening a long history and a large file, a command on its way to the disk,
// undo deep in the history of the printer.
#include <benchmark/benchmark.h>

#include <QFileInfo>
#include <QTemporaryDir>
#include <QUndoStack>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>

#include "core/document/replay.h"
#include "core/document/store.h"
#include "core/document/work_copy.h"
#include "core/solid/boolean.h"
#include "tests/bench/need.h"
#include "tests/document/fixtures.h"

namespace ew::test {
namespace {

Solid movedBox(const Vec3& size, const Vec3& at) {
    PolyhedronSpec spec = cornerBox(size.x(), size.y(), size.z());
    for (Vec3& v : spec.vertices) v += at;
    return need(Solid::fromSpec(spec));
}

/// A stroke as a pen draws it, with so many samples.
Stroke wavyStroke(int samples, std::mt19937& random) {
    Stroke s;
    std::normal_distribution<double> shake(0.0, 0.3);
    for (int i = 0; i < samples; ++i) {
        s.samples.push_back({{2.0 * i + shake(random), 100 + shake(random)}, 0.5, 8.0 * i});
    }
    return s;
}

/// A history of so many steps, each of which makes another solid: a plate that gets a boss or a
/// pocket at a time, and is begun anew when it has so many.
DocumentFile longHistory(int steps, int changesOfOne, int samplesAStep) {
    DocumentFile file;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> anywhere(1.0, 90.0);
    auto state = std::make_shared<DocumentState>();
    state->library = shippedLibrary();
    file.first = state;
    Solid solid = movedBox({100, 100, 10}, Vec3::Zero());
    for (int i = 0; i < steps; ++i) {
        if (i % changesOfOne == 0) {
            solid = movedBox({100, 100, 10 + i * 1e-3}, Vec3::Zero());
        } else {
            const Solid tool = movedBox({7.3, 6.1, 9}, {anywhere(random), anywhere(random), 5});
            auto changed = combine(solid, tool, i % 2 == 0 ? BooleanKind::Add : BooleanKind::Cut);
            if (changed) solid = changed->solid;
        }
        auto next = std::make_shared<DocumentState>(*file.stateAt(i));
        next->bodies = {{solid, Pose{}}};
        StoredCommand command;
        command.name = "Add a box";
        command.after = next;
        PendingStroke stroke;
        stroke.id = i;
        stroke.stroke = wavyStroke(samplesAStep, random);
        command.consumed = {i};
        file.strokes.push_back(std::move(stroke));
        file.commands.push_back(std::move(command));
    }
    file.index = steps;
    file.nextStrokeId = steps;
    return file;
}

struct Kept {
    QTemporaryDir folder;
    QString path = folder.filePath(QStringLiteral("d.edgewright"));
};

/// \param range  steps, changes of one solid, samples a step.
void openHistory(benchmark::State& state) {
    static std::map<std::vector<std::int64_t>, Kept> made;
    const std::vector<std::int64_t> key{state.range(0), state.range(1), state.range(2)};
    const bool isNew = !made.contains(key);
    const Kept& kept = made[key];
    if (isNew) {
        need(saveDocument(longHistory(static_cast<int>(key[0]), static_cast<int>(key[1]),
                                      static_cast<int>(key[2])),
                          kept.path));
    }
    const auto d = std::make_unique<Document>(shippedLibrary());
    // As the window does it.
    for (auto _ : state) d->open(need(d->openTask(kept.path)()));
    state.counters["MiB"] = static_cast<double>(QFileInfo(kept.path).size()) / (1U << 20U);
    state.counters["faces"] = static_cast<double>(d->state().bodies.front().solid.faces().size());
}
BENCHMARK(openHistory)
    ->Args({1'000, 12, 60})
    ->Args({1'000, 40, 60})
    ->Args({10'000, 20, 400})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

/// The printer, with so many further steps.
std::unique_ptr<Document> printerAfter(int steps) {
    auto d = std::make_unique<Document>(shippedLibrary());
    const QString path = QStringLiteral(EDGEWRIGHT_SOURCE_DIR "/resources/examples/printer.json");
    const auto script = need(readSketchScript(need(readFileBytes(path, 1U << 24U))));
    ReplayOptions options;
    options.leaveOutFiles = true;
    if (replay(*d, script, options).firstFailure() != nullptr) std::exit(2);
    for (int i = 0; i < steps; ++i) {
        EdgeChoice edge;
        edge.which = EdgeChoice::Which::Picked;
        edge.picked = {{0, i % 12}};
        need(d->crease(edge, 1.0 + 8.0 * (i % 1'000) / 1'000));
    }
    return d;
}

void commandOnItsWayToTheDisk(benchmark::State& state) {
    const auto d = printerAfter(0);
    const QTemporaryDir folder;
    WorkCopy copy(*d, WorkFolder(folder.path()));
    std::mt19937 random(3);
    for (auto _ : state) {
        need(d->addStroke(wavyStroke(200, random)));
        need(copy.flush());
    }
}
BENCHMARK(commandOnItsWayToTheDisk)->Unit(benchmark::kMillisecond)->UseRealTime();

void undoDeepInThePrinter(benchmark::State& state) {
    const auto d = printerAfter(static_cast<int>(state.range(0)));
    for (auto _ : state) {
        if (d->undoStack().index() == 0) {
            state.PauseTiming();
            need(d->redo(d->undoStack().count()));
            state.ResumeTiming();
        }
        need(d->undo());
    }
    state.counters["steps"] = static_cast<double>(d->undoStack().count());
}
BENCHMARK(undoDeepInThePrinter)->Arg(10)->Arg(10'000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace ew::test
