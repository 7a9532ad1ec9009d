// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/view_tool.h"

namespace ew {

/// Moves the view: what is under the pointer stays under it.
class PanTool : public ViewTool {
  public:
    using ViewTool::ViewTool;

  protected:
    OrthographicCamera moved(const OrthographicCamera& before, const Vec2& by) const override;
};

}  // namespace ew
