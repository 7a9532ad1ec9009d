// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <QString>

#include "core/base/result.h"
#include "core/document/document.h"
#include "core/document/replay_arguments.h"

namespace ew {

/// Writes a picture of what the viewport shows of a document: solids with their edges, grid, ink,
/// dropped ink faded, the reading. Everything that is seen in the document's viewport is seen in
/// the picture, whatever its size; in a larger one lines and grid are as much larger. Needs a
/// QGuiApplication on a platform with OpenGL (xcb under X or Xvfb) that was prepared by
/// prepareApplication(); no window is shown.
/// \param path  .png; written whole or not at all.
/// \param size  px, 16..16384 each way, at most 4096 with occlusion.
/// Errors: BadValue for the size, NotAvailable without OpenGL, CannotWrite.
Result<void> renderScreenshot(const Document& document, const QString& path, QSize size,
                              const PictureLook& look = {});

}  // namespace ew
