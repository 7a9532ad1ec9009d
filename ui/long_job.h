// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>
#include <string>

#include "core/base/result.h"
#include "core/document/export_options.h"
#include "core/document/store.h"

class QWidget;

namespace ew {

class Document;

/// Told how much is done, 0 to 1; false where it is to be given up. From any thread.
using JobProgress = std::function<bool(double)>;

/// Runs a job on another thread while the window stays alive; what is typed meanwhile waits. After
/// half a second a dialog says how far it is and lets one give it up.
/// \param title  what the dialog says.
void runLongJob(const QString& title, const std::function<void(const JobProgress&)>& job,
                QWidget* window);

/// Exports so; given up (Errc::Cancelled) it leaves no file and no half of one.
/// \return and errors: of Document::exportTo().
Result<std::string> exportWithProgress(const Document& document, const QString& path,
                                       ExportOptions options, QWidget* window);

/// Reads a document so. Errors: of Document::open(), Cancelled.
Result<OpenedFile> readWithProgress(const Document& document, const QString& path, QWidget* window);

}  // namespace ew
