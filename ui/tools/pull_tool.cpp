// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/pull_tool.h"

namespace ew {

namespace {
constexpr double kClickPx = 5.0;  // a pointer that moves less is a click
}

void PullTool::begin(const PenEvent& event) {
    start_ = event.position;
    moved_ = false;
    pull_.take(event.position);
}

void PullTool::update(const PenEvent& event) {
    moved_ = moved_ || (event.position - start_).norm() > kClickPx;
    if (moved_) pull_.dragTo(event.position);
}

void PullTool::end(const PenEvent& event) {
    update(event);
    if (moved_) pull_.release();
}

void PullTool::cancel() { pull_.cancel(); }

}  // namespace ew
