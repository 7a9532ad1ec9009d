// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/document/document.h"

namespace ew {

/// The pending strokes with their own small history. A change removes and adds strokes in one go;
/// undoLast() takes the newest one back. Order is the order of drawing, which is the order of ids.
class InkBoard {
  public:
    const std::vector<PendingStroke>& strokes() const { return strokes_; }
    bool canUndo() const { return !history_.empty(); }
    int nextId() const { return nextId_; }

    /// One change: removes strokes by id (unknown ids are ignored), then adds strokes at the end.
    /// \return its serial, for undoLast(), or nothing where it changed nothing.
    std::optional<int> change(const std::vector<int>& removeIds,
                              std::vector<std::pair<Stroke, OrthographicCamera>> add);
    /// Takes back the newest change; returns its serial, or nothing.
    std::optional<int> undoLast();
    void clearHistory() { history_.clear(); }

    /// Index of the stroke nearest to a point within `reachPx`, the newest of equally near ones.
    std::optional<std::size_t> nearest(const Vec2& px, double reachPx) const;

    /// A command took these strokes, or gives them back; both end the history.
    void consume(const std::vector<PendingStroke>& taken);
    void restore(const std::vector<PendingStroke>& returned);

    /// Replaces everything (a document was opened).
    void reset(std::vector<PendingStroke> strokes, int nextId);

  private:
    struct Change {
        int serial = 0;
        std::vector<int> added;
        std::vector<PendingStroke> removed;
    };

    std::vector<PendingStroke> strokes_;
    std::vector<Change> history_;
    int nextId_ = 0;
    int nextSerial_ = 0;
};

/// Distance of a point to the polyline of a stroke [px].
double distanceToStroke(const Vec2& px, const Stroke& stroke);

}  // namespace ew
