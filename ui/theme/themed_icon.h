// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QString>

namespace ew {

/// An icon of resources/icons, drawn in the palette's text colour at any scale. It is read and
/// drawn when it is first shown, and follows the theme by itself.
/// \param name  file name without ".svg".
QIcon themedIcon(const QString& name);

}  // namespace ew
