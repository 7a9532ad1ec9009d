// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/orbit_tool.h"

#include "ui/viewport/camera_moves.h"
#include "ui/viewport/viewport_widget.h"

namespace ew {

void OrbitTool::begin(const PenEvent& event) {
    context_.viewport.setMoving(true);
    before_ = context_.document.camera();
    start_ = event.position;
    Eigen::AlignedBox3d box;
    for (const Vec3& p : bodyPoints(context_.document.state().bodies)) box.extend(p);
    pivot_ = box.isEmpty() ? before_.center : Vec3(box.center());
}

void OrbitTool::update(const PenEvent& event) {
    (void)context_.document.setCamera(orbitCamera(before_, event.position - start_, pivot_));
}

void OrbitTool::end(const PenEvent& event) {
    update(event);
    context_.viewport.setMoving(false);
}

void OrbitTool::cancel() {
    (void)context_.document.setCamera(before_);
    context_.viewport.setMoving(false);
}

}  // namespace ew
