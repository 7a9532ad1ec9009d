// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/edge_tool.h"

#include <QGuiApplication>

namespace ew {

namespace {
constexpr double kClickPx = 6.0;  // a pointer that moves farther is no click
}

void EdgeTool::begin(const PenEvent& event) {
    start_ = event.position;
    down_ = true;
}

void EdgeTool::update(const PenEvent& event) {
    if ((event.position - start_).norm() > kClickPx) down_ = false;
}

void EdgeTool::end(const PenEvent& event) {
    update(event);
    if (!down_) return;
    down_ = false;
    const Document& document = context_.document;
    const bool add = QGuiApplication::keyboardModifiers().testFlag(Qt::ShiftModifier);
    const auto edges = edgesAt(document.state().bodies, document.camera(), start_, mode_);
    if (edges.empty() && add) return;
    selection_.pick(edges, add);
}

}  // namespace ew
