// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/tool.h"

namespace ew {

/// Moves the view: what is under the pointer stays under it.
class PanTool : public Tool {
  public:
    explicit PanTool(ToolContext context) : context_(std::move(context)) {}

    void begin(const PenEvent& event) override;
    void update(const PenEvent& event) override;
    void end(const PenEvent& event) override;
    void cancel() override;

  private:
    ToolContext context_;
    OrthographicCamera before_;
    Vec2 start_ = Vec2::Zero();
};

}  // namespace ew
