// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool_box.h"

#include "ui/input/input_arbiter.h"
#include "ui/live_reading.h"
#include "ui/tools/edge_tool.h"
#include "ui/tools/eraser_tool.h"
#include "ui/tools/orbit_tool.h"
#include "ui/tools/pan_tool.h"
#include "ui/tools/pen_tool.h"
#include "ui/tools/pull_tool.h"
#include "ui/tools/surface_pen_tool.h"
#include "ui/viewport/camera_moves.h"
#include "ui/viewport/viewport_widget.h"

namespace ew {

ToolBox::ToolBox(const ToolContext& context, EdgeSelection& selection, PullController& pull,
                 QObject* parent)
    : QObject(parent),
      context_(context),
      pen_(std::make_unique<PenTool>(context)),
      eraser_(std::make_unique<EraserTool>(context)),
      orbit_(std::make_unique<OrbitTool>(context)),
      pan_(std::make_unique<PanTool>(context)),
      pickEdge_(std::make_unique<EdgeTool>(context, selection)),
      surfacePen_(std::make_unique<SurfacePenTool>(context)),
      pullController_(pull),
      pull_(std::make_unique<PullTool>(pull)) {
    InputArbiter::Sink sink;
    sink.pointer = [this](const PenEvent& event) { pointer(event); };
    sink.zoom = [this](const Vec2& position, double factor) { zoom(position, factor); };
    sink.pan = [this](const Vec2& delta) { pan(delta); };
    arbiter_ = new InputArbiter(&context.viewport, std::move(sink));
}

ToolBox::~ToolBox() { delete arbiter_; }

void ToolBox::setActive(Kind kind) {
    if (kind == active_) return;
    cancelGesture();
    if (active_ == Kind::Pull) pullController_.leave();
    active_ = kind;
    context_.viewport.setHover(std::nullopt);
    switch (kind) {
        case Kind::Pen:
        case Kind::Eraser:
        case Kind::SurfacePen:
            context_.viewport.setCursor(Qt::CrossCursor);
            break;
        case Kind::PickEdge:
        case Kind::Pull:
            context_.viewport.setCursor(Qt::PointingHandCursor);
            break;
        case Kind::Orbit:
            context_.viewport.setCursor(Qt::SizeAllCursor);
            break;
        case Kind::Pan:
            context_.viewport.setCursor(Qt::OpenHandCursor);
            break;
    }
    emit activeChanged(kind);
}

void ToolBox::setPickMode(PickMode mode) { pickEdge_->setMode(mode); }

void ToolBox::setStrokeColor(const StrokeColor& color) { surfacePen_->setColor(color); }

bool ToolBox::cancelGesture() {
    if (current_ == nullptr) return false;
    arbiter_->cancel();
    return true;
}

bool ToolBox::takeGestureBack() {
    takingBack_ = true;
    const bool done = cancelGesture();
    takingBack_ = false;
    return done;
}

Tool* ToolBox::tool(Kind kind) {
    switch (kind) {
        case Kind::Eraser:
            return eraser_.get();
        case Kind::Orbit:
            return orbit_.get();
        case Kind::Pan:
            return pan_.get();
        case Kind::PickEdge:
            return pickEdge_.get();
        case Kind::SurfacePen:
            return surfacePen_.get();
        case Kind::Pull:
            return pull_.get();
        case Kind::Pen:
            break;
    }
    return pen_.get();
}

Tool* ToolBox::toolFor(PenIntent intent) {
    switch (intent) {
        case PenIntent::Erase:
            return eraser_.get();
        case PenIntent::Orbit:
            return orbit_.get();
        case PenIntent::Pan:
            return pan_.get();
        case PenIntent::Tool:
            break;
    }
    return tool(active_);
}

void ToolBox::pointer(const PenEvent& event) {
    switch (event.phase) {
        case PenPhase::Hover:
        case PenPhase::Leave:
            hover(event);
            return;
        case PenPhase::Begin:
            begin(event);
            return;
        case PenPhase::Update:
            if (current_ != nullptr) current_->update(event);
            hover(event);
            return;
        case PenPhase::End:
            // A pen that is lifted and held still tells nothing more.
            hover(event);
            // Over before the tool acts on it: what it does may look at gestureUnderWay().
            if (Tool* tool = std::exchange(current_, nullptr)) tool->end(event);
            emit gestureChanged();
            return;
        case PenPhase::Cancel:
            if (Tool* tool = std::exchange(current_, nullptr)) {
                if (takingBack_) {
                    tool->takeBack();
                } else {
                    tool->cancel();
                }
            }
            emit gestureChanged();
            return;
    }
}

void ToolBox::begin(const PenEvent& event) {
    current_ = toolFor(event.intent);
    current_->begin(event);
    emit gestureChanged();
}

void ToolBox::hover(const PenEvent& event) {
    if (event.phase == PenPhase::Hover) context_.reading.penMoved();
    if (event.phase == PenPhase::Hover && active_ == Kind::Pull) pull_->hover(event.position);
    const bool erases = event.intent == PenIntent::Erase || active_ == Kind::Eraser;
    const bool shown = event.phase != PenPhase::Leave && (erases || active_ == Kind::Pen);
    context_.viewport.setHover(shown ? std::optional<Vec2>(event.position) : std::nullopt, erases);
}

void ToolBox::zoom(const Vec2& position, double factor) {
    if (current_ != nullptr) return;
    (void)context_.document.setCamera(zoomCamera(context_.document.camera(), position, factor));
}

void ToolBox::pan(const Vec2& delta) {
    if (current_ != nullptr) return;
    (void)context_.document.setCamera(panCamera(context_.document.camera(), delta));
}

}  // namespace ew
