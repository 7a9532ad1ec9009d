// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QString>

#include "core/base/result.h"

namespace ew {

/// Errors: UnknownExtension, where no picture can be written in the format that the name asks for.
Result<void> checkPictureName(const QString& path);

/// Writes a picture in the format of the name's extension, as PNG where it has none, the way every
/// file is written (writeFileBytes). Errors: UnknownExtension; CannotWrite, also where the picture
/// has no size, or is transparent and the format cannot be.
Result<void> writePicture(const QImage& image, const QString& path);

}  // namespace ew
