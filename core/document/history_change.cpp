// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/history_change.h"

#include <QUndoStack>
#include <algorithm>
#include <map>
#include <set>

#include "core/document/document.h"
#include "core/document/replay.h"

namespace ew {

namespace {

/// The history as a script leads to it: which entry made each step.
class ScriptHistory {
  public:
    explicit ScriptHistory(const std::vector<Recorder::Entry>& entries) {
        for (std::size_t i = 0; i < entries.size(); ++i) {
            if (entries[i].inkSerial == Recorder::kNoInk) follow(entries[i].step, i);
        }
    }
    /// Entries by place in the history; -1: several steps were merged into it.
    const std::vector<long>& steps() const { return steps_; }
    std::size_t index() const { return index_; }

  private:
    void follow(const ScriptStep& step, std::size_t entry) {
        if (const auto* undo = std::get_if<UndoStep>(&step)) {
            if (!undo->ink) move(-undo->count);
        } else if (const auto* redo = std::get_if<RedoStep>(&step)) {
            if (!redo->ink) move(redo->count);
        } else if (const auto* name = std::get_if<NameStep>(&step)) {
            names_[name->state ? static_cast<std::size_t>(*name->state) : index_] = name->name;
        } else if (std::holds_alternative<CompactStep>(step)) {
            compact();
        } else if (isCommand(step)) {
            steps_.resize(index_);
            names_.erase(names_.upper_bound(index_), names_.end());
            steps_.push_back(static_cast<long>(entry));
            ++index_;
        }
    }
    static bool isCommand(const ScriptStep& step) {
        return std::holds_alternative<ApplyStep>(step) ||
               std::holds_alternative<FilletStep>(step) ||
               std::holds_alternative<SharpenStep>(step) ||
               std::holds_alternative<CreaseStep>(step) ||
               std::holds_alternative<SubdivideStep>(step) ||
               std::holds_alternative<MapStrokesStep>(step) ||
               std::holds_alternative<UnmapStrokesStep>(step) ||
               std::holds_alternative<DefineTemplateStep>(step) ||
               std::holds_alternative<DeleteSolidStep>(step);
    }
    void move(int by) {
        const long to = static_cast<long>(index_) + by;
        index_ = static_cast<std::size_t>(std::clamp(to, 0L, static_cast<long>(steps_.size())));
    }
    void compact() {
        std::vector<long> kept;
        std::map<std::size_t, std::string> names;
        if (names_.contains(0)) names[0] = names_[0];
        std::size_t from = 0;
        for (std::size_t state = 1; state <= index_; ++state) {
            const bool named = names_.contains(state) && !names_[state].empty();
            if (!named && state != index_) continue;
            kept.push_back(state == from + 1 ? steps_[from] : -1);
            if (named) names[kept.size()] = names_[state];
            from = state;
        }
        steps_ = std::move(kept);
        names_ = std::move(names);
        index_ = steps_.size();
    }

    std::vector<long> steps_;
    std::map<std::size_t, std::string> names_;  // by steps that are done
    std::size_t index_ = 0;
};

std::set<int> idsOf(const std::vector<PendingStroke>& strokes) {
    std::set<int> ids;
    for (const PendingStroke& s : strokes) ids.insert(s.id);
    return ids;
}

Unexpected<Error> noSuchStep() {
    return fail(Errc::BadValue, "There is no such step in the history.");
}

/// Does the steps of a history again in another document, from one of them on.
class HistoryReplay {
  public:
    HistoryReplay(const DocumentFile& file, const TemplateLibrary& shipped)
        : file_(file), recorded_(recordedSteps(file)), old_(shipped), new_(shipped) {
        old_.restore(file, {});
        new_.restore(file, {});
    }
    Result<HistoryChange> run(const StepChange& change, const std::function<bool(int, int)>& goOn) {
        auto step = changedStep(change);
        if (!step) return fail(step.error());
        const int count = static_cast<int>(file_.commands.size());
        if (auto ok = collectInk(change.place); !ok) return fail(ok.error());
        if (auto ok = new_.goToStep(change.place); !ok) return fail(ok.error());
        HistoryChange out;
        for (int place = change.place; place < count; ++place) {
            const bool isChanged = place == change.place;
            if (goOn && !goOn(place - change.place, count - change.place)) {
                return fail(Errc::Cancelled, "Changing the step was given up.");
            }
            const auto& recorded = isChanged ? *step : recorded_[static_cast<std::size_t>(place)];
            auto ok = redo(place, recorded);
            if (!ok && isChanged) return fail(ok.error());
            if (ok && !isChanged) ++out.redone;
            if (!ok) out.misfits.push_back(misfit(place, ok.error()));
        }
        finish();
        out.file = new_.contents();
        return out;
    }

