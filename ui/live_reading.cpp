// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live_reading.h"

#include <QCoreApplication>
#include <QEvent>
#include <QMetaObject>
#include <algorithm>
#include <memory>

namespace ew {

namespace {
constexpr int kFrameMs = 16;
// The pen rests: nothing was drawn and it did not move above the sheet for so long.
constexpr int kSettleMs = 1200;
// While drawing, reading may take this share of the time at most: wait (1 / share - 1) times its
// own cost before it is done again.
constexpr double kWaitPerCost = 2.0;
constexpr double kLongestWaitMs = 400.0;
// What took longer than this the last time is read on another thread.
constexpr double kShortMs = 12.0;
}  // namespace

LiveReading::LiveReading(Document& document, QObject* parent)
    : QObject(parent), document_(document) {
    frameTimer_.setSingleShot(true);
    settleTimer_.setSingleShot(true);
    settleTimer_.setInterval(kSettleMs);
    connect(&frameTimer_, &QTimer::timeout, this, &LiveReading::refresh);
    connect(&settleTimer_, &QTimer::timeout, this, &LiveReading::settleNow);
    connect(&document_, &Document::changed, this, &LiveReading::onDocumentChanged);
    thread_.setMaxThreadCount(1);
    reading_ = document_.interpretation();
}

LiveReading::~LiveReading() { thread_.waitForDone(); }

const OrthographicCamera& LiveReading::sketchCamera() const {
    const auto& pending = document_.pendingStrokes();
    return pending.empty() ? document_.camera() : pending.back().camera;
}

void LiveReading::follow(const Stroke* underWay) {
    if (underWay_ == nullptr) {
        settled_ = false;
        settleTimer_.stop();
    }
    underWay_ = underWay;
    schedule();
}

void LiveReading::strokeGone() {
    underWay_ = nullptr;
    settleTimer_.start();
    schedule();
}

void LiveReading::settleNow() {
    settleTimer_.stop();
    if (settled_) return;
    settled_ = true;
    emit changed();
}

bool LiveReading::justBegun() const {
    return document_.pendingStrokes().size() == 1 && underWay_ == nullptr && reading_.graph.empty();
}

void LiveReading::penMoved() {
    if (settleTimer_.isActive()) settleTimer_.start();
}

int LiveReading::current() const {
    const int count = static_cast<int>(reading_.candidates.size());
    if (chosen_ >= 0 && chosen_ < count) return chosen_;
    if (reading_.accepted) return *reading_.accepted;
    return count > 0 ? 0 : -1;
}

void LiveReading::choose(int candidate) {
    if (candidate >= static_cast<int>(reading_.candidates.size())) return;
    chosen_ = candidate;
    emit changed();
}

void LiveReading::onDocumentChanged(DocumentChange what) {
    switch (what) {
        case DocumentChange::Ink:
            chosen_ = -1;
            ++revision_;
            // Taking strokes back is a part of drawing too.
            settled_ = false;
            settleTimer_.start();
            schedule();
            break;
        case DocumentChange::Reading:
        case DocumentChange::Thresholds:
        case DocumentChange::Library:
        case DocumentChange::Bodies:
            ++revision_;
            schedule();
            break;
        default:
            break;
    }
}

void LiveReading::schedule() {
    if (frameTimer_.isActive()) return;
    double wait = 0.0;
    if (underWay_ != nullptr && sinceRefresh_.isValid()) {
        const double pause =
            std::clamp(lastCostMs_ * kWaitPerCost, static_cast<double>(kFrameMs), kLongestWaitMs);
        wait = std::max(0.0, pause - static_cast<double>(sinceRefresh_.elapsed()));
    }
    frameTimer_.start(static_cast<int>(wait));
}

void LiveReading::refreshNow() {
    frameTimer_.stop();
    // What another thread is reading is taken over by the event that it sent; here it only saves
    // doing the same twice.
    thread_.waitForDone();
    if (busy_) QCoreApplication::sendPostedEvents(this, QEvent::MetaCall);
    again_ = false;
    frameTimer_.stop();
    const bool withStroke = underWay_ != nullptr && !underWay_->samples.empty();
    reading_ = withStroke ? document_.interpretWith(*underWay_, sketchCamera())
                          : document_.interpretation();
    sinceRefresh_.start();
    emit changed();
}

void LiveReading::askNow() {
    frameTimer_.stop();
    refresh();
}

bool LiveReading::upToDate() const {
    return !busy_ && !frameTimer_.isActive() && underWay_ == nullptr;
}

bool LiveReading::mayTakeLong() const {
    return !document_.state().bodies.empty() || lastCostMs_ > kShortMs;
}

void LiveReading::refresh() {
    const bool withStroke = underWay_ != nullptr && !underWay_->samples.empty();
    const bool known = !withStroke && document_.readingKnown();
    if (!known && mayTakeLong() && (withStroke || !document_.pendingStrokes().empty())) {
        startThread();
        return;
    }
    QElapsedTimer cost;
    cost.start();
    reading_ = withStroke ? document_.interpretWith(*underWay_, sketchCamera())
                          : document_.interpretation();
    if (!known) lastCostMs_ = static_cast<double>(cost.nsecsElapsed()) / 1e6;
    sinceRefresh_.start();
    emit changed();
}

void LiveReading::startThread() {
    if (busy_) {
        again_ = true;
        return;
    }
    busy_ = true;
    again_ = false;
    const bool withStroke = underWay_ != nullptr && !underWay_->samples.empty();
    auto task = document_.readingTask(withStroke ? underWay_ : nullptr, sketchCamera());
    thread_.start([this, task = std::move(task), revision = revision_, withStroke] {
        QElapsedTimer cost;
        cost.start();
        auto reading = std::make_shared<Interpretation>(task());
        const double ms = static_cast<double>(cost.nsecsElapsed()) / 1e6;
        QMetaObject::invokeMethod(
            this,
            [this, reading, revision, withStroke, ms] {
                lastCostMs_ = ms;
                take(std::move(*reading), revision, withStroke);
            },
            Qt::QueuedConnection);
    });
}

void LiveReading::take(Interpretation reading, long revision, bool withStroke) {
    busy_ = false;
    // The stroke under way may have grown: its reading of a moment ago is still worth showing. One
    // of strokes that are gone, or of another solid, is not.
    if (revision == revision_) {
        if (!withStroke) document_.keepReading(reading);
        reading_ = std::move(reading);
        sinceRefresh_.start();
        if (again_ || (withStroke && underWay_ == nullptr)) schedule();
        again_ = false;
        emit changed();
        return;
    }
    again_ = false;
    schedule();
}

}  // namespace ew
