// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/document.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/base/tolerance.h"
#include "core/document/document_private.h"
#include "core/reading/interpret.h"
#include "core/stroke/suited_distance.h"

namespace ew {

// Private ----------------------------------------------------------------------------------------

Document::Private::Private(Document& document, TemplateLibrary shippedLibrary, Interpreter reader)
    : q(document), interpreter(std::move(reader)), shipped(std::move(shippedLibrary)) {
    DocumentState first;
    first.library = shipped;
    state = std::make_shared<const DocumentState>(std::move(first));
}

void Document::Private::touch() {
    const bool wasClean = revision == savedRevision;
    ++revision;
    if (wasClean) emitChange(DocumentChange::File);
}

void Document::Private::inkChanged() {
    reading.reset();
    touch();
    suitDistance();
    emitChange(DocumentChange::Ink);
    emitChange(DocumentChange::Reading);
}

void Document::Private::suitDistance() {
    if (!automaticDistance) return;
    std::vector<Stroke> strokes;
    // What is not measured is not copied for it at every stroke.
    if (ink.strokes().size() <= kMostStrokesMeasured) {
        for (const PendingStroke& s : ink.strokes()) strokes.push_back(s.stroke);
    }
    const double suited = suitedDistancePx(strokes);
    if (suited == view.thresholds.distancePx) return;
    view.thresholds.distancePx = suited;
    reading.reset();
    emitChange(DocumentChange::Thresholds);
}

void Document::Private::record(ScriptStep step, int inkSerial) {
    recorder.record(std::move(step), view, inkSerial);
}

namespace {

/// A point at which erasing takes exactly this stroke, or nothing where others cover all of it.
std::optional<Vec2> pointThatErases(const InkBoard& ink, int id, double reachPx) {
    const auto& strokes = ink.strokes();
    const auto it = std::find_if(strokes.begin(), strokes.end(),
                                 [&](const PendingStroke& s) { return s.id == id; });
    constexpr std::size_t kTries = 32;
    const auto& samples = it->stroke.samples;
    const std::size_t step = std::max<std::size_t>(1, samples.size() / kTries);
    for (std::size_t i = 0; i < samples.size(); i += step) {
        const auto nearest = ink.nearest(samples[i].position, reachPx);
        if (nearest && strokes[*nearest].id == id) return samples[i].position;
    }
    return std::nullopt;
}

/// Steps that remove strokes in a script, where only `erase` and `clear` can.
std::vector<std::pair<ScriptStep, OrthographicCamera>> removalSteps(const InkBoard& ink,
                                                                    const std::vector<int>& ids,
                                                                    const ViewSettings& view) {
    std::vector<std::pair<ScriptStep, OrthographicCamera>> steps;
    InkBoard left = ink;
    // Looking for a place to erase at costs a pass over all ink a stroke.
    constexpr std::size_t kMostErased = 16;
    if (ids.size() <= kMostErased && ids.size() < ink.strokes().size()) {
        for (const int id : ids) {
            const auto at = pointThatErases(left, id, view.thresholds.distancePx);
            if (!at) break;
            steps.emplace_back(EraseStep{*at}, view.camera);
            left.change({id}, {});
        }
        if (steps.size() == ids.size()) return steps;
    }
    left.change(ids, {});
    steps.clear();
    steps.emplace_back(ClearStep{}, view.camera);
    for (const PendingStroke& s : left.strokes()) {
        steps.emplace_back(strokeStep(s.stroke), s.camera);
    }
    return steps;
}

}  // namespace

bool Document::Private::editInk(const std::vector<int>& removeIds,
                                std::vector<std::pair<Stroke, OrthographicCamera>> add) {
    std::vector<int> known;
    for (const PendingStroke& s : ink.strokes()) {
        const bool named = std::find(removeIds.begin(), removeIds.end(), s.id) != removeIds.end();
        if (named) known.push_back(s.id);
    }
    std::vector<std::pair<ScriptStep, OrthographicCamera>> steps;
    if (!known.empty()) steps = removalSteps(ink, known, view);
    for (const auto& [stroke, camera] : add) steps.emplace_back(strokeStep(stroke), camera);
    const auto serial = ink.change(known, std::move(add));
    if (!serial) return false;
    for (auto& [step, camera] : steps) {
        recorder.record(std::move(step), {camera, view.thresholds}, *serial);
    }
    inkChanged();
    return true;
}

StrokeStep strokeStep(const Stroke& stroke) {
    StrokeStep step{stroke, false};
    step.hasPressure =
        std::any_of(stroke.samples.begin(), stroke.samples.end(),
                    [](const PenSample& s) { return s.pressure != 1.0 || s.timeMs != 0.0; });
    return step;
}

// Document: life ---------------------------------------------------------------------------------

Document::Document(TemplateLibrary shippedLibrary, QObject* parent)
    : Document(std::move(shippedLibrary), &interpret, parent) {}

Document::Document(TemplateLibrary shippedLibrary, Interpreter interpreter, QObject* parent)
    : QObject(parent),
      d_(std::make_unique<Private>(*this, std::move(shippedLibrary), std::move(interpreter))) {
    connect(&d_->stack, &QUndoStack::indexChanged, this,
            [this](int index) { d_->onStackMoved(index); });
}

Document::~Document() {
    // The stack clears itself when it dies and would say so.
    d_->stack.disconnect(this);
}

const DocumentState& Document::state() const { return *d_->state; }

// Ink --------------------------------------------------------------------------------------------

Result<int> Document::addStroke(Stroke stroke) {
    if (auto ok = validateStroke(stroke); !ok) return fail(ok.error());
    for (PenSample& s : stroke.samples) {
        if (!std::isfinite(s.pressure) || !std::isfinite(s.timeMs)) {
            return fail(Errc::BadCoordinates, "The pen's pressure or time is not a usable number.");
        }
        s.pressure = std::clamp(s.pressure, 0.0, 1.0);
    }
    if (d_->ink.strokes().size() >= kMaxPendingStrokes) {
        return fail(Errc::TooManyStrokes,
                    "There are " + std::to_string(kMaxPendingStrokes) +
                        " pending strokes already; apply or clear them first.");
    }
    const int id = d_->ink.nextId();
    std::vector<std::pair<Stroke, OrthographicCamera>> add;
    add.emplace_back(std::move(stroke), d_->view.camera);
    d_->editInk({}, std::move(add));
    return id;
}

Result<int> Document::eraseAt(const Vec2& px) {
    if (!px.allFinite()) return fail(Errc::BadCoordinates, "The place to erase is not a number.");
    const auto index = d_->ink.nearest(px, d_->view.thresholds.distancePx);
    if (!index) return fail(Errc::NoStroke, "There is no stroke within reach to erase.", {px});
    const int id = d_->ink.strokes()[*index].id;
    const auto serial = d_->ink.change({id}, {});
    d_->record(EraseStep{px}, *serial);
    d_->inkChanged();
    return id;
}

void Document::removeStrokes(const std::vector<int>& ids) { d_->editInk(ids, {}); }

void Document::clearStrokes() {
    std::vector<int> ids;
    for (const PendingStroke& s : d_->ink.strokes()) ids.push_back(s.id);
    d_->editInk(ids, {});
}

const std::vector<PendingStroke>& Document::pendingStrokes() const { return d_->ink.strokes(); }

namespace {

/// Marks the steps that take back an ink change which the recorder does not know.
int serialOfRemoval(int inkSerial) { return -2 - inkSerial; }

}  // namespace

bool Document::undoInk() {
    const InkChange* change = d_->ink.newest();
    if (change == nullptr) return false;
    const int serial = change->serial;
    if (const int steps = d_->recorder.inkSteps(serial); steps > 0) {
        if (!d_->recorder.dropInk(serial)) d_->record(UndoStep{steps, true});
    } else {
        // Of a file of schema 1: such a change only ever adds strokes.
        const auto& strokes = d_->ink.strokes();
        std::vector<int> known = change->added;
        std::erase_if(known, [&](int id) {
            return std::none_of(strokes.begin(), strokes.end(),
                                [&](const PendingStroke& s) { return s.id == id; });
        });
        for (auto& [step, camera] : removalSteps(d_->ink, known, d_->view)) {
            d_->recorder.record(std::move(step), {camera, d_->view.thresholds},
                                serialOfRemoval(serial));
        }
    }
    d_->ink.undoLast();
    d_->inkChanged();
    return true;
}

bool Document::canUndoInk() const { return d_->ink.newest() != nullptr; }

bool Document::redoInk() {
    const InkChange* change = d_->ink.newestUndone();
    if (change == nullptr) return false;
    const int serial = change->serial;
    if (const int steps = d_->recorder.inkSteps(serial); steps > 0) {
        d_->record(RedoStep{steps, true});
    } else if (!d_->recorder.putInkBack(serial) && !d_->recorder.dropInk(serialOfRemoval(serial))) {
        for (const PendingStroke& s : change->withdrawn) {
            d_->recorder.record(strokeStep(s.stroke), {s.camera, d_->view.thresholds}, serial);
        }
    }
    d_->ink.redoLast();
    d_->inkChanged();
    return true;
}

bool Document::canRedoInk() const { return d_->ink.newestUndone() != nullptr; }

bool Document::withdrawInk() {
    if (!undoInk()) return false;
    d_->ink.forgetUndone();
    d_->emitChange(DocumentChange::Ink);
    return true;
}

// View and thresholds ----------------------------------------------------------------------------

const OrthographicCamera& Document::camera() const { return d_->view.camera; }

Result<void> Document::setCamera(const OrthographicCamera& wanted) {
    OrthographicCamera camera = wanted;
    const double length = camera.direction.norm();
    const bool nearlyUnit = std::abs(length - 1.0) < 1e-6;
    if (nearlyUnit && std::abs(length - 1.0) > tol::kUnitLength) camera.direction /= length;
    if (auto ok = camera.validate(); !ok) return ok;
    // The ranges of a script, so that everything recorded can be read back.
    const double upSize = camera.up.cwiseAbs().maxCoeff();
    if (upSize < tol::kShortestDirection || upSize > 1.0 / tol::kShortestDirection) {
        return fail(Errc::BadValue, "The camera's up vector is too short or too long.");
    }
    if (camera.center.cwiseAbs().maxCoeff() > kMaxCenterMm) {
        return fail(Errc::BadValue, "The camera is too far away.");
    }
    if (std::min(camera.width, camera.height) < kMinViewportPx ||
        std::max(camera.width, camera.height) > kMaxViewportPx) {
        return fail(Errc::BadValue, "The viewport is too small or too large.");
    }
    if (camera == d_->view.camera) return {};
    d_->view.camera = camera;
    d_->emitChange(DocumentChange::Camera);
    return {};
}

const Thresholds& Document::thresholds() const { return d_->view.thresholds; }

Result<void> Document::setThresholds(const Thresholds& t) {
    // Written so that NaN fails too.
    if (!(t.distancePx >= kMinDistancePx && t.distancePx <= kMaxDistancePx)) {
        return fail(Errc::BadValue, "The distance threshold must be from 1 to 100 pixels.");
    }
    if (!(t.angleDeg >= kMinAngleDeg && t.angleDeg <= kMaxAngleDeg)) {
        return fail(Errc::BadValue, "The angle threshold must be from 0.5 to 45 degrees.");
    }
    if (t == d_->view.thresholds) return {};
    if (t.distancePx != d_->view.thresholds.distancePx) d_->automaticDistance = false;
    d_->view.thresholds = t;
    d_->reading.reset();
    d_->touch();
    d_->emitChange(DocumentChange::Thresholds);
    d_->emitChange(DocumentChange::Reading);
    return {};
}

bool Document::automaticDistance() const { return d_->automaticDistance; }

void Document::setAutomaticDistance(bool automatic) {
    d_->automaticDistance = automatic;
    d_->suitDistance();
    d_->emitChange(DocumentChange::Thresholds);
    d_->emitChange(DocumentChange::Reading);
}

double Document::obliqueFactor() const { return d_->obliqueFactor; }

void Document::setObliqueFactor(double k) {
    if (!std::isfinite(k)) return;
    const double factor = std::clamp(k, kMinObliqueFactor, kMaxObliqueFactor);
    if (factor == d_->obliqueFactor) return;
    d_->obliqueFactor = factor;
    d_->reading.reset();
    d_->emitChange(DocumentChange::Reading);
}

// Reading ----------------------------------------------------------------------------------------

namespace {

bool sameReading(const ApplyRequest& a, const ApplyRequest& b) {
    return a.templateId == b.templateId && a.operation == b.operation &&
           a.obliqueFactor == b.obliqueFactor;
}

}  // namespace

Interpretation Document::Private::read(const std::vector<PendingStroke>& strokes,
                                       const ApplyRequest& request,
                                       const std::vector<Body>& bodies) const {
    return task(strokes, request, bodies)();
}

std::function<Interpretation()> Document::Private::task(const std::vector<PendingStroke>& strokes,
                                                        const ApplyRequest& request,
                                                        const std::vector<Body>& bodies) const {
    InterpretOptions options;
    options.thresholds = view.thresholds;
    // All strokes are read in one plane: that of the newest.
    options.camera = strokes.empty() ? view.camera : strokes.back().camera;
    options.operation = request.operation;
    options.templateId = request.templateId;
    options.obliqueFactor = request.obliqueFactor.value_or(obliqueFactor);
    // Nobody draws on what is not seen.
    std::vector<int> places;
    std::tie(options.bodies, places) = visibleBodies(bodies);
    std::vector<Stroke> drawn;
    drawn.reserve(strokes.size());
    for (const PendingStroke& s : strokes) drawn.push_back(s.stroke);
    return [read = interpreter, drawn = std::move(drawn), library = state->library,
            options = std::move(options), places = std::move(places)] {
        Interpretation found = read(drawn, library, options);
        for (Candidate& c : found.candidates) {
            const auto body = static_cast<std::size_t>(c.body);
            if (c.body >= 0 && body < places.size()) c.body = places[body];
        }
        return found;
    };
}

const Interpretation& Document::interpretation() const { return interpretationFor({}); }

const Interpretation& Document::interpretationFor(const ApplyRequest& request) const {
    ApplyRequest effective = request;
    effective.obliqueFactor = request.obliqueFactor.value_or(d_->obliqueFactor);
    if (!d_->reading || !sameReading(effective, d_->readingRequest)) {
        d_->reading = d_->read(d_->ink.strokes(), effective, d_->state->bodies);
        d_->readingRequest = effective;
    }
    return *d_->reading;
}

Interpretation Document::interpretWith(const Stroke& underWay) const {
    return interpretWith(underWay, d_->view.camera);
}

Interpretation Document::interpretWith(const Stroke& underWay,
                                       const OrthographicCamera& camera) const {
    if (!validateStroke(underWay)) return interpretation();
    return readingTask(&underWay, camera)();
}

std::function<Interpretation()> Document::readingTask(const Stroke* underWay,
                                                      const OrthographicCamera& camera) const {
    std::vector<PendingStroke> strokes = d_->ink.strokes();
    if (underWay != nullptr && validateStroke(*underWay)) {
        strokes.push_back({d_->ink.nextId(), *underWay, camera});
    }
    return d_->task(strokes, {}, d_->state->bodies);
}

bool Document::readingKnown() const {
    ApplyRequest plain;
    plain.obliqueFactor = d_->obliqueFactor;
    return d_->reading && sameReading(plain, d_->readingRequest);
}

void Document::keepReading(Interpretation reading) {
    d_->reading = std::move(reading);
    d_->readingRequest = {};
    d_->readingRequest.obliqueFactor = d_->obliqueFactor;
}

}  // namespace ew
