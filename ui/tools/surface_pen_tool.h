// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/tool.h"

namespace ew {

/// Draws straight onto the surface: every stroke is mapped when the pen is lifted, one step of the
/// history each. A stroke with no surface under it leaves nothing.
class SurfacePenTool : public Tool {
  public:
    explicit SurfacePenTool(ToolContext context) : context_(std::move(context)) {}

    void setColor(const StrokeColor& color) { color_ = color; }

    void begin(const PenEvent& event) override;
    void update(const PenEvent& event) override;
    void end(const PenEvent& event) override;
    void cancel() override;

  private:
    void append(const PenEvent& event);

    ToolContext context_;
    StrokeColor color_ = kDefaultStrokeColor;
    Stroke stroke_;  // px of the view, which is the Sketch Plane here
    double startMs_ = 0.0;
    bool drawing_ = false;
};

}  // namespace ew
