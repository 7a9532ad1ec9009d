// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/document.h"
#include "core/document/file_bytes.h"
#include "core/document/recorder.h"

namespace ew {

/// A change of the ink (InkChange) as files keep it: strokes by their ids.
struct StoredInkChange {
    int serial = 0;
    std::vector<int> added, removed, withdrawn;
    bool operator==(const StoredInkChange&) const = default;
};
using StoredInk = std::vector<StoredInkChange>;

/// One step of the history.
struct StoredCommand {
    std::string name;        ///< in English, whatever the window's language
    std::string templateId;  ///< of the template that an apply used, else empty
    std::string key;         ///< of a change of settings: what it changes
    std::shared_ptr<const DocumentState> after;
    std::vector<int> consumed;      ///< strokes that undoing it gives back
    StoredInk inkBefore, inkAfter;  ///< as StateCommand has them
};

/// All that a native document (.edgewright) holds: the whole history with every state, the ink and
/// its line of time, the view and the recorded script. Undo and redo of what is read back give what
/// they would have given in the document that was written, to the bit.
struct DocumentFile {
    std::vector<PendingStroke> strokes;          ///< all that anything here names
    std::shared_ptr<const DocumentState> first;  ///< before the first command
    std::vector<StoredCommand> commands;
    int index = 0;             ///< how many commands are done
    std::vector<int> pending;  ///< strokes, in the order of drawing
    StoredInk inkDone, inkUndone;
    int nextStrokeId = 0;   ///< greater than every stroke id
    int nextInkSerial = 0;  ///< greater than every serial
    ViewSettings view;
    bool automaticDistance = true;
    double obliqueFactor = 0.5;
    std::string title;
    std::vector<Recorder::Entry> script;
    std::map<int, std::vector<Recorder::Entry>> takenBack;  ///< Recorder::takenBack()
    std::string thumbnail;                                  ///< PNG, or nothing
    std::map<int, std::string> names;  ///< of states, by how many steps are done in them

    const std::shared_ptr<const DocumentState>& stateAt(int commandsDone) const {
        return commandsDone == 0 ? first
                                 : commands[static_cast<std::size_t>(commandsDone) - 1].after;
    }
};

/// A document as it was read from a file.
struct OpenedFile {
    QString path;
    std::optional<FileStamp> stamp;      ///< of the file when it was read
    std::shared_ptr<DocumentFile> file;  ///< never null
};

/// What a file must be told to be up to date again: a DocumentFile in which only some of the
/// strokes, commands and script entries stand.
struct DocumentUpdate {
    DocumentFile file;
    bool whole = false;            ///< everything stands in it
    std::size_t firstCommand = 0;  ///< which one file.commands begins with; after them others may
                                   ///< stand that are as they were
    std::size_t commandCount = 0;
    std::optional<bool> saved;   ///< in a working copy: is all of it in the document's file, too?
    std::size_t firstEntry = 0;  ///< which one file.script begins with; it goes to the end
    std::size_t entryCount = 0;
};

/// An update that makes an empty file hold all of this.
DocumentUpdate wholeUpdate(DocumentFile file);

/// Most bytes of a document, and of one in the JSON format of earlier versions (schema 1).
inline constexpr std::size_t kMaxDocumentBytes = std::size_t{1} << 30U;
inline constexpr std::size_t kMaxSchema1Bytes = 256U << 20U;

/// The document as the bytes of a SQLite database, schema 2 (docs/document-format.md). Equal
/// documents give equal bytes. Errors: TooMuchMemory.
Result<std::string> writeDocument(const DocumentFile& file);

/// Told how much of a file is read, 0 to 1; false gives up. May come from any thread, but from one
/// at a time.
using ReadProgress = std::function<bool(double)>;

struct ReadOptions {
    /// The solids of all states are checked; else only those of the state that is shown first, and
    /// the others when somebody goes there (loadState).
    bool whole = true;
    ReadProgress progress = {};
};

/// Reads writeDocument's bytes, or the JSON text of schema 1. Everything is checked. Errors of
/// both: TooLarge, Damaged, BadValue and those of readTemplate, TemplateLibrary::with and
/// Solid::deserialize; WrongVersion for a later schema that this program cannot read at all, whose
/// sentence says which version of the program does; Cancelled; of schema 1 also TooDeep, Syntax,
/// WrongFormat, UnknownKey, MissingKey, WrongType. Messages name the place in the file.
/// \param shipped  the templates that every library starts with; where a template of the document
///     has the same id, the document's takes its place.
Result<DocumentFile> readDocument(const std::string& bytes, const TemplateLibrary& shipped,
                                  const ReadOptions& options = {});

/// Reads and checks the solids of a state that were left for later.
/// Errors: Damaged, with what Solid::load() said.
Result<void> loadState(const DocumentState& state);

/// Was the document at this path written by a version with a later schema? Nothing is written over
/// such a file. False where there is none.
bool isFileOfLaterSchema(const QString& path);

/// Writes atomically: the old file stands until the new one is whole. Errc::CannotWrite,
/// Errc::TooLarge where the file could not be read back, Errc::WrongVersion where a document of a
/// later schema stands there.
Result<void> saveDocument(const DocumentFile& file, const QString& path);

/// Errc::FileNotFound, Errc::TooLarge and the errors of readDocument.
Result<DocumentFile> loadDocument(const QString& path, const TemplateLibrary& shipped,
                                  const ReadOptions& options = {});

}  // namespace ew
