// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/pull_controller.h"
#include "ui/tools/tool.h"

namespace ew {

/// Takes a face and pulls it along its normal. A click only takes it, so that a number can be
/// typed.
class PullTool : public Tool {
  public:
    explicit PullTool(PullController& pull) : pull_(pull) {}

    void begin(const PenEvent& event) override;
    void update(const PenEvent& event) override;
    void end(const PenEvent& event) override;
    void cancel() override;
    /// The face that would be taken is marked.
    void hover(const Vec2& position) { pull_.hover(position); }

  private:
    PullController& pull_;
    Vec2 start_ = Vec2::Zero();
    bool moved_ = false;
};

}  // namespace ew
