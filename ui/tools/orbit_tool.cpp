// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/orbit_tool.h"

#include "ui/viewport/camera_moves.h"

namespace ew {

void OrbitTool::begin(const PenEvent& event) {
    Eigen::AlignedBox3d box;
    for (const Vec3& p : bodyPoints(document().state().bodies)) box.extend(p);
    pivot_ = box.isEmpty() ? document().camera().center : Vec3(box.center());
    ViewTool::begin(event);
}

OrthographicCamera OrbitTool::moved(const OrthographicCamera& before, const Vec2& by) const {
    return orbitCamera(before, by, pivot_);
}

}  // namespace ew
