// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/store.h"
#include "core/store/database.h"

namespace ew {

/// Reads a database of schema 2. Everything is checked; errors as readDocument().
Result<DocumentFile> readDatabase(Database& database, const TemplateLibrary& shipped,
                                  const ReadOptions& options = {});

/// What a list of documents shows of one.
struct DocumentSummary {
    std::string title;
    int steps = 0;          ///< of the history
    int strokes = 0;        ///< pending
    std::string thumbnail;  ///< PNG, or nothing
};

/// Reads no more than it needs. Errors: Damaged.
Result<DocumentSummary> summarizeDatabase(Database& database);

}  // namespace ew
