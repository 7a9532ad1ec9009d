// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/document.h"
#include "core/document/file_bytes.h"

namespace ew {

/// One step of the history, between states[i] and states[i + 1].
struct StoredCommand {
    std::string name;                     ///< in English, whatever the window's language
    std::vector<PendingStroke> consumed;  ///< ink that undoing it gives back
    std::vector<PendingStroke> left;      ///< ink drawn before it, since the step before, that it
                                          ///< did not use
};

/// What a native document (.edgewright) holds: the whole history with every snapshot, the pending
/// ink, the view and the recorded script.
struct DocumentFile {
    std::vector<std::shared_ptr<const DocumentState>> states;  ///< commands.size() + 1
    std::vector<StoredCommand> commands;
    int index = 0;  ///< how many commands are done; states[index] is the state of the document
    std::vector<PendingStroke> pending;
    int nextStrokeId = 0;  ///< greater than every stroke id
    OrthographicCamera camera;
    Thresholds thresholds;
    double obliqueFactor = 0.5;
    SketchScript script;
};

inline constexpr std::size_t kMaxDocumentBytes = 256U << 20U;

/// The document as JSON text (format "edgewright-document", version 1). Solids are kept through
/// Solid::serialize, each distinct one once; numbers read back to the bit.
std::string writeDocument(const DocumentFile& file);

/// Reads writeDocument's text. Everything is checked. Errors: TooLarge (over 256 MiB), TooDeep,
/// Syntax, WrongFormat, WrongVersion, UnknownKey, MissingKey, WrongType, BadValue, and those of
/// readTemplate, TemplateLibrary::with and Solid::deserialize; messages name the place in the file.
/// \param shipped  the templates that every library starts with; where a template of the document
///                 has the same id, the document's takes its place.
Result<DocumentFile> readDocument(std::string_view text, const TemplateLibrary& shipped);

/// Writes atomically: the old file stands until the new one is whole. Errc::CannotWrite,
/// Errc::TooLarge where the file could not be read back.
Result<void> saveDocument(const DocumentFile& file, const QString& path);

/// Errc::FileNotFound, Errc::TooLarge and the errors of readDocument.
Result<DocumentFile> loadDocument(const QString& path, const TemplateLibrary& shipped);

}  // namespace ew
