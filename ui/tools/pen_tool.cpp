// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/pen_tool.h"

#include <algorithm>

#include "ui/live_reading.h"
#include "ui/viewport/sketch_plane.h"
#include "ui/viewport/viewport_widget.h"

namespace ew {

namespace {
// A stroke that stays this near to where it began is a click: a hand cannot hold still [px].
constexpr double kClickPx = 3.0;
}  // namespace

void PenTool::begin(const PenEvent& event) {
    plane_ = context_.reading.sketchCamera();
    const auto map = viewToSketch(context_.document.camera(), plane_);
    if (!map) {
        context_.report({Errc::BadValue,
                         "The drawing is seen from its side. Turn the view back to go on with it, "
                         "or apply or clear it first.",
                         {}});
        return;
    }
    toPlane_ = *map;
    inView_.samples.clear();
    onPlane_.samples.clear();
    startMs_ = event.timeMs;
    drawing_ = true;
    append(event);
    context_.viewport.setWetStroke(&inView_);
    context_.reading.follow(&onPlane_);
}

void PenTool::update(const PenEvent& event) {
    if (!drawing_) return;
    if (inView_.samples.size() < kMaxSamplesPerStroke) append(event);
    context_.viewport.setWetStroke(&inView_);
    context_.reading.follow(&onPlane_);
}

void PenTool::end(const PenEvent& event) {
    if (!drawing_) return;
    // The release often repeats the last place with no pressure: it is a place, not a weight.
    PenEvent last = event;
    last.pressure = inView_.samples.back().pressure;
    if (inView_.samples.size() < kMaxSamplesPerStroke) append(last);
    if (keep()) context_.inkDone();
}

void PenTool::takeBack() {
    if (drawing_ && keep()) context_.document.undoInk();
}

bool PenTool::isClick() const {
    const Vec2& start = inView_.samples.front().position;
    return std::all_of(inView_.samples.begin(), inView_.samples.end(),
                       [&](const PenSample& s) { return (s.position - start).norm() <= kClickPx; });
}

bool PenTool::keep() {
    if (isClick()) {
        stop();
        return false;
    }
    Stroke done = std::move(onPlane_);
    stop();
    Document& document = context_.document;
    const OrthographicCamera seen = document.camera();
    const bool elsewhere = !(seen == plane_);
    if (elsewhere) (void)document.setCamera(plane_);
    const auto added = document.addStroke(std::move(done));
    if (elsewhere) (void)document.setCamera(seen);
    if (!added) context_.report(added.error());
    return added.has_value();
}

void PenTool::cancel() {
    if (drawing_) stop();
}

void PenTool::stop() {
    drawing_ = false;
    context_.viewport.setWetStroke(nullptr);
    context_.reading.strokeGone();
    onPlane_ = {};
}

void PenTool::append(const PenEvent& event) {
    PenSample sample;
    sample.position = event.position;
    sample.pressure = event.pressure;
    const double before = inView_.samples.empty() ? 0.0 : inView_.samples.back().timeMs;
    sample.timeMs = std::max(before, event.timeMs - startMs_);
    inView_.samples.push_back(sample);
    sample.position = toVec(toPlane_.map(toPoint(event.position)));
    onPlane_.samples.push_back(sample);
}

}  // namespace ew
