// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/recorder.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/base/tolerance.h"

namespace ew {

namespace {

bool usesThresholds(const ScriptStep& step) {
    // A stroke is stored raw and clearing takes all, whatever the thresholds are.
    return !std::holds_alternative<StrokeStep>(step) && !std::holds_alternative<ClearStep>(step) &&
           !std::holds_alternative<NameStep>(step) && !std::holds_alternative<CompactStep>(step);
}

ThresholdsStep thresholdsStep(const Thresholds& from, const Thresholds& to) {
    ThresholdsStep step;
    if (from.distancePx != to.distancePx) step.distancePx = to.distancePx;
    if (from.angleDeg != to.angleDeg) step.angleDeg = to.angleDeg;
    return step;
}

}  // namespace

void Recorder::record(ScriptStep step, const ViewSettings& view, int inkSerial) {
    entries_.push_back({std::move(step), view, inkSerial});
}

int Recorder::inkSteps(int inkSerial) const {
    return static_cast<int>(std::count_if(entries_.begin(), entries_.end(), [&](const Entry& e) {
        return e.inkSerial == inkSerial;
    }));
}

bool Recorder::dropInk(int inkSerial) {
    const auto first = std::find_if(entries_.begin(), entries_.end(),
                                    [&](const Entry& e) { return e.inkSerial == inkSerial; });
    const bool commandAfter =
        std::any_of(first, entries_.end(), [](const Entry& e) { return e.inkSerial == kNoInk; });
    if (first == entries_.end() || commandAfter) return false;
    std::vector<Entry>& taken = dropped_[inkSerial];
    const auto rest = std::stable_partition(
        first, entries_.end(), [&](const Entry& e) { return e.inkSerial != inkSerial; });
    taken.assign(std::make_move_iterator(rest), std::make_move_iterator(entries_.end()));
    entries_.erase(rest, entries_.end());
    news_.firstEntry =
        std::min(news_.firstEntry, static_cast<std::size_t>(first - entries_.begin()));
    news_.takenBack.insert(inkSerial);
    return true;
}

bool Recorder::putInkBack(int inkSerial) {
    const auto found = dropped_.find(inkSerial);
    if (found == dropped_.end()) return false;
    for (Entry& e : found->second) entries_.push_back(std::move(e));
    dropped_.erase(found);
    news_.takenBack.insert(inkSerial);
    return true;
}

SketchScript Recorder::script(const ViewSettings& now) const {
    SketchScript out;
    out.title = title_;
    // The file's head says the first viewport and the first thresholds that matter.
    const OrthographicCamera& first = entries_.empty() ? now.camera : entries_.front().view.camera;
    out.viewport = {first.width, first.height};
    const auto needs = std::find_if(entries_.begin(), entries_.end(),
                                    [](const Entry& e) { return usesThresholds(e.step); });
    out.thresholds = needs == entries_.end() ? now.thresholds : needs->view.thresholds;
    out.namesDistance = true;

    ViewSettings told;
    told.camera.width = first.width;
    told.camera.height = first.height;
    told.thresholds = out.thresholds;
    const auto tellCamera = [&](const OrthographicCamera& camera) {
        if (camera == told.camera) return;
        out.steps.emplace_back(cameraStep(told.camera, camera));
        told.camera = camera;
    };
    const auto tellThresholds = [&](const Thresholds& thresholds) {
        if (thresholds == told.thresholds) return;
        out.steps.emplace_back(thresholdsStep(told.thresholds, thresholds));
        told.thresholds = thresholds;
    };
    for (const Entry& e : entries_) {
        tellCamera(e.view.camera);
        if (usesThresholds(e.step)) tellThresholds(e.view.thresholds);
        out.steps.push_back(e.step);
    }
    tellCamera(now.camera);
    tellThresholds(now.thresholds);
    return out;
}

Recorder Recorder::fromScript(const SketchScript& script) {
    Recorder recorder;
    recorder.title_ = script.title;
    ViewSettings view;
    view.camera.width = script.viewport[0];
    view.camera.height = script.viewport[1];
    view.thresholds = script.thresholds;
    for (const ScriptStep& step : script.steps) {
        if (const auto* camera = std::get_if<CameraStep>(&step)) {
            view.camera = withStep(view.camera, *camera);
        } else if (const auto* thresholds = std::get_if<ThresholdsStep>(&step)) {
            view.thresholds = withStep(view.thresholds, *thresholds);
        } else {
            recorder.record(step, view);
        }
    }
    return recorder;
}

Recorder Recorder::resumed(std::string title, std::vector<Entry> entries,
                           std::map<int, std::vector<Entry>> takenBack) {
    Recorder recorder;
    recorder.title_ = std::move(title);
    recorder.entries_ = std::move(entries);
    recorder.dropped_ = std::move(takenBack);
    return recorder;
}

OrthographicCamera withStep(OrthographicCamera camera, const CameraStep& step) {
    if (step.direction) {
        const double length = step.direction->norm();
        camera.direction = *step.direction;
        if (std::abs(length - 1.0) > tol::kUnitLength) camera.direction /= length;
    }
    if (step.up) camera.up = *step.up;
    if (step.center) camera.center = *step.center;
    if (step.worldPerPixel) camera.worldPerPixel = *step.worldPerPixel;
    if (step.viewport) {
        camera.width = step.viewport->x();
        camera.height = step.viewport->y();
    }
    return camera;
}

CameraStep cameraStep(const OrthographicCamera& from, const OrthographicCamera& to) {
    CameraStep step;
    if (from.direction != to.direction) step.direction = to.direction;
    if (from.up != to.up) step.up = to.up;
    if (from.center != to.center) step.center = to.center;
    if (from.worldPerPixel != to.worldPerPixel) step.worldPerPixel = to.worldPerPixel;
    if (from.width != to.width || from.height != to.height) {
        step.viewport = Vec2(to.width, to.height);
    }
    return step;
}

Thresholds withStep(Thresholds thresholds, const ThresholdsStep& step) {
    thresholds.distancePx = step.distancePx.value_or(thresholds.distancePx);
    thresholds.angleDeg = step.angleDeg.value_or(thresholds.angleDeg);
    return thresholds;
}

}  // namespace ew
