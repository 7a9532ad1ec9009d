// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace ew {

/// The name of a step of the history in the window's language.
/// \param english  the name as commands give it and files keep it, whatever the language is, e.g.
/// "Create cube". What is no such name, as in files of earlier versions, is returned as it is.
QString shownStepName(const QString& english);

}  // namespace ew
