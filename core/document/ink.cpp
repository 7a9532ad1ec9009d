// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/ink.h"

#include <algorithm>
#include <limits>
#include <unordered_set>
#include <utility>

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

std::vector<PendingStroke> InkBoard::takeOut(const std::vector<int>& ids) {
    const std::unordered_set<int> gone(ids.begin(), ids.end());
    std::vector<PendingStroke> taken;
    std::vector<PendingStroke> kept;
    for (PendingStroke& s : strokes_) {
        (gone.contains(s.id) ? taken : kept).push_back(std::move(s));
    }
    strokes_ = std::move(kept);
    return taken;
}

void InkBoard::putBack(std::vector<PendingStroke> strokes) {
    const std::unordered_set<int> there = idsOf(strokes_);
    for (PendingStroke& s : strokes) {
        if (!there.contains(s.id)) strokes_.push_back(std::move(s));
    }
    std::sort(strokes_.begin(), strokes_.end(), olderThan);
}

std::optional<int> InkBoard::change(const std::vector<int>& removeIds,
                                    std::vector<std::pair<Stroke, OrthographicCamera>> add) {
    InkChange change;
    change.removed = takeOut(removeIds);
    for (auto& [stroke, camera] : add) {
        change.added.push_back(nextId_);
        strokes_.push_back({nextId_++, std::move(stroke), camera});
    }
    if (change.added.empty() && change.removed.empty()) return std::nullopt;
    change.serial = nextSerial_++;
    done_.push_back(std::move(change));
    undone_.clear();
    return done_.back().serial;
}

void InkBoard::undoLast() {
    InkChange change = std::move(done_.back());
    done_.pop_back();
    change.withdrawn = takeOut(change.added);
    putBack(change.removed);
    undone_.push_back(std::move(change));
}

void InkBoard::redoLast() {
    InkChange change = std::move(undone_.back());
    undone_.pop_back();
    std::vector<int> gone;
    for (const PendingStroke& s : change.removed) gone.push_back(s.id);
    change.removed = takeOut(gone);
    putBack(std::exchange(change.withdrawn, {}));
    done_.push_back(std::move(change));
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

InkHistory InkBoard::takeHistory() { return std::exchange(done_, {}); }

void InkBoard::consume(const std::vector<PendingStroke>& taken, const InkHistory& before,
                       InkHistory after) {
    const std::unordered_set<int> ids = idsOf(taken);
    const auto isTaken = [&](const PendingStroke& s) { return ids.contains(s.id); };
    std::erase_if(strokes_, isTaken);
    std::unordered_set<int> older;
    for (const InkChange& c : before) older.insert(c.serial);
    // What remains may not bring back a stroke that the command has.
    for (InkChange& c : done_) {
        std::erase_if(c.removed, isTaken);
        std::erase_if(c.added, [&](int id) { return ids.contains(id); });
    }
    std::erase_if(done_, [&](const InkChange& c) {
        return older.contains(c.serial) || (c.added.empty() && c.removed.empty());
    });
    undone_ = std::move(after);
}

InkHistory InkBoard::restore(const std::vector<PendingStroke>& returned, const InkHistory& before) {
    putBack(returned);
    done_.insert(done_.begin(), before.begin(), before.end());
    return std::exchange(undone_, {});
}

void InkBoard::reset(Contents contents) {
    strokes_ = std::move(contents.strokes);
    nextId_ = contents.nextId;
    done_ = std::move(contents.done);
    undone_ = std::move(contents.undone);
    nextSerial_ = contents.nextSerial;
}

}  // namespace ew
