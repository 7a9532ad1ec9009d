// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/eraser_tool.h"

#include "ui/live_reading.h"
#include "ui/viewport/sketch_plane.h"

namespace ew {

void EraserTool::begin(const PenEvent& event) {
    erased_ = 0;
    eraseAt(event.position);
}

void EraserTool::update(const PenEvent& event) { eraseAt(event.position); }

void EraserTool::end(const PenEvent&) {
    if (erased_ > 0) context_.inkDone();
}

void EraserTool::cancel() {
    for (; erased_ > 0; --erased_) context_.document.withdrawInk();
}

void EraserTool::eraseAt(const Vec2& position) {
    Document& document = context_.document;
    if (document.pendingStrokes().empty()) return;
    // The document counts in px of the drawing's own Sketch Plane.
    const auto map = viewToSketch(document.camera(), context_.reading.sketchCamera());
    if (!map) return;
    if (document.eraseAt(toVec(map->map(toPoint(position))))) ++erased_;
}

}  // namespace ew
