// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <unordered_set>

#include "core/document/document.h"
#include "core/document/document_private.h"
#include "core/document/export_mesh.h"
#include "core/document/file_names.h"
#include "core/document/store.h"
#include "core/stroke/suited_distance.h"

namespace ew {

namespace {

/// In the order of drawing.
std::vector<PendingStroke> merged(std::vector<PendingStroke> a,
                                  const std::vector<PendingStroke>& b) {
    a.insert(a.end(), b.begin(), b.end());
    std::sort(a.begin(), a.end(),
              [](const PendingStroke& x, const PendingStroke& y) { return x.id < y.id; });
    return a;
}

/// What a command left of the ink that was drawn before it and since the command before.
/// \param later  strokes that are pending now or were used later, by id.
std::vector<PendingStroke> leftBy(const StateCommand& command,
                                  const std::map<int, const PendingStroke*>& later) {
    std::unordered_set<int> used;
    for (const PendingStroke& p : command.consumed) used.insert(p.id);
    std::vector<PendingStroke> left;
    for (const InkChange& change : command.inkBefore) {
        for (const int id : change.added) {
            const auto found = later.find(id);
            if (found != later.end() && !used.contains(id)) left.push_back(*found->second);
        }
    }
    return merged(std::move(left), {});
}

}  // namespace

void Document::Private::adopt(DocumentFile file) {
    movingStack = true;
    stack.clear();
    std::vector<PendingStroke> waiting = file.pending;
    std::unordered_set<int> drawn;
    // Pushing runs each command, which leads through the states from first to last.
    state = file.states.front();
    for (std::size_t i = 0; i < file.commands.size(); ++i) {
        auto* command = new StateCommand(*this, QString::fromStdString(file.commands[i].name),
                                         file.states[i], file.states[i + 1]);
        command->consumed = std::move(file.commands[i].consumed);
        // Each stroke was drawn before the first step that used it or left it.
        const auto known = [&](const PendingStroke& p) { return drawn.contains(p.id); };
        std::vector<PendingStroke> before = merged(command->consumed, file.commands[i].left);
        std::erase_if(before, known);
        for (const PendingStroke& p : before) drawn.insert(p.id);
        if (static_cast<int>(i) < file.index) std::erase_if(waiting, known);
        command->inkBefore = ink.drawn(before);
        stack.push(command);
    }
    stack.setIndex(file.index);
    movingStack = false;
    stackIndex = file.index;
    stack.setClean();

    state = file.states[static_cast<std::size_t>(file.index)];
    ink.reset(std::move(file.pending), file.nextStrokeId, ink.drawn(waiting));
    view = {file.camera, file.thresholds};
    // What the strokes would have told was most likely told by them.
    std::vector<Stroke> strokes;
    for (const PendingStroke& s : ink.strokes()) strokes.push_back(s.stroke);
    automaticDistance = view.thresholds.distancePx == suitedDistancePx(strokes);
    obliqueFactor = file.obliqueFactor;
    recorder = Recorder::fromScript(file.script);
    reading.reset();
    savedRevision = ++revision;
    for (const DocumentChange what :
         {DocumentChange::Library, DocumentChange::Thresholds, DocumentChange::Camera,
          DocumentChange::Bodies, DocumentChange::Shape, DocumentChange::Ink,
          DocumentChange::Reading, DocumentChange::History, DocumentChange::File}) {
        emitChange(what);
    }
}

Result<void> Document::save(const QString& wanted) {
    const auto path = documentFileName(wanted);
    if (!path) return fail(path.error());
    DocumentFile file;
    const QUndoStack& stack = d_->stack;
    for (int i = 0; i < stack.count(); ++i) {
        const auto* command = static_cast<const StateCommand*>(stack.command(i));
        file.states.push_back(command->before);
        file.commands.push_back({command->english.toStdString(), command->consumed});
        if (i + 1 == stack.count()) file.states.push_back(command->after);
    }
    std::map<int, const PendingStroke*> later;
    const auto note = [&](const std::vector<PendingStroke>& strokes) {
        for (const PendingStroke& p : strokes) later[p.id] = &p;
    };
    note(d_->ink.strokes());
    for (int i = stack.count(); i-- > 0;) {
        const auto* command = static_cast<const StateCommand*>(stack.command(i));
        file.commands[static_cast<std::size_t>(i)].left = leftBy(*command, later);
        note(command->consumed);
    }
    if (file.states.empty()) file.states.push_back(d_->state);
    file.index = d_->stackIndex;
    file.pending = d_->ink.strokes();
    file.nextStrokeId = d_->ink.nextId();
    file.camera = d_->view.camera;
    file.thresholds = d_->view.thresholds;
    file.obliqueFactor = d_->obliqueFactor;
    file.script = recordedScript();
    if (auto ok = saveDocument(file, *path); !ok) return ok;
    d_->path = *path;
    d_->fileStamp = fileStamp(*path);
    d_->savedRevision = d_->revision;
    d_->stack.setClean();
    d_->emitChange(DocumentChange::File);
    return {};
}

Result<void> Document::open(const QString& path) {
    // Before it is read: what is written meanwhile counts as a change.
    const auto stamp = fileStamp(path);
    auto file = loadDocument(path, d_->shipped);
    if (!file) return fail(file.error());
    d_->path = path;
    d_->fileStamp = stamp;
    d_->adopt(*std::move(file));
    return {};
}

void Document::reset() {
    DocumentFile empty;
    DocumentState first;
    first.library = d_->shipped;
    empty.states.push_back(std::make_shared<const DocumentState>(std::move(first)));
    empty.camera.width = d_->view.camera.width;
    empty.camera.height = d_->view.camera.height;
    d_->path.clear();
    d_->fileStamp.reset();
    d_->adopt(std::move(empty));
}

QString Document::filePath() const { return d_->path; }
bool Document::fileChangedByOthers() const {
    if (d_->path.isEmpty()) return false;
    const auto now = fileStamp(d_->path);
    return now && now != d_->fileStamp;
}

bool Document::isModified() const { return d_->revision != d_->savedRevision; }

Result<std::string> Document::exportTo(const QString& path, ExportFaces faces) const {
    const auto derived = shape();
    return exportShape({d_->state->bodies, *derived, d_->state->mapped}, path.toStdString(), faces);
}

SketchScript Document::recordedScript() const { return d_->recorder.script(d_->view); }

}  // namespace ew