  private:
    Result<std::optional<RecordedStep>> changedStep(const StepChange& change) const {
        const auto place = static_cast<std::size_t>(change.place);
        if (change.place < 0 || place >= recorded_.size()) return noSuchStep();
        std::optional<RecordedStep> step = recorded_[place];
        if (!step) {
            return fail(Errc::BadValue, "How this step was made is not known any more.");
        }
        if (step->step.index() != change.step.index()) {
            return fail(Errc::BadValue, "A step can only become another step of its kind.");
        }
        step->step = change.step;
        if (change.thresholds) step->view.thresholds = *change.thresholds;
        return step;
    }
    /// What was drawn when each step came, and in the end.
    Result<void> collectInk(int from) {
        const int count = static_cast<int>(file_.commands.size());
        inkBefore_.resize(static_cast<std::size_t>(count) + 1);
        if (file_.index < count) {
            if (auto ok = old_.goToStep(count); !ok) return ok;
        }
        for (int place = count; place >= from; --place) {
            if (place < count) {
                if (auto ok = old_.goToStep(place); !ok) return ok;
            }
            inkBefore_[static_cast<std::size_t>(place)] = old_.pendingStrokes();
        }
        return {};
    }
    Result<void> redo(int place, const std::optional<RecordedStep>& recorded) {
        if (!recorded) {
            return fail(Errc::BadValue, "How this step was made is not known any more.");
        }
        lay(inkBefore_[static_cast<std::size_t>(place)]);
        if (auto ok = new_.setCamera(recorded->view.camera); !ok) return ok;
        if (auto ok = new_.setThresholds(recorded->view.thresholds); !ok) return ok;
        const std::set<int> before = idsOf(new_.pendingStrokes());
        const StepReport report = runStep(new_, recorded->step, place, {});
        if (!report.ok) return fail(*report.error);
        const std::set<int> after = idsOf(new_.pendingStrokes());
        std::erase_if(newIds_, [&](const auto& pair) {
            const bool used = before.contains(pair.second) && !after.contains(pair.second);
            if (used) used_.insert(pair.first);
            return used;
        });
        keepUnused(place);
        const auto name = file_.names.find(place + 1);
        if (name != file_.names.end()) {
            static_cast<void>(new_.nameState(new_.undoStack().index(), name->second));
        }
        return {};
    }
    /// Makes these the pending strokes of the new document, but for those that it has used already.
    void lay(const std::vector<PendingStroke>& wanted) {
        if (!begun_) {
            // It is the same document up to here, so its strokes have the same ids.
            for (const PendingStroke& s : new_.pendingStrokes()) newIds_[s.id] = s.id;
            begun_ = true;
        }
        const std::set<int> ids = idsOf(wanted);
        std::vector<int> away;
        std::erase_if(newIds_, [&](const auto& pair) {
            if (ids.contains(pair.first)) return false;
            away.push_back(pair.second);
            return true;
        });
        new_.removeStrokes(away);
        for (const PendingStroke& s : wanted) add(s);
    }
    void add(const PendingStroke& s) {
        if (newIds_.contains(s.id) || used_.contains(s.id)) return;
        static_cast<void>(new_.setCamera(s.camera));
        if (const auto id = new_.addStroke(s.stroke)) newIds_[s.id] = *id;
    }
    MisfitStep misfit(int place, const Error& error) {
        const StoredCommand& command = file_.commands[static_cast<std::size_t>(place)];
        return {place, command.name, error, keepUnused(place)};
    }
    /// Strokes that a step had used and does not use any more are among the last ones.
    /// \return how many.
    int keepUnused(int place) {
        const auto& its = file_.commands[static_cast<std::size_t>(place)].consumed;
        int count = 0;
        for (const PendingStroke& s : file_.strokes) {
            if (used_.contains(s.id) || !std::binary_search(its.begin(), its.end(), s.id)) continue;
            kept_.push_back(s);
            ++count;
        }
        return count;
    }
    /// The ink of the end, and that of what did not fit, which nothing shall be lost of.
    void finish() {
        std::vector<PendingStroke> last = inkBefore_.back();
        last.insert(last.end(), kept_.begin(), kept_.end());
        lay(last);
        static_cast<void>(new_.setCamera(file_.view.camera));
        static_cast<void>(new_.setThresholds(file_.view.thresholds));
        new_.setAutomaticDistance(file_.automaticDistance);
        new_.setObliqueFactor(file_.obliqueFactor);
    }

