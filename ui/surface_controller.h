// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "core/document/document.h"
#include "ui/edge_selection.h"

namespace ew {

class ViewportWidget;

/// Surface settings by hand: what a drag would give is derived by a worker and shown while it goes
/// on; letting go makes it one step of the history. The window never waits for a shape: of several
/// wishes only the newest is carried out, and a result that is no longer wanted is dropped.
/// Where a machine cannot derive and draw the surface as often as a drag wants it, a coarser one is
/// shown while the radius moves, at last the filleted cage alone, and the whole one as soon as it
/// rests.
class SurfaceController : public QObject {
    Q_OBJECT

  public:
    SurfaceController(Document& document, ViewportWidget& viewport, QObject* parent = nullptr);
    ~SurfaceController() override;

    EdgeSelection& selection() { return selection_; }

    /// Shows what a fillet of the chosen edges would be.
    void previewFillet(double radius, int segments);
    /// Makes it a step. A step of the same edges just before is replaced.
    void commitFillet(double radius, int segments);
    void sharpen();
    void crease(double sharpness);

    void previewSubdivision(const SubdivisionSettings& settings);
    void commitSubdivision(const SubdivisionSettings& settings);
    /// On as it was set last, or off.
    void setSmooth(bool on);
    const SubdivisionSettings& lastSubdivision() const { return lastSubdivision_; }

    void mapStrokes();
    void unmapStrokes();
    const StrokeColor& strokeColor() const { return strokeColor_; }
    void setStrokeColor(const StrokeColor& color);

    /// True while a shape is being derived that will be a step.
    bool busy() const { return commit_ != nullptr; }
    /// Edges that are clamped in what is shown now.
    const std::vector<ClampedEdge>& clamped() const { return clamped_; }
    /// Longest time that a step of a drag may take before the next one is shown coarser [ms].
    void setStepBudget(double ms) { stepBudgetMs_ = ms; }
    /// True from when a shape is to be shown until it is seen.
    bool waitsForFrame() const { return unseen_.has_value(); }
    /// Waits for the worker and carries out what it was for; for pictures and tests.
    void settle();

  signals:
    /// Clamped edges, busy() or the problem changed.
    void changed();
    void colorChanged(const ew::StrokeColor& color);
    void failed(const ew::Error& error);
    void noticed(const QString& text);

  private:
    using Commit = std::function<Result<void>()>;
    /// What is to be derived.
    struct Wish {
        ShapeInput input;
        std::optional<int> coarser;  ///< set for a step of a drag: levels that are left out
    };
    /// What came of it, and how long it took.
    struct Derived {
        std::shared_ptr<const DerivedShape> shape;
        std::optional<int> coarser;
        double ms = 0.0;
    };
    /// Derives the shape of these settings and shows it, then runs `commit` where there is one.
    void derive(SurfaceSettings settings, Commit commit, std::optional<int> coarser = {});
    void start();
    void finish(const Derived& derived);
    void show(const Derived& derived);
    void onFrameShown();
    void run(const Commit& commit);
    /// Carries out what was asked for without waiting for the worker.
    void flush();
    void onDocumentChanged(DocumentChange what);
    Result<SurfaceSettings> withFillet(double radius, int segments) const;

    Document& document_;
    ViewportWidget& viewport_;
    EdgeSelection selection_;
    SubdivisionSettings lastSubdivision_;
    StrokeColor strokeColor_ = kDefaultStrokeColor;
    std::vector<ClampedEdge> clamped_;

    QThreadPool pool_;
    std::optional<Wish> wanted_;      // the newest wish, not begun
    std::unique_ptr<Commit> commit_;  // what the newest wish is for
    bool running_ = false;
    bool stale_ = false;  // what the worker makes is no longer wanted

    std::optional<SurfaceSettings> drag_;  // the newest step of a drag, in full
    int coarser_ = 0;                      // levels that are left out while dragging
    double stepBudgetMs_;
    std::optional<Derived> unseen_;  // given to the viewport, not drawn yet
    QElapsedTimer sinceShown_;
    QTimer rest_;  // until the whole surface is shown
};

}  // namespace ew
