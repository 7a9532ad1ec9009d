// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/surface_controller.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "ui/viewport/viewport_widget.h"

namespace ew {

namespace {

constexpr double kStepMs = 1000.0 / 30.0;
constexpr double kFasterShare = 0.2;  // a level more makes four times the triangles
constexpr int kMostLooser = 3;        // times four of the tolerance
constexpr int kRestMs = 150;

/// How many times a drag can be shown coarser; without a surface it is only drawn with rough edges.
int mostCoarser(const SubdivisionSettings& settings) {
    if (!settings.on) return 1;
    return settings.tolerance > 0.0 ? kMostLooser : settings.levels;
}

/// A surface with less triangles; in the end the filleted cage alone.
SubdivisionSettings coarsened(SubdivisionSettings settings, int by) {
    settings.on = settings.on && by < mostCoarser(settings);
    settings.levels = std::max(1, settings.levels - by);
    settings.tolerance *= std::pow(4.0, by);
    return settings;
}

}  // namespace

SurfaceController::SurfaceController(Document& document, ViewportWidget& viewport, QObject* parent)
    : QObject(parent),
      document_(document),
      viewport_(viewport),
      selection_(document),
      stepBudgetMs_(kStepMs) {
    lastSubdivision_.on = true;
    pool_.setMaxThreadCount(1);
    rest_.setSingleShot(true);
    rest_.setInterval(kRestMs);
    connect(&rest_, &QTimer::timeout, this, [this] {
        if (drag_) derive(*std::exchange(drag_, std::nullopt), {});
    });
    connect(&viewport_, &QOpenGLWidget::frameSwapped, this, &SurfaceController::onFrameShown);
    connect(&document_, &Document::changed, this, &SurfaceController::onDocumentChanged);
}

SurfaceController::~SurfaceController() { pool_.waitForDone(); }

void SurfaceController::onDocumentChanged(DocumentChange what) {
    if (what != DocumentChange::Shape) return;
    // A preview that is under way is of a document that is gone.
    wanted_.reset();
    drag_.reset();
    unseen_.reset();
    if (running_) stale_ = true;
    const SubdivisionSettings& now = document_.state().surface.subdivision;
    if (now.on) lastSubdivision_ = now;
    const auto shape = document_.shape();
    clamped_ = shape->clamped;
    if (shape->problem) emit failed(*shape->problem);
    emit changed();
}

// The worker -------------------------------------------------------------------------------------

void SurfaceController::derive(SurfaceSettings settings, Commit commit,
                               std::optional<int> coarser) {
    ShapeInput input = document_.shapeInput();
    settings.tidy();
    input.settings = std::move(settings);
    wanted_ = Wish{std::move(input), coarser};
    rest_.stop();
    commit_ = commit ? std::make_unique<Commit>(std::move(commit)) : nullptr;
    if (running_) {
        stale_ = true;
        return;
    }
    start();
}

void SurfaceController::start() {
    running_ = true;
    stale_ = false;
    Wish wish = *std::exchange(wanted_, std::nullopt);
    pool_.start([this, wish = std::move(wish), cache = document_.shapeCache()] {
        QElapsedTimer clock;
        clock.start();
        Derived derived;
        derived.shape = std::make_shared<const DerivedShape>(deriveShape(wish.input, *cache));
        derived.coarser = wish.coarser;
        derived.ms = static_cast<double>(clock.nsecsElapsed()) * 1e-6;
        // This outlives the worker: the destructor waits for it.
        QMetaObject::invokeMethod(
            this, [this, derived] { finish(derived); }, Qt::QueuedConnection);
    });
}

void SurfaceController::show(const Derived& derived) {
    viewport_.setPreview(ShapePreview{derived.shape, derived.coarser.value_or(0) > 0});
    unseen_ = derived;
    sinceShown_.start();
}

void SurfaceController::finish(const Derived& derived) {
    running_ = false;
    const std::shared_ptr<const DerivedShape>& shape = derived.shape;
    if (wanted_) {
        // Every drag is shown on the way where there is time for it, not only its end.
        if (!commit_ && !shape->problem) show(derived);
        start();
        return;
    }
    const bool isStale = std::exchange(stale_, false);
    if (commit_) {
        flush();
        return;
    }
    if (isStale) return;
    if (shape->problem) {
        emit failed(*shape->problem);
        return;
    }
    clamped_ = shape->clamped;
    show(derived);
    if (derived.coarser.value_or(0) > 0) rest_.start();
    emit changed();
}

void SurfaceController::onFrameShown() {
    if (!unseen_) return;
    const Derived shown = *std::exchange(unseen_, std::nullopt);
    if (!shown.coarser) return;
    const double step = shown.ms + static_cast<double>(sinceShown_.nsecsElapsed()) * 1e-6;
    const int most = mostCoarser(document_.state().surface.subdivision);
    if (step > stepBudgetMs_ && coarser_ < most) {
        ++coarser_;
    } else if (step < kFasterShare * stepBudgetMs_ && coarser_ > 0) {
        --coarser_;
    }
}

void SurfaceController::flush() {
    if (const std::unique_ptr<Commit> commit = std::exchange(commit_, nullptr)) run(*commit);
}

void SurfaceController::run(const Commit& commit) {
    drag_.reset();
    rest_.stop();
    const auto done = commit();
    // Where nothing changed the document says nothing, and the preview must not stay.
    viewport_.setPreview(std::nullopt);
    clamped_ = document_.shape()->clamped;
    emit changed();  // widgets show again what is, where it was refused
    if (!done) emit failed(done.error());
}

void SurfaceController::settle() {
    while (running_ || wanted_) {
        pool_.waitForDone();
        QCoreApplication::sendPostedEvents(this);
    }
}

// Fillet -----------------------------------------------------------------------------------------

Result<SurfaceSettings> SurfaceController::withFillet(double radius, int segments) const {
    if (auto ok = checkRadius(radius); !ok) return fail(ok.error());
    if (auto ok = checkSegments(segments); !ok) return fail(ok.error());
    const auto& bodies = document_.state().bodies;
    const auto edges = chosenEdges(bodies, selection_.choice());
    if (!edges) return fail(edges.error());
    SurfaceSettings settings = document_.state().surface;
    for (const EdgeRef& e : *edges) settings.setRadius(bodies, e, radius);
    settings.segments = segments;
    return settings;
}

void SurfaceController::previewFillet(double radius, int segments) {
    flush();
    auto settings = withFillet(radius, segments);
    if (!settings) {
        emit failed(settings.error());
        return;
    }
    drag_ = *settings;
    settings->subdivision = coarsened(settings->subdivision, coarser_);
    derive(*std::move(settings), {}, coarser_);
}

void SurfaceController::commitFillet(double radius, int segments) {
    flush();
    auto settings = withFillet(radius, segments);
    if (!settings) {
        emit failed(settings.error());
        return;
    }
    FilletRequest request{selection_.choice(), radius, segments, true};
    derive(*std::move(settings), [this, request]() -> Result<void> {
        const auto outcome = document_.fillet(request);
        if (!outcome) return fail(outcome.error());
        const auto count = static_cast<int>(outcome->clamped.size());
        if (count == 0) {
            emit noticed(outcome->edges == 1 ? tr("1 edge is filleted.")
                                             : tr("%1 edges are filleted.").arg(outcome->edges));
        } else {
            emit noticed(count == 1
                             ? tr("One edge has no room for its radius and got a smaller one.")
                             : tr("%1 edges have no room for their radius and got smaller "
                                  "ones; the Surface panel lists them.")
                                   .arg(count));
        }
        return {};
    });
    emit changed();
}

void SurfaceController::sharpen() {
    flush();
    run([this] { return document_.sharpen(selection_.choice()); });
}

void SurfaceController::crease(double sharpness) {
    flush();
    run([this, sharpness] { return document_.crease(selection_.choice(), sharpness); });
}

// Subdivision and strokes ------------------------------------------------------------------------

void SurfaceController::previewSubdivision(const SubdivisionSettings& wanted) {
    flush();
    if (document_.state().bodies.empty() || !checkSubdivision(wanted)) return;
    SurfaceSettings settings = document_.state().surface;
    settings.subdivision = wanted;
    derive(std::move(settings), {});
}

void SurfaceController::commitSubdivision(const SubdivisionSettings& wanted) {
    flush();
    if (auto ok = checkSubdivision(wanted); !ok) {
        emit failed(ok.error());
        return;
    }
    const bool wasOn = document_.state().surface.subdivision.on;
    SurfaceSettings settings = document_.state().surface;
    settings.subdivision = wanted;
    derive(std::move(settings),
           [this, wanted, wasOn] { return document_.subdivide(wanted, wasOn && wanted.on); });
    emit changed();
}

void SurfaceController::setSmooth(bool on) {
    if (on == document_.state().surface.subdivision.on) return;
    SubdivisionSettings settings = lastSubdivision_;
    settings.on = on;
    commitSubdivision(settings);
}

void SurfaceController::mapStrokes() {
    flush();
    const auto outcome = document_.mapStrokes(strokeColor_);
    if (!outcome) {
        emit failed(outcome.error());
        return;
    }
    if (outcome->missed > 0) {
        emit noticed(outcome->missed == 1
                         ? tr("One stroke has no surface under it and stays as it is.")
                         : tr("%1 strokes have no surface under them and stay as they are.")
                               .arg(outcome->missed));
    }
}

void SurfaceController::unmapStrokes() {
    if (auto done = document_.unmapStrokes(); !done) emit failed(done.error());
}

void SurfaceController::setStrokeColor(const StrokeColor& color) {
    if (color == strokeColor_) return;
    strokeColor_ = color;
    emit colorChanged(color);
}

}  // namespace ew
