// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QString>

#include "core/base/result.h"

namespace ew {

/// Writes a picture as PNG, the way every file is written (writeFileBytes). Errors: CannotWrite,
/// also where the picture has no size.
Result<void> writePicture(const QImage& image, const QString& path);

}  // namespace ew
