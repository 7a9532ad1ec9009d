// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "core/document/document.h"

namespace ew {

class ViewportWidget;

/// Pulling a face by hand or by a typed number: which face is taken, how far it is pulled, the
/// preview, and the step that comes of it. A number that is typed right after a pull corrects it.
class PullController : public QObject {
    Q_OBJECT

  public:
    PullController(Document& document, ViewportWidget& viewport, QObject* parent = nullptr);

    /// Marks the face at a point of the view [px].
    void hover(const Vec2& px);
    /// Takes the face at a point of the view, or none.
    void take(const Vec2& px);
    /// The face follows the pointer along its normal.
    void dragTo(const Vec2& px);
    /// Makes a step of the drag.
    void release();
    /// The drag leaves nothing.
    void cancel();
    /// No face is taken or marked any more: another tool is in use.
    void leave();

    /// Pulls the face that is taken by so much, or the one that was pulled last by so much instead.
    /// [mm]
    void pullBy(double distance);
    void setWalls(PullWalls walls) { walls_ = walls; }

    /// Is there a face that a number would pull?
    bool hasFace() const { return face_.has_value() || pulled_.has_value(); }
    /// Of the drag or of the pull that was made last. [mm]
    double distance() const { return distance_; }
    /// The face that is taken or would be.
    const std::optional<FaceRef>& marked() const { return marked_; }

  signals:
    /// hasFace() or distance().
    void changed();
    void markedChanged();
    void failed(const ew::Error& error);

  private:
    /// A pull that can still be corrected: nothing was done since.
    struct Made {
        PullRequest request;
        int steps = 0;  ///< of the history, with it
    };

    Result<void> carryOut(const PullRequest& request);
    /// Where the face would lie in a plane with another one, a little sooner or later. [mm]
    double snapped(double distance) const;
    void showPreview();
    void mark(const std::optional<FaceRef>& face);

    Document& document_;
    ViewportWidget& viewport_;
    QTimer soon_;  ///< previews follow the pointer once a pass of the event loop
    std::optional<FaceRef> face_;
    std::optional<OutlineOnFace> outline_;  ///< in the face that is taken, round the pointer
    std::optional<FaceRef> marked_;
    std::optional<Made> pulled_;
    PullWalls walls_ = PullWalls::Follow;
    Vec2 start_ = Vec2::Zero();
    double distance_ = 0.0;
    bool dragging_ = false;
    bool working_ = false;  ///< what the document says is this object's own doing
};

}  // namespace ew
