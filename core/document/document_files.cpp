// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <unordered_map>

#include "core/document/document.h"
#include "core/document/document_private.h"
#include "core/document/export_mesh.h"
#include "core/document/file_names.h"
#include "core/document/store.h"
#include "core/surface/patch_memory.h"

namespace ew {

namespace {

StoredInk storedInk(const InkHistory& history) {
    const auto ids = [](const std::vector<PendingStroke>& strokes) {
        std::vector<int> out;
        for (const PendingStroke& s : strokes) out.push_back(s.id);
        std::sort(out.begin(), out.end());
        return out;
    };
    StoredInk out;
    for (const InkChange& c : history) {
        std::vector<int> added = c.added;
        std::sort(added.begin(), added.end());
        out.push_back({c.serial, std::move(added), ids(c.removed), ids(c.withdrawn)});
    }
    return out;
}

/// Strokes by id.
class Strokes {
  public:
    explicit Strokes(const std::vector<PendingStroke>& strokes) {
        for (const PendingStroke& s : strokes) byId_.emplace(s.id, &s);
    }
    std::vector<PendingStroke> with(const std::vector<int>& ids) const {
        std::vector<PendingStroke> out;
        for (const int id : ids) out.push_back(*byId_.at(id));
        return out;
    }
    InkHistory history(const StoredInk& stored) const {
        InkHistory out;
        for (const StoredInkChange& c : stored) {
            out.push_back({c.serial, c.added, with(c.removed), with(c.withdrawn)});
        }
        return out;
    }

  private:
    std::unordered_map<int, const PendingStroke*> byId_;
};

/// Collects strokes, each once, in the order of their ids.
class StrokeCollector {
  public:
    /// \param leastId  those with smaller ids are left out.
    explicit StrokeCollector(int leastId) : leastId_(leastId) {}
    void add(const std::vector<PendingStroke>& strokes) {
        for (const PendingStroke& s : strokes) {
            if (s.id >= leastId_) found_.emplace(s.id, &s);
        }
    }
    void add(const InkHistory& history) {
        for (const InkChange& c : history) {
            add(c.removed);
            add(c.withdrawn);
        }
    }
    std::vector<PendingStroke> strokes() const {
        std::vector<PendingStroke> out;
        for (const auto& [id, stroke] : found_) out.push_back(*stroke);
        return out;
    }

