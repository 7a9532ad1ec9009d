// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "core/document/document.h"

namespace ew {

/// A change of the pending strokes, which removed and added some in one go.
struct InkChange {
    int serial = 0;
    std::vector<int> added;  ///< ids
    std::vector<PendingStroke> removed;
    std::vector<PendingStroke> withdrawn;  ///< what it added, while it is taken back
};
/// Oldest first.
using InkHistory = std::vector<InkChange>;

/// The pending strokes and the line of time of their changes since the newest command. A command
/// takes what is before it along (takeHistory) and gives it back when it is undone (restore), so
/// that ink and commands are undone in the order in which they were made. Order of strokes is the
/// order of drawing, which is the order of ids.
class InkBoard {
  public:
    const std::vector<PendingStroke>& strokes() const { return strokes_; }
    int nextId() const { return nextId_; }

    /// One change: removes strokes by id (unknown ids are ignored), then adds strokes at the end.
    /// \return its serial, for undoLast(), or nothing where it changed nothing.
    std::optional<int> change(const std::vector<int>& removeIds,
                              std::vector<std::pair<Stroke, OrthographicCamera>> add);
    /// Takes back the newest change.
    /// \pre newest()
    void undoLast();
    /// Does again what undoLast() took back last, with the same ids.
    /// \pre newestUndone()
    void redoLast();
    /// What undoLast() would take back and what redoLast() would do again; null where there is
    /// nothing.
    const InkChange* newest() const { return done_.empty() ? nullptr : &done_.back(); }
    const InkChange* newestUndone() const { return undone_.empty() ? nullptr : &undone_.back(); }
    /// What undoLast() took back last cannot be done again.
    /// \pre newestUndone()
    void forgetUndone() { undone_.pop_back(); }

    /// Index of the stroke nearest to a point within `reachPx`, the newest of equally near ones.
    std::optional<std::size_t> nearest(const Vec2& px, double reachPx) const;

    /// A command comes: the changes up to it, which are its own from now on.
    InkHistory takeHistory();
    /// A command is done: it takes strokes. Changes that were made before it stay out of the line
    /// of time; those made beside it (after it was undone, say) stay in it.
    /// \param before  what takeHistory() gave.
    /// \param after  changes that can be done again now.
    void consume(const std::vector<PendingStroke>& taken, const InkHistory& before,
                 InkHistory after);
    /// A command is undone: it gives its strokes and the changes before it back. Changes made after
    /// it stay, newest.
    /// \return what could be done again after the command.
    InkHistory restore(const std::vector<PendingStroke>& returned, const InkHistory& before);

    /// All changes that can be taken back, and those that can be done again (the last one first).
    const InkHistory& done() const { return done_; }
    const InkHistory& undone() const { return undone_; }
    /// Greater than every serial.
    int nextSerial() const { return nextSerial_; }

    /// Replaces everything (a document was opened).
    struct Contents {
        std::vector<PendingStroke> strokes;
        int nextId = 0;
        InkHistory done, undone;
        int nextSerial = 0;
    };
    void reset(Contents contents);

  private:
    std::vector<PendingStroke> takeOut(const std::vector<int>& ids);
    void putBack(std::vector<PendingStroke> strokes);

    std::vector<PendingStroke> strokes_;
    InkHistory done_;
    InkHistory undone_;  // the last one is done again first
    int nextId_ = 0;
    int nextSerial_ = 0;
};

/// Distance of a point to the polyline of a stroke [px].
double distanceToStroke(const Vec2& px, const Stroke& stroke);

}  // namespace ew
