// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>

#include "ui/edge_selection.h"
#include "ui/tools/tool.h"

namespace ew {

class EdgeTool;
class InputArbiter;
class PullController;
class PullTool;
class SurfacePenTool;

/// Gives each gesture to its tool: the active one for the pen tip and the left button, the others
/// as the gesture's intent says.
class ToolBox : public QObject {
    Q_OBJECT

  public:
    enum class Kind { Pen, Eraser, Orbit, Pan, PickEdge, SurfacePen, Pull };

    /// Watches the viewport of the context, which outlives this.
    /// \param selection  what picking edges fills; outlives this.
    /// \param pull  what pulling faces goes through; outlives this.
    ToolBox(const ToolContext& context, EdgeSelection& selection, PullController& pull,
            QObject* parent = nullptr);
    ~ToolBox() override;

    Kind active() const { return active_; }
    void setActive(Kind kind);
    void setPickMode(PickMode mode);
    void setStrokeColor(const StrokeColor& color);
    /// True between begin and end of any gesture.
    bool gestureUnderWay() const { return current_ != nullptr; }
    /// Escape: the gesture under way leaves nothing. False where there was none.
    bool cancelGesture();
    /// Undo while a gesture is under way: it ends, and only it is taken back; redo brings its ink
    /// back. False where there was none.
    bool takeGestureBack();

  signals:
    void activeChanged(ew::ToolBox::Kind kind);
    /// gestureUnderWay().
    void gestureChanged();

  private:
    void pointer(const PenEvent& event);
    void begin(const PenEvent& event);
    void hover(const PenEvent& event);
    void zoom(const Vec2& position, double factor);
    void pan(const Vec2& delta);
    Tool* toolFor(PenIntent intent);
    Tool* tool(Kind kind);

    ToolContext context_;
    std::unique_ptr<Tool> pen_;
    std::unique_ptr<Tool> eraser_;
    std::unique_ptr<Tool> orbit_;
    std::unique_ptr<Tool> pan_;
    std::unique_ptr<EdgeTool> pickEdge_;
    std::unique_ptr<SurfacePenTool> surfacePen_;
    PullController& pullController_;
    std::unique_ptr<PullTool> pull_;
    InputArbiter* arbiter_;  // child of the viewport
    Kind active_ = Kind::Pen;
    Tool* current_ = nullptr;
    bool takingBack_ = false;
};

}  // namespace ew
