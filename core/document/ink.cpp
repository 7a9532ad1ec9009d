// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/ink.h"

#include <algorithm>
#include <limits>
#include <unordered_set>

namespace ew {

namespace {

std::unordered_set<int> idsOf(const std::vector<PendingStroke>& strokes) {
    std::unordered_set<int> ids;
    for (const PendingStroke& s : strokes) ids.insert(s.id);
    return ids;
}

bool olderThan(const PendingStroke& a, const PendingStroke& b) { return a.id < b.id; }

}  // namespace

double distanceToStroke(const Vec2& px, const Stroke& stroke) {
    double best = std::numeric_limits<double>::infinity();
    const auto& samples = stroke.samples;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Vec2& next = samples[std::min(i + 1, samples.size() - 1)].position;
        best = std::min(best, distanceToSegment(px, samples[i].position, next));
    }
    return best;
}

std::optional<int> InkBoard::change(const std::vector<int>& removeIds,
                                    std::vector<std::pair<Stroke, OrthographicCamera>> add) {
    Change change;
    const std::unordered_set<int> gone(removeIds.begin(), removeIds.end());
    std::vector<PendingStroke> kept;
    for (PendingStroke& s : strokes_) {
        (gone.contains(s.id) ? change.removed : kept).push_back(std::move(s));
    }
    strokes_ = std::move(kept);
    for (auto& [stroke, camera] : add) {
        change.added.push_back(nextId_);
        strokes_.push_back({nextId_++, std::move(stroke), camera});
    }
    if (change.added.empty() && change.removed.empty()) return std::nullopt;
    change.serial = nextSerial_++;
    history_.push_back(std::move(change));
    return history_.back().serial;
}

std::optional<int> InkBoard::undoLast() {
    if (history_.empty()) return std::nullopt;
    Change change = std::move(history_.back());
    history_.pop_back();
    std::erase_if(strokes_, [&](const PendingStroke& s) {
        return std::find(change.added.begin(), change.added.end(), s.id) != change.added.end();
    });
    for (PendingStroke& s : change.removed) strokes_.push_back(std::move(s));
    std::sort(strokes_.begin(), strokes_.end(), olderThan);
    return change.serial;
}

std::optional<std::size_t> InkBoard::nearest(const Vec2& px, double reachPx) const {
    std::optional<std::size_t> found;
    double best = reachPx;
    for (std::size_t i = 0; i < strokes_.size(); ++i) {
        const double d = distanceToStroke(px, strokes_[i].stroke);
        if (d <= best) {
            best = d;
            found = i;
        }
    }
    return found;
}

void InkBoard::consume(const std::vector<PendingStroke>& taken) {
    const std::unordered_set<int> ids = idsOf(taken);
    std::erase_if(strokes_, [&](const PendingStroke& s) { return ids.contains(s.id); });
    clearHistory();
}

void InkBoard::restore(const std::vector<PendingStroke>& returned) {
    const std::unordered_set<int> there = idsOf(strokes_);
    for (const PendingStroke& s : returned) {
        if (!there.contains(s.id)) strokes_.push_back(s);
    }
    std::sort(strokes_.begin(), strokes_.end(), olderThan);
    clearHistory();
}

void InkBoard::reset(std::vector<PendingStroke> strokes, int nextId) {
    strokes_ = std::move(strokes);
    nextId_ = nextId;
    clearHistory();
}

}  // namespace ew
