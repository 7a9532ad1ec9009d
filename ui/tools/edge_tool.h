// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/edge_selection.h"
#include "ui/tools/tool.h"

namespace ew {

/// Picks edges by clicks; Shift adds, or takes out what was picked already. A click beside
/// everything picks nothing.
class EdgeTool : public Tool {
  public:
    EdgeTool(ToolContext context, EdgeSelection& selection)
        : context_(std::move(context)), selection_(selection) {}

    void setMode(PickMode mode) { mode_ = mode; }

    void begin(const PenEvent& event) override;
    void update(const PenEvent& event) override;
    void end(const PenEvent& event) override;
    void cancel() override { down_ = false; }

  private:
    ToolContext context_;
    EdgeSelection& selection_;
    PickMode mode_ = PickMode::Edge;
    Vec2 start_ = Vec2::Zero();
    bool down_ = false;
};

}  // namespace ew
