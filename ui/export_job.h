// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>

#include "core/base/result.h"
#include "core/document/export_options.h"

class QWidget;

namespace ew {

class Document;

/// Exports on another thread while the window stays alive. After half a second it says how far it
/// is and can be given up (Errc::Cancelled), which leaves no file and no half of one.
/// \return and errors: of Document::exportTo().
Result<std::string> exportWithProgress(const Document& document, const QString& path,
                                       ExportOptions options, QWidget* window);

}  // namespace ew
