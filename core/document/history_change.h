// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/document/recorder.h"
#include "core/document/store.h"

namespace ew {

/// Most bytes of a state's name.
inline constexpr std::size_t kMaxStateName = 200;

/// A step of the history as the script has it, with the view and the thresholds of that time.
struct RecordedStep {
    ScriptStep step;
    ViewSettings view;
};

/// What each step of a history was recorded as. Nothing for steps that were merged, or are from a
/// document whose script does not reach that far back. O(entries).
std::vector<std::optional<RecordedStep>> recordedSteps(const DocumentFile& file);

/// A step in the middle of the history as it shall be instead.
struct StepChange {
    int place = 0;                         ///< of the step, from 0
    ScriptStep step;                       ///< a step of the same kind
    std::optional<Thresholds> thresholds;  ///< for it and no other; not set: as they were
};

/// A step that could not be done again.
struct MisfitStep {
    int place = 0;     ///< in the history before
    std::string name;  ///< in English, as StoredCommand has it
    Error error;
    int strokes = 0;  ///< that it had used; they are among the pending ones now
};

struct HistoryChange {
    DocumentFile file;  ///< with the new history
    int redone = 0;     ///< steps after the changed one that were done again
    std::vector<MisfitStep> misfits;
};

/// Changes a step and does again what follows. A step that does not fit any more is left out and
/// named, and the strokes that it had used are kept as pending ones. The new history is at its
/// newest step, also where some were undone. The document that the file is of stays as it is. Cost:
/// that of replaying the steps from there on. \param goOn  told how many steps are done and how
/// many there are; false gives up. May be empty. Errors: BadValue for a step that is not there, was
/// merged, or is of another kind; Cancelled; and what keeps the changed step itself from being
/// done.
Result<HistoryChange> changeStep(const DocumentFile& file, const TemplateLibrary& shipped,
                                 const StepChange& change,
                                 const std::function<bool(int done, int all)>& goOn = {});

/// What the drawing of an apply step in the history may be read as with these thresholds.
/// \param factor  k of the oblique reading.
/// Errors: BadValue for a step that is no apply.
Result<Interpretation> readingsOfStep(const DocumentFile& file, const TemplateLibrary& shipped,
                                      int place, const Thresholds& thresholds, double factor);

/// The same document with only the named states and the one of now in its history; the steps
/// between them are merged, and those that were undone are gone.
DocumentFile compacted(DocumentFile file);

}  // namespace ew
