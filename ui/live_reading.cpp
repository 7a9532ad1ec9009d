// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/live_reading.h"

#include <algorithm>

namespace ew {

namespace {
constexpr int kFrameMs = 16;
constexpr int kSettleMs = 700;
// While drawing, reading may take this share of the time at most: wait (1 / share - 1) times its
// own cost before it is done again.
constexpr double kWaitPerCost = 2.0;
constexpr double kLongestWaitMs = 400.0;
}  // namespace

LiveReading::LiveReading(Document& document, QObject* parent)
    : QObject(parent), document_(document) {
    frameTimer_.setSingleShot(true);
    settleTimer_.setSingleShot(true);
    settleTimer_.setInterval(kSettleMs);
    connect(&frameTimer_, &QTimer::timeout, this, &LiveReading::refresh);
    connect(&settleTimer_, &QTimer::timeout, this, &LiveReading::settleNow);
    connect(&document_, &Document::changed, this, &LiveReading::onDocumentChanged);
    reading_ = document_.interpretation();
}

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
            schedule();
            break;
        case DocumentChange::Reading:
        case DocumentChange::Thresholds:
        case DocumentChange::Library:
        case DocumentChange::Bodies:
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
    refresh();
}

void LiveReading::refresh() {
    // Reading a sketch on a solid takes longer than a frame: it waits for the end of the stroke.
    if (underWay_ != nullptr && !document_.state().bodies.empty()) return;
    QElapsedTimer cost;
    cost.start();
    reading_ = underWay_ != nullptr && !underWay_->samples.empty()
                   ? document_.interpretWith(*underWay_, sketchCamera())
                   : document_.interpretation();
    lastCostMs_ = static_cast<double>(cost.nsecsElapsed()) / 1e6;
    sinceRefresh_.start();
    emit changed();
}

}  // namespace ew
