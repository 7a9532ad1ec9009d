// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/document/document.h"

namespace ew {

struct ReplayOptions {
    QString scriptFolder;  ///< `open` is relative to it
    QString outFolder;     ///< `save` and `export` are relative to it; made when the first file is
                           ///< written. What was saved there is opened again from there
    bool keepGoing = false;      ///< go on after a step that failed
    bool leaveOutFiles = false;  ///< steps that write or open a file are left out
    bool allowOutside = false;   ///< these steps may name files outside their folders
    /// Files that save steps of this replay wrote.
    std::shared_ptr<std::set<QString>> saved = std::make_shared<std::set<QString>>();
};

/// What one step did.
struct StepReport {
    int index = 0;     ///< in the script, from 0
    std::string name;  ///< the "do" word
    bool ok = true;
    bool leftOut = false;  ///< not done: ReplayOptions::leaveOutFiles
    double ms = 0.0;
    std::optional<Error> error;                    ///< set where ok is not
    std::optional<Interpretation> interpretation;  ///< of an apply: what was read
    int chosen = -1;                               ///< of an apply that succeeded: which candidate
    std::vector<std::string> notes;                ///< sentences, e.g. which edges were clamped
};

struct ReplayReport {
    std::vector<StepReport> steps;  ///< those that ran
    double msTotal = 0.0;

    /// The first step that failed, or nullptr.
    const StepReport* firstFailure() const;
};

/// Empties the document and sets what the head of the script says (viewport, thresholds).
Result<void> beginReplay(Document& document, const SketchScript& script);

/// Runs one step. A step that fails leaves the document as it was.
/// Paths that are absolute or lead out of their folder are Errc::BadValue, unless allowed.
StepReport runStep(Document& document, const ScriptStep& step, int index,
                   const ReplayOptions& options);

/// beginReplay, then every step in order, up to the first that fails (or all: keepGoing).
/// \param onStep  told of every step that ran; replay stops where it returns false. May be empty.
ReplayReport replay(Document& document, const SketchScript& script, const ReplayOptions& options,
                    const std::function<bool(const StepReport&)>& onStep = {});

/// The index of a step that is named by its index ("12"), or by its "do" word and which of that
/// word it is, counted from 1 ("apply:3"; "fillet" is "fillet:1"). As an index, one past the last
/// step is taken too. Errors: BadValue where the script has no such step.
Result<std::size_t> findStep(const SketchScript& script, const std::string& name);

/// The file that a step writes or opens; nothing for any other step.
std::optional<std::string> fileOfStep(const ScriptStep& step);

/// A relative path inside a folder, as an absolute one. Errc::BadValue where it leads out of it, by
/// its text or by a symbolic link; the folder may be one itself.
Result<QString> pathInside(const QString& folder, const QString& path);

}  // namespace ew
