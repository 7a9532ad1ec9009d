// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/tool.h"

namespace ew {

/// Removes the pending strokes that it passes over, each as a whole.
class EraserTool : public Tool {
  public:
    explicit EraserTool(ToolContext context) : context_(std::move(context)) {}

    void begin(const PenEvent& event) override;
    void update(const PenEvent& event) override;
    void end(const PenEvent& event) override;
    /// Brings back what this gesture erased.
    void cancel() override;

  private:
    void eraseAt(const Vec2& position);

    ToolContext context_;
    int erased_ = 0;  // in this gesture
};

}  // namespace ew
