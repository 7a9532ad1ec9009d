// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "core/document/store.h"

namespace ew {

/// Reads a document of schema 1, the JSON text of earlier versions (format "edgewright-document",
/// version 1), as far as it goes: strokes that were erased are not in it, and the ink of a step can
/// be undone stroke by stroke. Errors as readDocument().
Result<DocumentFile> readSchema1(std::string_view text, const TemplateLibrary& shipped);

}  // namespace ew
