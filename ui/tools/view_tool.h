// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/tool.h"

namespace ew {

/// Moves the camera from where it was when the gesture began.
class ViewTool : public Tool {
  public:
    explicit ViewTool(ToolContext context) : context_(std::move(context)) {}

    void begin(const PenEvent& event) override;
    void update(const PenEvent& event) override;
    void end(const PenEvent& event) override;
    void cancel() override;

  protected:
    const Document& document() const { return context_.document; }
    /// Where the camera is after a move by so many px of the viewport.
    virtual OrthographicCamera moved(const OrthographicCamera& before, const Vec2& by) const = 0;

  private:
    ToolContext context_;
    OrthographicCamera before_;
    Vec2 start_ = Vec2::Zero();
};

}  // namespace ew
