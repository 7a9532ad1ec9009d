// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/view_tool.h"

#include "ui/viewport/viewport_widget.h"

namespace ew {

void ViewTool::begin(const PenEvent& event) {
    context_.viewport.setMoving(true);
    before_ = context_.document.camera();
    start_ = event.position;
}

void ViewTool::update(const PenEvent& event) {
    (void)context_.document.setCamera(moved(before_, event.position - start_));
}

void ViewTool::end(const PenEvent& event) {
    update(event);
    context_.viewport.setMoving(false);
}

void ViewTool::cancel() {
    (void)context_.document.setCamera(before_);
    context_.viewport.setMoving(false);
}

}  // namespace ew
