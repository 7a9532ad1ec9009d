// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>

#include "core/document/document.h"

namespace ew {

class LiveReading;

/// Turns what was read into a solid: by Enter, by choosing, or by itself when the best reading is
/// clear and nobody draws. After a solid was made, the other readings stay one key away until the
/// next stroke.
class ApplyController : public QObject {
    Q_OBJECT

  public:
    ApplyController(Document& document, LiveReading& reading, QObject* parent = nullptr);

    /// What the candidates panel shows: the reading of the ink, or, with no ink, of the newest
    /// solid.
    const Interpretation& shown() const;
    /// The candidate of shown() that is chosen or applied, -1 where there is none.
    int shownCurrent() const;
    /// True where shown() speaks of a solid that was made.
    bool showsApplied() const;

    /// Enter: the chosen candidate, else the best. Also says why where there is none.
    void apply();
    /// Makes a solid of a candidate of the ink's reading; -1: of the accepted one.
    void take(int candidate);
    /// Chooses a candidate of shown(); of an applied reading, the solid is replaced at once.
    void pick(int candidate);
    /// k of the oblique reading; an applied oblique solid follows when `done`.
    void setObliqueFactor(double k, bool done);

    bool automatic() const { return automatic_; }
    void setAutomatic(bool on);
    /// ApplyRequest::level of what is applied from now on.
    bool level() const { return level_; }
    void setLevel(bool on) { level_ = on; }
    /// Automatic waits while this says true (a panel is being used).
    void setBusyTest(std::function<bool()> busy) { busy_ = std::move(busy); }
    /// The pen is up after it changed the ink: the wait begins.
    void inkDone();
    /// Stops the wait.
    void hold();
    /// Between inkDone() and applying by itself, also while a panel in use holds it.
    bool waiting() const { return look_.isActive(); }
    /// The wait runs out unless something happens: false while it is held.
    bool countingDown() const { return countdown_.isActive(); }

    /// From pen-up to applying by itself [ms].
    static constexpr int kWaitMs = 900;

  signals:
    /// What shown() or shownCurrent() says.
    void changed();
    void automaticChanged(bool on);
    /// countingDown().
    void countdownChanged(bool running);
    void applied(const ew::ApplyOutcome& outcome);
    void failed(const ew::Error& error);

  private:
    void beginWait();
    void look();
    void stopCountdown();
    void onCountdownOver();
    void onReadingChanged();
    bool clear() const;

    Document& document_;
    LiveReading& reading_;
    QTimer countdown_;
    QTimer look_;                 ///< runs through the whole wait
    bool awaitsReading_ = false;  ///< the wait begins when the ink was read
    std::function<bool()> busy_;
    bool automatic_ = true;
    bool level_ = true;
};

}  // namespace ew
