// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/document/work_folder.h"
#include "core/tlib/library.h"

namespace ew {

/// The working copies of a folder as a JSON list, the newest first: `path`, `title`, `steps`,
/// `strokes` (that wait), `time` of each, the `document` that it is of, whether it is `open`,
/// `lost`, `saved`; `error` where it cannot be read.
/// \param outFolder  where each that can be read is written as a document; `restored` says its
/// path. Made if it is not there.
/// Errors: FileNotFound where there is no such folder; CannotWrite.
Result<std::string> recoverCopies(const WorkFolder& folder, const std::optional<QString>& outFolder,
                                  const TemplateLibrary& shipped);

}  // namespace ew