    const DocumentFile& file_;
    std::vector<std::optional<RecordedStep>> recorded_;
    Document old_, new_;
    std::vector<std::vector<PendingStroke>> inkBefore_;  // by place; the last one: in the end
    std::vector<PendingStroke> kept_;
    std::map<int, int> newIds_;  // ids of pending strokes: before, and in the new document
    std::set<int> used_;         // ids of before
    bool begun_ = false;
};

}  // namespace

std::vector<std::optional<RecordedStep>> recordedSteps(const DocumentFile& file) {
    const ScriptHistory history(file.script);
    std::vector<std::optional<RecordedStep>> out(file.commands.size());
    // Both are where they are now, so they are laid over each other there: the script of a document
    // of an earlier version may begin later than its history.
    const long offset = static_cast<long>(history.index()) - file.index;
    for (std::size_t place = 0; place < out.size(); ++place) {
        const long at = static_cast<long>(place) + offset;
        if (at < 0 || at >= static_cast<long>(history.steps().size())) continue;
        const long entry = history.steps()[static_cast<std::size_t>(at)];
        if (entry < 0) continue;
        const Recorder::Entry& found = file.script[static_cast<std::size_t>(entry)];
        out[place] = RecordedStep{found.step, found.view};
    }
    return out;
}

Result<HistoryChange> changeStep(const DocumentFile& file, const TemplateLibrary& shipped,
                                 const StepChange& change,
                                 const std::function<bool(int, int)>& goOn) {
    return HistoryReplay(file, shipped).run(change, goOn);
}

Result<Interpretation> readingsOfStep(const DocumentFile& file, const TemplateLibrary& shipped,
                                      int place, const Thresholds& thresholds, double factor) {
    const auto recorded = recordedSteps(file);
    if (place < 0 || static_cast<std::size_t>(place) >= recorded.size()) return noSuchStep();
    const auto& step = recorded[static_cast<std::size_t>(place)];
    const auto* apply = step ? std::get_if<ApplyStep>(&step->step) : nullptr;
    if (apply == nullptr) return fail(Errc::BadValue, "This step read no drawing.");
    Document document(shipped);
    document.restore(file, {});
    if (auto ok = document.goToStep(place); !ok) return fail(ok.error());
    if (auto ok = document.setCamera(step->view.camera); !ok) return fail(ok.error());
    if (auto ok = document.setThresholds(thresholds); !ok) return fail(ok.error());
    return document.interpretationFor({std::nullopt, apply->templateId, apply->operation, factor});
}

DocumentFile compacted(DocumentFile file) {
    std::vector<StoredCommand> kept;
    std::map<int, std::string> names;
    if (file.names.contains(0)) names[0] = file.names.at(0);
    int from = 0;
    for (int state = 1; state <= file.index; ++state) {
        const bool named = file.names.contains(state);
        if (!named && state != file.index) continue;
        StoredCommand command = std::move(file.commands[static_cast<std::size_t>(state) - 1]);
        if (state > from + 1) {
            command.consumed.clear();
            command.inkBefore.clear();
            command.key.clear();
        }
        command.inkAfter.clear();
        kept.push_back(std::move(command));
        if (named) names[static_cast<int>(kept.size())] = file.names.at(state);
        from = state;
    }
    file.commands = std::move(kept);
    file.names = std::move(names);
    file.index = static_cast<int>(file.commands.size());
    return file;
}

}  // namespace ew
