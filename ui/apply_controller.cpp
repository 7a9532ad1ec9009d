// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/apply_controller.h"

#include "ui/live_reading.h"

namespace ew {

namespace {
// How often a wait looks whether a panel is in use [ms].
constexpr int kLookMs = 100;
}  // namespace

ApplyController::ApplyController(Document& document, LiveReading& reading, QObject* parent)
    : QObject(parent), document_(document), reading_(reading) {
    countdown_.setSingleShot(true);
    look_.setInterval(kLookMs);
    connect(&countdown_, &QTimer::timeout, this, &ApplyController::onCountdownOver);
    connect(&look_, &QTimer::timeout, this, &ApplyController::look);
    connect(&reading_, &LiveReading::changed, this, &ApplyController::onReadingChanged);
    connect(&document_, &Document::changed, this, [this](DocumentChange what) {
        // Undo, clearing and the like are thoughts, not strokes: only the pen starts a wait.
        if (what == DocumentChange::Ink || what == DocumentChange::History) hold();
    });
}

bool ApplyController::showsApplied() const {
    return document_.pendingStrokes().empty() && !reading_.strokeUnderWay() &&
           document_.lastApply() != nullptr;
}

const Interpretation& ApplyController::shown() const {
    return showsApplied() ? document_.lastApply()->interpretation : reading_.reading();
}

int ApplyController::shownCurrent() const {
    return showsApplied() ? document_.lastApply()->chosen : reading_.current();
}

void ApplyController::apply() {
    hold();
    if (document_.pendingStrokes().empty() && showsApplied()) return;
    reading_.refreshNow();
    reading_.settleNow();
    take(reading_.current());
}

void ApplyController::take(int candidate) {
    hold();
    ApplyRequest request;
    if (candidate >= 0) request.candidate = candidate;
    request.level = level_;
    const auto outcome = document_.apply(request);
    if (outcome) {
        emit applied(*outcome);
    } else {
        emit failed(outcome.error());
    }
}

void ApplyController::pick(int candidate) {
    hold();
    if (candidate < 0 || candidate >= static_cast<int>(shown().candidates.size())) return;
    if (!showsApplied()) {
        reading_.choose(candidate);
        return;
    }
    const auto outcome = document_.chooseReading(candidate);
    if (outcome) {
        emit applied(*outcome);
    } else {
        emit failed(outcome.error());
    }
}

void ApplyController::setObliqueFactor(double k, bool done) {
    hold();
    document_.setObliqueFactor(k);
    if (!done || !showsApplied()) return;
    const ApplyOutcome* last = document_.lastApply();
    if (last->chosen < 0) return;
    const Candidate& c = last->interpretation.candidates[static_cast<std::size_t>(last->chosen)];
    if (c.depth == DepthRule::Oblique) pick(last->chosen);
}

void ApplyController::setAutomatic(bool on) {
    if (on == automatic_) return;
    automatic_ = on;
    if (!on) hold();
    emit automaticChanged(on);
}

void ApplyController::inkDone() {
    hold();
    if (!automatic_) return;
    awaitsReading_ = true;
    reading_.askNow();
}

void ApplyController::beginWait() {
    awaitsReading_ = false;
    if (!clear()) return;
    look_.start();
    look();
}

void ApplyController::look() {
    const bool inUse = busy_ && busy_();
    if (inUse) {
        stopCountdown();
    } else if (!countdown_.isActive()) {
        // From the start again: nothing happens right after a panel was left.
        countdown_.start(kWaitMs);
        emit countdownChanged(true);
    }
}

void ApplyController::stopCountdown() {
    if (!countdown_.isActive()) return;
    countdown_.stop();
    emit countdownChanged(false);
}

void ApplyController::hold() {
    awaitsReading_ = false;
    look_.stop();
    stopCountdown();
}

bool ApplyController::clear() const {
    return !document_.pendingStrokes().empty() && !reading_.strokeUnderWay() &&
           reading_.reading().accepted.has_value() && reading_.chosen() < 0;
}

void ApplyController::onReadingChanged() {
    if (awaitsReading_ && reading_.upToDate()) beginWait();
    if (waiting() && !clear()) hold();
    emit changed();
}

void ApplyController::onCountdownOver() {
    emit countdownChanged(false);
    if (busy_ && busy_()) return;  // look() counts anew when the panel is left
    look_.stop();
    if (clear()) apply();
}

}  // namespace ew
