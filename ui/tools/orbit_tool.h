// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/tool.h"

namespace ew {

/// Turns the view about the middle of the bodies, or of the viewport where there are none.
class OrbitTool : public Tool {
  public:
    explicit OrbitTool(ToolContext context) : context_(std::move(context)) {}

    void begin(const PenEvent& event) override;
    void update(const PenEvent& event) override;
    void end(const PenEvent& event) override;
    void cancel() override;

  private:
    ToolContext context_;
    OrthographicCamera before_;
    Vec3 pivot_ = Vec3::Zero();
    Vec2 start_ = Vec2::Zero();
};

}  // namespace ew
