// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>
#include <vector>

namespace ew {

/// A shipped lesson as a list shows it.
struct ListedLesson {
    QString path;
    QString title;  ///< in the window's language, as the summary
    QString summary;
    int minutes = 0;
    int stars = 0;  ///< of an earlier run
    int mostStars = 0;
    std::string picture;  ///< PNG, or nothing
};

/// All shipped lessons, the shorter ones first. Reads them.
std::vector<ListedLesson> listedLessons();

}  // namespace ew
