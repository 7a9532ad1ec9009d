// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace ew {

inline const QString kDocumentEnding = QStringLiteral(".edgewright");
inline const QString kScriptEnding = QStringLiteral(".json");

/// Does a name end like this, in any case of letters? Only such an ending is an extension: in
/// "bracket v1.2" there is none.
bool endsWith(const QString& path, const QString& ending);

/// The path with an ending, unless it has one of the known ones already.
QString withEnding(const QString& path, const QStringList& known, const QString& ending);

/// The name that a document is saved under: with .edgewright, added where it is missing. Errors:
/// BadValue for a name of a sketch script (.json): it would be opened as one.
Result<QString> documentFileName(const QString& path);

/// A file as a command line or a file manager names it: a path, relative to the current folder, or
/// a file URL. Absolute. Errors: BadValue for a URL of anything but a file of this computer.
Result<QString> localFile(const QString& pathOrUrl);

/// What a file holds, told by its content.
enum class FileKind { Document, Script, Json, Other };
FileKind fileKind(std::string_view bytes);

/// Refuses what is neither a document nor JSON text with a sentence that says what it is instead.
/// \param name  for the sentence.
/// Errors: WrongFormat.
Result<void> refuseOtherKinds(const std::string& name, std::string_view bytes);

}  // namespace ew
