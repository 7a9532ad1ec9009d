// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/base/camera.h"
#include "core/document/sketch_script.h"

namespace ew {

/// What the camera and the thresholds were when something was done.
struct ViewSettings {
    OrthographicCamera camera;
    Thresholds thresholds;
};

/// Writes down what was done, as a sketch script. Cameras and thresholds are noted with every step
/// and turned into steps of their own only where they matter: a camera where the next stroke or
/// command comes, thresholds where the next command or erasing comes.
class Recorder {
  public:
    static constexpr int kNoInk = -1;

    /// \param inkSerial  the InkBoard change that the step belongs to, kNoInk for a command.
    void record(ScriptStep step, const ViewSettings& view, int inkSerial = kNoInk);
    /// Takes back all steps of an ink change. False, and nothing happens, where there are none or a
    /// command came after them.
    bool dropInk(int inkSerial);
    /// Writes down again what dropInk() took back; false where it took back nothing.
    bool putInkBack(int inkSerial);
    /// How many steps an ink change has; in a script each is a change of its own.
    int inkSteps(int inkSerial) const;
    struct Entry {
        ScriptStep step;
        ViewSettings view;
        int inkSerial = kNoInk;
    };
    const std::vector<Entry>& entries() const { return entries_; }
    /// The steps of ink changes that were taken back, by serial.
    const std::map<int, std::vector<Entry>>& takenBack() const { return dropped_; }
    const std::string& title() const { return title_; }
    void setTitle(const std::string& title) { title_ = title; }

    /// What changed since forgetNews(): entries from `firstEntry` on, and what is taken back of
    /// some ink changes.
    struct News {
        std::size_t firstEntry = 0;
        std::set<int> takenBack;  ///< serials
    };
    const News& news() const { return news_; }
    void forgetNews() { news_ = {entries_.size(), {}}; }

    /// Everything so far, ending with the view as it is now.
    SketchScript script(const ViewSettings& now) const;

    /// The recorder that had written this script.
    static Recorder fromScript(const SketchScript& script);
    /// One that goes on where another one stopped.
    static Recorder resumed(std::string title, std::vector<Entry> entries,
                            std::map<int, std::vector<Entry>> takenBack);

  private:
    std::vector<Entry> entries_;
    std::map<int, std::vector<Entry>> dropped_;  // by ink serial
    std::string title_;
    News news_;
};

/// The camera after a camera step (direction normalised unless it is a unit vector already), before
/// any check.
OrthographicCamera withStep(OrthographicCamera camera, const CameraStep& step);
/// The step that leads from one camera to another; only what differs is set.
CameraStep cameraStep(const OrthographicCamera& from, const OrthographicCamera& to);
Thresholds withStep(Thresholds thresholds, const ThresholdsStep& step);

}  // namespace ew
