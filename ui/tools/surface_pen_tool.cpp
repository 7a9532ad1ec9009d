// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/surface_pen_tool.h"

#include <algorithm>

#include "ui/viewport/viewport_widget.h"

namespace ew {

void SurfacePenTool::begin(const PenEvent& event) {
    const Document& document = context_.document;
    if (document.state().bodies.empty()) {
        context_.report({Errc::NoSolid, "There is no solid to draw on yet.", {}});
        return;
    }
    // The stroke would take the drawing along.
    if (!document.pendingStrokes().empty()) {
        context_.report({Errc::OperationImpossible,
                         "A drawing is not applied yet. Apply it, clear it, or map it onto the "
                         "surface first.",
                         {}});
        return;
    }
    stroke_.samples.clear();
    startMs_ = event.timeMs;
    drawing_ = true;
    append(event);
    context_.viewport.setWetStroke(&stroke_);
}

void SurfacePenTool::update(const PenEvent& event) {
    if (!drawing_) return;
    if (stroke_.samples.size() < kMaxSamplesPerStroke) append(event);
    context_.viewport.setWetStroke(&stroke_);
}

void SurfacePenTool::end(const PenEvent& event) {
    if (!drawing_) return;
    PenEvent last = event;
    last.pressure = stroke_.samples.back().pressure;  // the release often has none
    if (stroke_.samples.size() < kMaxSamplesPerStroke) append(last);
    Stroke done = stroke_;
    cancel();
    Document& document = context_.document;
    if (auto added = document.addStroke(std::move(done)); !added) {
        context_.report(added.error());
        return;
    }
    if (auto mapped = document.mapStrokes(color_); !mapped) {
        document.withdrawInk();
        context_.report(mapped.error());
    }
}

void SurfacePenTool::cancel() {
    drawing_ = false;
    context_.viewport.setWetStroke(nullptr);
}

void SurfacePenTool::append(const PenEvent& event) {
    PenSample sample;
    sample.position = event.position;
    sample.pressure = event.pressure;
    const double before = stroke_.samples.empty() ? 0.0 : stroke_.samples.back().timeMs;
    sample.timeMs = std::max(before, event.timeMs - startMs_);
    stroke_.samples.push_back(sample);
}

}  // namespace ew
