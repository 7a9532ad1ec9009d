// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QUndoCommand>
#include <QUndoStack>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/document/ink.h"
#include "core/document/level.h"
#include "core/document/recorder.h"
#include "core/document/store.h"

namespace ew {

inline constexpr double kDefaultObliqueFactor = 0.5;

/// A stroke as a script step.
StrokeStep strokeStep(const Stroke& stroke);

/// What an apply was made from, so that another of its readings can take its place.
struct ApplyMemory {
    ApplyRequest request;
    ApplyOutcome outcome;
    Thresholds thresholds;
    double appliedFactor = kDefaultObliqueFactor;  ///< k of the solid that was made
    double readFactor = kDefaultObliqueFactor;     ///< k of outcome.interpretation
    std::vector<int> strokeIds;                    ///< of the strokes that it was read from
    OrthographicCamera seen;                       ///< the camera that they were read through
    Motion moved;                                  ///< of the view, to set it level
};

class StateCommand;

struct Document::Private {
    Private(Document& document, TemplateLibrary shippedLibrary, Interpreter reader);

    Document& q;
    Interpreter interpreter;
    TemplateLibrary shipped;
    std::shared_ptr<const DocumentState> state;
    InkBoard ink;
    ViewSettings view;
    bool automaticDistance = true;  ///< the distance threshold follows the pending strokes
    double obliqueFactor = kDefaultObliqueFactor;
    QUndoStack stack;
    Recorder recorder;
    QString path;
    std::optional<FileStamp> fileStamp;  ///< of the file as this document knows it

    // Modified: `revision` counts what a file would keep.
    long revision = 0;
    long savedRevision = 0;
    long firstRevision = 0;  ///< when its life began
    long life = 0;

    // The newest reading of the pending strokes, for one request.
    mutable std::optional<Interpretation> reading;
    mutable ApplyRequest readingRequest;

    // What follows from the state, for the state that it was derived from.
    std::shared_ptr<ShapeCache> cache = std::make_shared<ShapeCache>();
    std::size_t memoryLimit = ShapeInput{}.memoryLimit;
    mutable std::shared_ptr<const DocumentState> shapeOf;
    mutable std::shared_ptr<const DerivedShape> shape;

    /// Which steps of the history changed since the last update() for a working copy.
    struct {
        int first = 0;
        int end = 0;  ///< one past the last
    } newSteps;
    int writtenStrokes = 0;  ///< strokes with smaller ids were in an update before
    std::string thumbnail;   ///< PNG, or nothing
    std::string firstName;   ///< of the state before the first step
    /// What replaceHistory() replaced, while `revision` is this one.
    std::shared_ptr<const DocumentFile> replaced;
    long replacedAt = -1;

    // While Document itself moves the stack, its signal is not taken for the history panel's.
    bool movingStack = false;
    int stackIndex = 0;

    void emitChange(DocumentChange what) { emit q.changed(what); }
    void touch();
    /// After the pending strokes changed.
    void inkChanged();
    /// Where the distance threshold is automatic: the one that suits the pending strokes.
    void suitDistance();
    void record(ScriptStep step, int inkSerial = Recorder::kNoInk);
    /// Removes and adds strokes as one ink change, recorded as steps that do the same.
    bool editInk(const std::vector<int>& removeIds,
                 std::vector<std::pair<Stroke, OrthographicCamera>> add);

    Interpretation read(const std::vector<PendingStroke>& strokes, const ApplyRequest& request,
                        const std::vector<Body>& bodies) const;
    /// The same on copies.
    std::function<Interpretation()> task(const std::vector<PendingStroke>& strokes,
                                         const ApplyRequest& request,
                                         const std::vector<Body>& bodies) const;
    /// Pushes a command that leads to `after` and takes `consumed` away.
    /// \param name  in English, one that shownStepName() knows; so in Change.
    void push(const QString& name, std::shared_ptr<const DocumentState> after,
              std::vector<PendingStroke> consumed, std::shared_ptr<ApplyMemory> memory = nullptr);
    /// Pushes a change of surface settings.
    /// \param key  what it changes; where `replace` is set and the newest command has the same key,
    ///     that one is undone first. A change that changes nothing is dropped. Errors:
    ///     DerivedShape::problem of the state that it would lead to.
    struct Change {
        QString name;
        std::string key;
        bool replace = false;
        ScriptStep step;
    };
    Result<void> pushSettings(const Change& change, SurfaceSettings settings);
    /// The chosen edges, with their mirror images where they were picked one by one.
    Result<std::vector<EdgeRef>> edgesOnBothSides(const EdgeChoice& choice) const;
    std::shared_ptr<const DerivedShape> derive(const DocumentState& of) const;
    void onStackMoved(int index);
    void stateChanged(const DocumentState& before);
    void adopt(DocumentFile file);
    /// Another document comes: surfaces of this one are large, and none of its own.
    void forgetShapes();
    /// A step was pushed, done or undone.
    void stepChanged(int place);
    /// What a file needs to hold what changed since the last takeUpdate(), or all of it.
    DocumentUpdate update(bool whole) const;
    StoredCommand stored(const StateCommand& command) const;
};

/// One step of the history: exchanges two snapshots of the document and the ink it consumed.
class StateCommand : public QUndoCommand {
  public:
    StateCommand(Document::Private& document, const QString& name,
                 std::shared_ptr<const DocumentState> before,
                 std::shared_ptr<const DocumentState> after);

    void undo() override;
    void redo() override;

    QString english;         ///< name, see shownStepName()
    int place = 0;           ///< in the stack
    std::string templateId;  ///< that an apply used
    std::shared_ptr<const DocumentState> before, after;
    std::vector<PendingStroke> consumed;
    InkHistory inkBefore;  ///< changes of the ink between the command before and this one
    InkHistory inkAfter;   ///< while undone: what could be done again after it
    std::shared_ptr<ApplyMemory> memory;  ///< of an apply, where it is known
    std::string key;                      ///< of a change of settings: what it changes
    /// That a person gave to the state after it. The stack gives commands out as constant, and
    /// names are no part of what undo exchanges.
    mutable std::string stateName;

  private:
    Document::Private& document_;
};

}  // namespace ew
