// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/base/result.h"

namespace ew {

/// Most letters (UTF-16) of a pupil's name.
inline constexpr int kLongestPupilName = 500;

/// A pupil's name as it is kept: composed letters, no blanks at its ends, one blank where there
/// were several. Anything else may be in it: `/`, emoji, any script. Errors: BadValue for one that
/// is empty, too long, or has letters that cannot be seen (control characters, half of an emoji).
Result<QString> pupilName(const QString& typed);

/// The name of a pupil's folder: what of her name any disk takes, not too long, then a sum of the
/// whole name, so that two names with one beginning, or that differ in what a disk does not tell
/// apart, have two folders: "Anna-5c0a2d11".
/// \param name  as pupilName() gives it.
/// \param copy  1; more for further folders of one name: "Anna-5c0a2d11-2".
QString pupilFolderName(const QString& name, int copy = 1);

}  // namespace ew
