// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "core/document/practice/practice_task.h"

namespace ew {

/// How an exercise is painted.
struct PracticePaint {
    std::string line = "#202020";    ///< edges that are seen
    std::string hidden = "#8a8a8a";  ///< edges that are not, and words
    std::array<std::string, 3> names{"Front", "Right", "Top"};
};

/// What a person has to go by, as SVG: the solid from the task's camera, or its three views, the
/// one from above over that from the front and that from the right beside it.
std::string practiceSvg(const PracticeTask& task, const PracticePaint& paint = {});

}  // namespace ew
