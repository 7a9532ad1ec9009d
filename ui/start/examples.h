// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

namespace ew {

/// A sketch script of resources/examples.
struct Example {
    QString path;
    QString title;    ///< in the window's language
    QString picture;  ///< file of its picture, which may not be there
    int steps = 0;    ///< that make or change something
};

/// All examples, by name. Reads their scripts.
std::vector<Example> examples();

}  // namespace ew
