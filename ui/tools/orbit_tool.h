// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/view_tool.h"

namespace ew {

/// Turns the view about the middle of the bodies, or of the viewport where there are none.
class OrbitTool : public ViewTool {
  public:
    using ViewTool::ViewTool;

    void begin(const PenEvent& event) override;

  protected:
    OrthographicCamera moved(const OrthographicCamera& before, const Vec2& by) const override;

  private:
    Vec3 pivot_ = Vec3::Zero();
};

}  // namespace ew
