// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/pan_tool.h"

#include "ui/viewport/camera_moves.h"
#include "ui/viewport/viewport_widget.h"

namespace ew {

void PanTool::begin(const PenEvent& event) {
    context_.viewport.setMoving(true);
    before_ = context_.document.camera();
    start_ = event.position;
}

void PanTool::update(const PenEvent& event) {
    (void)context_.document.setCamera(panCamera(before_, event.position - start_));
}

void PanTool::end(const PenEvent& event) {
    update(event);
    context_.viewport.setMoving(false);
}

void PanTool::cancel() {
    (void)context_.document.setCamera(before_);
    context_.viewport.setMoving(false);
}

}  // namespace ew
