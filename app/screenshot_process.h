// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <QString>
#include <optional>

#include "core/base/result.h"
#include "core/document/document.h"
#include "core/document/replay_arguments.h"

namespace ew {

struct Picture {
    QString path;                      ///< .png
    QSize size;                        ///< [px]
    std::optional<QString> templates;  ///< folder of the templates in use; not set: the usual ones
    PictureLook look;
};

/// Draws the viewport of a document into a file with the program edgewright-render beside this
/// one, on the display there is, else on a virtual one (Xvfb) for the time of the call.
/// Errors: NotAvailable (no such program, no display and no Xvfb), CannotWrite, Internal.
Result<void> takeScreenshot(const Document& document, const Picture& picture);

}  // namespace ew
