// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <optional>

#include "core/document/document.h"

namespace ew {

/// The reading of the ink as the window shows it: of the pending strokes, and of the stroke under
/// way too. It is made at most once a frame by a coalescing timer, never by the pen handler; if
/// one reading takes long, the next one waits as much longer. What may take longer than a frame, as
/// on a solid, is read on another thread, and dropped when the document has changed meanwhile.
class LiveReading : public QObject {
    Q_OBJECT

  public:
    explicit LiveReading(Document& document, QObject* parent = nullptr);
    ~LiveReading() override;

    const Interpretation& reading() const { return reading_; }
    /// The camera whose Sketch Plane px the reading speaks in: that of the newest pending stroke,
    /// else the document's.
    const OrthographicCamera& sketchCamera() const;

    /// A stroke is under way, in Sketch Plane px of sketchCamera(). Called for every sample: only
    /// asks for a reading at the next frame. The stroke must live until strokeGone().
    void follow(const Stroke* underWay);
    void strokeGone();
    bool strokeUnderWay() const { return underWay_ != nullptr; }

    /// False until the pen rests, and for a first stroke that is no drawing yet: what is unfinished
    /// is not criticised.
    bool settled() const { return settled_ && !justBegun(); }
    /// One stroke that encloses nothing.
    bool justBegun() const;
    void settleNow();
    /// The pen moves above the sheet: it does not rest.
    void penMoved();

    /// What the person chose among the candidates; -1 where nothing was chosen by hand.
    int chosen() const { return chosen_; }
    /// The chosen candidate, else the accepted one, else the best; -1 where there is none.
    int current() const;
    void choose(int candidate);

    /// Brings the reading up to date at once, however long it takes.
    void refreshNow();
    /// Asks for a reading without waiting for the next frame; changed() follows, at once where it
    /// is quick.
    void askNow();
    /// Does reading() speak of all strokes as they are now? Otherwise changed() follows.
    bool upToDate() const;

  signals:
    /// The reading, what is chosen, or whether it is settled.
    void changed();

  private:
    void onDocumentChanged(DocumentChange what);
    void schedule();
    void refresh();
    bool mayTakeLong() const;
    void startThread();
    void take(Interpretation reading, long revision, bool withStroke);

    Document& document_;
    Interpretation reading_;
    const Stroke* underWay_ = nullptr;
    bool settled_ = true;
    int chosen_ = -1;
    double lastCostMs_ = 0.0;
    QTimer frameTimer_;
    QTimer settleTimer_;
    QElapsedTimer sinceRefresh_;

    long revision_ = 0;  ///< counts what makes a reading stale
    bool busy_ = false;
    bool again_ = false;
    QThreadPool thread_;  ///< one
};

}  // namespace ew
