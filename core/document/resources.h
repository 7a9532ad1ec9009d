// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/base/result.h"
#include "core/tlib/library.h"

namespace ew {

/// The folder with templates/ and examples/: $EDGEWRIGHT_RESOURCES, then ../share/edgewright beside
/// the program, then the source tree's resources. The first that has a templates folder.
/// Errc::FileNotFound where none has.
Result<QString> resourcesFolder();

/// The person's own templates, e.g. ~/.local/share/edgewright/templates; the same for every program
/// of the project. May not exist; empty where the system names no place for data.
QString personalTemplateFolder();
/// The same, made if it is not there. Errc::CannotWrite.
Result<QString> ensurePersonalTemplateFolder();

/// The shipped templates and the person's own. What is wrong with single files is in `problems`; a
/// file of the person's whose id is taken is one of them.
/// Errors: those of resourcesFolder and loadLibrary.
Result<LibraryLoad> loadTemplates();

/// The same from given folders; `personal` may be empty or missing.
Result<LibraryLoad> loadTemplates(const QString& shipped, const QString& personal);

}  // namespace ew
