// SPDX-License-Identifier: GPL-3.0-or-later
// Times of the window; needs an X display with OpenGL. Limits: a pen sample 0.5 ms, a frame while
// drawing with 200 pending strokes 16 ms in software OpenGL, window start to first frame 1 s.
#include <benchmark/benchmark.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTabletEvent>
#include <QTest>
#include <cstdio>
#include <ctime>
#include <memory>

#include "core/document/document.h"
#include "core/document/replay.h"
#include "core/document/resources.h"
#include "ui/app_setup.h"
#include "ui/apply_controller.h"
#include "ui/live_reading.h"
#include "ui/main_window.h"
#include "ui/surface_controller.h"
#include "ui/theme/appearance.h"
#include "ui/tools/tool_box.h"
#include "ui/viewport/viewport_widget.h"

namespace {

std::unique_ptr<ew::Appearance> appearance;
std::unique_ptr<ew::MainWindow> window;

void sendPen(QEvent::Type type, const QPointF& at) {
    const Qt::MouseButtons buttons =
        type == QEvent::TabletRelease ? Qt::NoButton : Qt::MouseButtons(Qt::LeftButton);
    const Qt::MouseButton button = type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton;
    QTabletEvent event(type, QPointingDevice::primaryPointingDevice(), at, at, 0.5, 0, 0, 0, 0, 0,
                       Qt::NoModifier, button, buttons);
    QApplication::sendEvent(&window->viewport(), &event);
}

QPointF alongWave(int i) { return {40.0 + (i % 600), 200.0 + 60.0 * ((i / 7) % 5)}; }

void addStrokes(int count) {
    window->document().clearStrokes();
    for (int k = 0; k < count; ++k) {
        ew::Stroke stroke;
        const ew::Vec2 from(40.0 + 30.0 * (k % 20), 40.0 + 55.0 * (k / 20));
        for (int i = 0; i <= 40; ++i) {
            stroke.samples.push_back(
                {from + ew::Vec2(2.0 * i, (k % 5) * 0.8 * i), 0.3 + 0.01 * i, 8.0 * i});
        }
        if (!window->document().addStroke(std::move(stroke))) std::abort();
    }
    QApplication::processEvents();
}

/// Counts what a benchmark says it measures: a window that is hidden or a pen that nobody hears
/// would be fast.
class PaintCounter : public QObject {
  public:
    PaintCounter() { window->viewport().installEventFilter(this); }
    bool eventFilter(QObject* /*watched*/, QEvent* event) override {
        if (event->type() == QEvent::Paint) ++paints;
        return false;
    }
    int paints = 0;
};

/// A whole frame now, put together and shown. repaint() is not enough: it may leave the work to the
/// event loop.
void drawFrame() {
    window->viewport().update();
    QEvent now(QEvent::UpdateRequest);
    QApplication::sendEvent(window.get(), &now);
}

/// The handler of one sample, as the pen tool sees it.
void penSample(benchmark::State& state) {
    addStrokes(static_cast<int>(state.range(0)));
    sendPen(QEvent::TabletPress, {30, 30});
    int i = 0;
    for (auto _ : state) sendPen(QEvent::TabletMove, alongWave(i++));
    sendPen(QEvent::TabletRelease, {40, 40});
    const auto& strokes = window->document().pendingStrokes();
    const auto wanted = static_cast<std::size_t>(i) + 2;
    if (strokes.empty() || strokes.back().stroke.samples.size() != wanted) {
        state.SkipWithError("the pen was not heard");
    }
    QApplication::processEvents();
}
BENCHMARK(penSample)->Arg(0)->Arg(200)->Unit(benchmark::kMicrosecond)->Iterations(20000);

/// A whole frame in this process while a stroke grows by three samples a frame, without the reading
/// (it has its own pace and benchmark); paint_ms is the share of the viewport.
void frameWhileDrawing(benchmark::State& state) {
    addStrokes(static_cast<int>(state.range(0)));
    window->reading().refreshNow();
    sendPen(QEvent::TabletPress, {30, 30});
    drawFrame();
    PaintCounter counter;
    int i = 0;
    double paint = 0.0;
    for (auto _ : state) {
        for (int k = 0; k < 3; ++k) sendPen(QEvent::TabletMove, alongWave(i++));
        drawFrame();
        paint += window->viewport().lastFrameMs();
    }
    if (counter.paints < state.iterations()) state.SkipWithError("frames were left out");
    state.counters["paint_ms"] = benchmark::Counter(paint, benchmark::Counter::kAvgIterations);
    window->tools().cancelGesture();
    QApplication::processEvents();
}
BENCHMARK(frameWhileDrawing)
    ->Arg(0)
    ->Arg(12)
    ->Arg(200)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(200);

/// Every frame turns the view: scene, ink and overlays are all drawn anew.
void frameWhileOrbiting(benchmark::State& state) {
    addStrokes(static_cast<int>(state.range(0)));
    window->reading().refreshNow();
    const ew::OrthographicCamera start = window->document().camera();
    PaintCounter counter;
    window->viewport().setMoving(true);
    int i = 0;
    for (auto _ : state) {
        ew::OrthographicCamera camera = start;
        camera.center.x() += 0.25 * (++i % 50);
        (void)window->document().setCamera(camera);
        drawFrame();
    }
    window->viewport().setMoving(false);
    (void)window->document().setCamera(start);
    if (counter.paints < state.iterations()) state.SkipWithError("frames were left out");
}
BENCHMARK(frameWhileOrbiting)
    ->Arg(0)
    ->Arg(12)
    ->Arg(200)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(100);

/// Replays an example; false where it cannot be.
bool openExample(const char* name) {
    const auto folder = ew::resourcesFolder();
    if (!folder) return false;
    QFile file(*folder + QStringLiteral("/examples/") + QLatin1String(name));
    if (!file.open(QIODevice::ReadOnly)) return false;
    const auto script = ew::readSketchScript(file.readAll().toStdString());
    if (!script) return false;
    return ew::replay(window->document(), *script, {}).firstFailure() == nullptr;
}

/// The radius of all edges of the printer is dragged: fillet, surface and a whole frame a step, one
/// after the other although the window derives the next one while it draws the last. Limit: 30
/// steps a second in software OpenGL. all_threads_ms is the time of all processors, which other
/// programs disturb less.
/// \param levels  of the surface, 0: the filleted cage alone.
void radiusDrag(benchmark::State& state) {
    if (!openExample("printer.json")) {
        state.SkipWithError("the example does not replay");
        return;
    }
    ew::SubdivisionSettings surface = window->document().state().surface.subdivision;
    surface.on = state.range(0) > 0;
    surface.levels = static_cast<int>(state.range(0));
    if (!window->document().subdivide(surface)) state.SkipWithError("no such surface");
    QApplication::processEvents();
    const ew::SurfaceSettings settings = window->document().state().surface;
    const double radius = settings.radius({0, 0});
    PaintCounter counter;
    drawFrame();
    int i = 0;
    double frame = 0.0;
    const std::clock_t begin = std::clock();
    for (auto _ : state) {
        // Radii that no cache knows.
        window->surface().previewFillet(radius * (0.5 + 0.002 * ++i), settings.segments);
        window->surface().settle();
        QElapsedTimer clock;
        clock.start();
        drawFrame();
        frame += static_cast<double>(clock.nsecsElapsed()) * 1e-6;
    }
    const double all = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    if (counter.paints < state.iterations()) state.SkipWithError("frames were left out");
    state.counters["frame_ms"] = benchmark::Counter(frame, benchmark::Counter::kAvgIterations);
    state.counters["all_threads_ms"] = benchmark::Counter(all, benchmark::Counter::kAvgIterations);
    window->document().reset();
    QApplication::processEvents();
}
BENCHMARK(radiusDrag)
    ->Arg(0)
    ->Arg(1)
    ->Arg(2)
    ->Arg(3)
    ->ArgName("levels")
    ->Unit(benchmark::kMillisecond)
    ->Iterations(100);

/// The same drag as a hand makes it: radii come at the pace of a mouse, the worker derives while
/// the window draws. What counts is how many new shapes are seen in a second; limit: 30.
void radiusDragLive(benchmark::State& state) {
    if (!openExample("printer.json")) {
        state.SkipWithError("the example does not replay");
        return;
    }
    QApplication::processEvents();
    const ew::SurfaceSettings settings = window->document().state().surface;
    const double radius = settings.radius({0, 0});
    ew::SurfaceController& surface = window->surface();
    int i = 0;
    int shown = 0;
    constexpr int kMouseMs = 8;
    QTimer hand;
    hand.setInterval(kMouseMs);
    QObject::connect(&hand, &QTimer::timeout, [&] {
        surface.previewFillet(radius * (0.5 + 0.0005 * ++i), settings.segments);
    });
    std::shared_ptr<const ew::DerivedShape> last;
    QObject::connect(&window->viewport(), &QOpenGLWidget::frameSwapped, &hand, [&] {
        shown += last != window->viewport().shownShape() ? 1 : 0;
        last = window->viewport().shownShape();
    });
    hand.start();
    QElapsedTimer clock;
    const auto runFor = [&](int ms) {
        for (clock.start(); clock.elapsed() < ms;) QApplication::processEvents();
    };
    constexpr int kWarmUpMs = 1000;
    runFor(kWarmUpMs);
    shown = 0;
    constexpr int kMs = 4000;
    for (auto _ : state) runFor(kMs);
    hand.stop();
    surface.settle();
    state.counters["shapes_a_second"] = 1000.0 * shown / kMs;
    window->document().reset();
    QApplication::processEvents();
}
BENCHMARK(radiusDragLive)->Unit(benchmark::kMillisecond)->Iterations(1);

/// From starting the program to its first picture, loading of libraries included.
void startToFirstFrame(benchmark::State& state) {
    for (auto _ : state) {
        QElapsedTimer clock;
        clock.start();
        QProcess program;
        program.start(EDGEWRIGHT_PROGRAM, {"--first-frame"});
        // It prints the time since its main() began.
        constexpr int kMostMs = 30'000;
        if (!program.waitForReadyRead(kMostMs)) {
            state.SkipWithError("the window did not come up");
            return;
        }
        state.SetIterationTime(static_cast<double>(clock.nsecsElapsed()) * 1e-9);
        program.waitForFinished(kMostMs);
    }
}
BENCHMARK(startToFirstFrame)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(5);

}  // namespace

int main(int argc, char** argv) {
    QStandardPaths::setTestModeEnabled(true);
    ew::prepareApplication();
    QApplication application(argc, argv);
    ew::nameApplication();
    if (!ew::chooseLanguage("en")) return 2;
    benchmark::Initialize(&argc, argv);
    const auto load = ew::loadTemplates();
    if (!load) {
        std::fprintf(stderr, "%s\n", load.error().message.c_str());
        return 2;
    }
    appearance = std::make_unique<ew::Appearance>();
    window = std::make_unique<ew::MainWindow>(load->library, *appearance,
                                              ew::MainWindowOptions{.remember = false});
    window->applyController().setAutomatic(false);
    window->resize(1360, 860);
    window->show();
    if (!QTest::qWaitForWindowExposed(window.get())) return 2;
    QApplication::processEvents();
    benchmark::RunSpecifiedBenchmarks();
    window->document().clearStrokes();
    window.reset();
    appearance.reset();
    return 0;
}
