// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/pan_tool.h"

#include "ui/viewport/camera_moves.h"

namespace ew {

OrthographicCamera PanTool::moved(const OrthographicCamera& before, const Vec2& by) const {
    return panCamera(before, by);
}

}  // namespace ew
