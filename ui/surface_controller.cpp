// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/surface_controller.h"

#include <QCoreApplication>

#include "ui/viewport/viewport_widget.h"

namespace ew {

SurfaceController::SurfaceController(Document& document, ViewportWidget& viewport, QObject* parent)
    : QObject(parent), document_(document), viewport_(viewport), selection_(document) {
    lastSubdivision_.on = true;
    pool_.setMaxThreadCount(1);
    connect(&document_, &Document::changed, this, &SurfaceController::onDocumentChanged);
}

SurfaceController::~SurfaceController() { pool_.waitForDone(); }

void SurfaceController::onDocumentChanged(DocumentChange what) {
    if (what != DocumentChange::Shape) return;
    // A preview that is under way is of a document that is gone.
    wanted_.reset();
    if (running_) stale_ = true;
    const SubdivisionSettings& now = document_.state().surface.subdivision;
    if (now.on) lastSubdivision_ = now;
    const auto shape = document_.shape();
    clamped_ = shape->clamped;
    if (shape->problem) emit failed(*shape->problem);
    emit changed();
}

// The worker
// ----------------------------------------------------------------------------------------

void SurfaceController::derive(SurfaceSettings settings, Commit commit) {
    ShapeInput input = document_.shapeInput();
    settings.tidy();
    input.settings = std::move(settings);
    wanted_ = std::move(input);
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
    ShapeInput input = *std::exchange(wanted_, std::nullopt);
    pool_.start([this, input = std::move(input), cache = document_.shapeCache()] {
        auto shape = std::make_shared<const DerivedShape>(deriveShape(input, *cache));
        // This outlives the worker: the destructor waits for it.
        QMetaObject::invokeMethod(
            this, [this, shape] { finish(shape); }, Qt::QueuedConnection);
    });
}

void SurfaceController::finish(const std::shared_ptr<const DerivedShape>& shape) {
    running_ = false;
    if (wanted_) {
        // Every drag is shown on the way where there is time for it, not only its end.
        if (!commit_ && !shape->problem) viewport_.setPreview(ShapePreview{shape});
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
    viewport_.setPreview(ShapePreview{shape});
    emit changed();
}

void SurfaceController::flush() {
    if (const std::unique_ptr<Commit> commit = std::exchange(commit_, nullptr)) run(*commit);
}

void SurfaceController::run(const Commit& commit) {
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

// Fillet
// --------------------------------------------------------------------------------------------

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
    derive(*std::move(settings), {});
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

// Subdivision and strokes
// -------------------------------------------------------------------------

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
