// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTransform>

#include "ui/tools/tool.h"

namespace ew {

/// Draws a stroke. Each sample is only appended; reading and painting follow once a frame.
/// Strokes that continue a drawing are put on the Sketch Plane of that drawing, however it is seen
/// now, so that one drawing never mixes two planes. A click is no stroke: it leaves nothing.
class PenTool : public Tool {
  public:
    explicit PenTool(ToolContext context) : context_(std::move(context)) {}

    void begin(const PenEvent& event) override;
    void update(const PenEvent& event) override;
    void end(const PenEvent& event) override;
    void cancel() override;
    void takeBack() override;

    bool drawing() const { return drawing_; }

  private:
    void append(const PenEvent& event);
    bool isClick() const;
    /// Ends the stroke; false where it leaves no ink.
    bool keep();
    void stop();

    ToolContext context_;
    Stroke inView_;   // as it is shown, px of the view
    Stroke onPlane_;  // as it is kept, px of the Sketch Plane that the drawing is on
    QTransform toPlane_;
    OrthographicCamera plane_;
    double startMs_ = 0.0;
    bool drawing_ = false;
};

}  // namespace ew
