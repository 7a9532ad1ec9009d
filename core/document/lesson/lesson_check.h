// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/document/lesson/lesson.h"
#include "core/tlib/library.h"

namespace ew {

/// What is wrong with a lesson that can be read.
struct LessonFault {
    std::string path;  ///< JSON path
    Error error;
};

/// Is every text there in every language that the lesson claims, and does every step pass by its
/// own solution, with the strokes alone as well as with all of its steps? Cost: that of replaying
/// the solution once for each step.
std::vector<LessonFault> checkLesson(const Lesson& lesson, const TemplateLibrary& shipped);

}  // namespace ew