  private:
    int leastId_;
    std::map<int, const PendingStroke*> found_;
};

}  // namespace

void Document::Private::stepChanged(int place) {
    newSteps.first = newSteps.end > newSteps.first ? std::min(newSteps.first, place) : place;
    newSteps.end = std::max(newSteps.end, place + 1);
}

StoredCommand Document::Private::stored(const StateCommand& command) const {
    StoredCommand out;
    out.name = command.english.toStdString();
    out.templateId = command.templateId;
    out.key = command.key;
    out.after = command.after;
    for (const PendingStroke& s : command.consumed) out.consumed.push_back(s.id);
    std::sort(out.consumed.begin(), out.consumed.end());
    out.inkBefore = storedInk(command.inkBefore);
    out.inkAfter = storedInk(command.inkAfter);
    return out;
}

DocumentUpdate Document::Private::update(bool whole) const {
    DocumentUpdate out;
    DocumentFile& file = out.file;
    out.whole = whole;
    const int count = stack.count();
    const int first = whole ? 0 : std::min(newSteps.first, count);
    const int end = whole ? count : std::min(newSteps.end, count);
    StrokeCollector strokes(whole ? 0 : writtenStrokes);
    strokes.add(ink.strokes());
    strokes.add(ink.done());
    strokes.add(ink.undone());
    for (int i = first; i < end; ++i) {
        const auto* command = static_cast<const StateCommand*>(stack.command(i));
        strokes.add(command->consumed);
        strokes.add(command->inkBefore);
        strokes.add(command->inkAfter);
        file.commands.push_back(stored(*command));
    }
    const auto* oldest = count > 0 ? static_cast<const StateCommand*>(stack.command(0)) : nullptr;
    file.first = oldest != nullptr ? oldest->before : state;
    file.strokes = strokes.strokes();
    file.index = stackIndex;
    for (const PendingStroke& s : ink.strokes()) file.pending.push_back(s.id);
    file.inkDone = storedInk(ink.done());
    file.inkUndone = storedInk(ink.undone());
    file.nextStrokeId = ink.nextId();
    file.nextInkSerial = ink.nextSerial();
    file.view = view;
    file.automaticDistance = automaticDistance;
    file.obliqueFactor = obliqueFactor;
    file.title = recorder.title();
    file.thumbnail = thumbnail;
    if (!firstName.empty()) file.names[0] = firstName;
    for (int i = 0; i < count; ++i) {
        const auto* command = static_cast<const StateCommand*>(stack.command(i));
        if (!command->stateName.empty()) file.names[i + 1] = command->stateName;
    }
    const auto& entries = recorder.entries();
    out.firstCommand = static_cast<std::size_t>(first);
    out.commandCount = static_cast<std::size_t>(count);
    out.entryCount = entries.size();
    if (whole) {
        file.script = entries;
        file.takenBack = recorder.takenBack();
    } else {
        const Recorder::News& news = recorder.news();
        out.firstEntry = news.firstEntry;
        file.script.assign(entries.begin() + static_cast<std::ptrdiff_t>(news.firstEntry),
                           entries.end());
        for (const int serial : news.takenBack) {
            const auto found = recorder.takenBack().find(serial);
            auto& list = file.takenBack[serial];
            if (found != recorder.takenBack().end()) list = found->second;
        }
    }
    return out;
}

void Document::Private::adopt(DocumentFile file) {
    movingStack = true;
    stack.clear();
    const Strokes strokes(file.strokes);
    // Pushing runs each command, which leads through the states from first to last.
    state = file.first;
    std::vector<StateCommand*> pushed;
    for (StoredCommand& stored : file.commands) {
        auto* command =
            new StateCommand(*this, QString::fromStdString(stored.name), state, stored.after);
        command->consumed = strokes.with(stored.consumed);
        command->inkBefore = strokes.history(stored.inkBefore);
        command->key = std::move(stored.key);
        command->templateId = std::move(stored.templateId);
        pushed.push_back(command);
        stack.push(command);
    }
    stack.setIndex(file.index);
    for (std::size_t i = 0; i < pushed.size(); ++i) {
        pushed[i]->inkAfter = strokes.history(file.commands[i].inkAfter);
    }
    movingStack = false;
    stackIndex = file.index;
    stack.setClean();

    state = file.stateAt(file.index);
    ink.reset({strokes.with(file.pending), file.nextStrokeId, strokes.history(file.inkDone),
               strokes.history(file.inkUndone), file.nextInkSerial});
    view = file.view;
    automaticDistance = file.automaticDistance;
    obliqueFactor = file.obliqueFactor;
    recorder =
        Recorder::resumed(std::move(file.title), std::move(file.script), std::move(file.takenBack));
    thumbnail = std::move(file.thumbnail);
    replaced.reset();
    firstName = file.names.contains(0) ? file.names.at(0) : std::string();
    for (const auto& [steps, name] : file.names) {
        if (steps > 0) pushed[static_cast<std::size_t>(steps) - 1]->stateName = name;
    }
    newSteps = {0, stack.count()};
    writtenStrokes = 0;
    reading.reset();
    savedRevision = firstRevision = ++revision;
    ++life;
    for (const DocumentChange what :
         {DocumentChange::Library, DocumentChange::Thresholds, DocumentChange::Camera,
          DocumentChange::Bodies, DocumentChange::Shape, DocumentChange::Ink,
          DocumentChange::Reading, DocumentChange::History, DocumentChange::File}) {
        emitChange(what);
    }
}

void Document::Private::forgetShapes() {
    cache = std::make_shared<ShapeCache>();
    forgetPatches();
    shapeOf.reset();
    shape.reset();
}

DocumentFile Document::contents() const { return d_->update(true).file; }

Result<void> Document::saveCopy(const QString& wanted) const {
    const auto path = documentFileName(wanted);
    if (!path) return fail(path.error());
    return saveDocument(contents(), *path);
}

Result<void> Document::save(const QString& wanted) {
    const auto path = documentFileName(wanted);
    if (!path) return fail(path.error());
    if (auto ok = saveCopy(*path); !ok) return ok;
    d_->path = *path;
    d_->fileStamp = fileStamp(*path);
    d_->savedRevision = d_->revision;
    d_->stack.setClean();
    d_->emitChange(DocumentChange::File);
    return {};
}

namespace {

Result<OpenedFile> openedFile(const QString& path, const TemplateLibrary& shipped,
                              const ReadOptions& options) {
    // Before it is read: what is written meanwhile counts as a change.
    const auto stamp = fileStamp(path);
    auto file = loadDocument(path, shipped, options);
    if (!file) return fail(file.error());
    return OpenedFile{path, stamp, std::make_shared<DocumentFile>(*std::move(file))};
}

}  // namespace

std::function<Result<OpenedFile>()> Document::openTask(const QString& path,
                                                       std::function<bool(double)> progress) const {
    return [path, shipped = d_->shipped, progress = std::move(progress)] {
        return openedFile(path, shipped, {.whole = false, .progress = progress});
    };
}

void Document::open(OpenedFile opened) {
    d_->path = opened.path;
    d_->fileStamp = opened.stamp;
    d_->forgetShapes();
    d_->adopt(std::move(*opened.file));
}

Result<void> Document::open(const QString& path) {
    auto opened = openedFile(path, d_->shipped, {});
    if (!opened) return fail(opened.error());
    open(*std::move(opened));
    return {};
}

void Document::reset() {
    DocumentFile empty;
    DocumentState first;
    first.library = d_->shipped;
    empty.first = std::make_shared<const DocumentState>(std::move(first));
    empty.view.camera.width = d_->view.camera.width;
    empty.view.camera.height = d_->view.camera.height;
    d_->path.clear();
    d_->fileStamp.reset();
    d_->forgetShapes();
    d_->adopt(std::move(empty));
}

DocumentUpdate Document::takeUpdate(bool whole) {
    DocumentUpdate update = d_->update(whole);
    d_->newSteps = {};
    d_->writtenStrokes = d_->ink.nextId();
    d_->recorder.forgetNews();
    return update;
}

long Document::life() const { return d_->life; }
bool Document::untouched() const { return d_->revision == d_->firstRevision; }

void Document::restore(DocumentFile file, const QString& path) {
    d_->path = path;
    d_->fileStamp = path.isEmpty() ? std::nullopt : fileStamp(path);
    d_->adopt(std::move(file));
    d_->touch();
}

const std::string& Document::title() const { return d_->recorder.title(); }
void Document::setTitle(const std::string& title) { d_->recorder.setTitle(title); }

void Document::setThumbnail(std::string png) { d_->thumbnail = std::move(png); }
const std::string& Document::thumbnail() const { return d_->thumbnail; }

QString Document::filePath() const { return d_->path; }
bool Document::fileChangedByOthers() const {
    if (d_->path.isEmpty()) return false;
    const auto now = fileStamp(d_->path);
    return now && now != d_->fileStamp;
}

bool Document::isReadOnly() const { return !d_->path.isEmpty() && isFileOfLaterSchema(d_->path); }

bool Document::isModified() const { return d_->revision != d_->savedRevision; }

Result<std::string> Document::exportTo(const QString& path, const ExportOptions& options) const {
    return exportTask(path, options)();
}

std::function<Result<std::string>()> Document::exportTask(const QString& path,
                                                          const ExportOptions& options) const {
    return [state = d_->state, derived = shape(), path = path.toStdString(), options] {
        return exportShape({state->bodies, *derived, state->mapped}, path, options);
    };
}

SketchScript Document::recordedScript() const { return d_->recorder.script(d_->view); }

}  // namespace ew
