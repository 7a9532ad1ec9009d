// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/base/result.h"

namespace ew {

/// What must be set before the QApplication is made: OpenGL surface format, context sharing, the
/// xcb platform where there is an X display and none was asked for.
void prepareApplication();

/// What must be set right after: samples of mouse, pen and touch one by one; name, version, icon,
/// resources of the library.
void nameApplication();

/// Loads the texts of a language, before the first window is made.
/// \param language  a code like "de" or "en"; empty: the system's, or English where there is no
/// translation for it. A named one decides the form of numbers and dates too.
/// Errors: Errc::BadValue for a language without a translation.
Result<void> chooseLanguage(const QString& language = {});

}  // namespace ew
