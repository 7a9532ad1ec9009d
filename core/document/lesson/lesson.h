// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/sketch_script.h"

namespace ew {

/// A text in several languages, by language code ("en", "zh_CN").
using LessonText = std::map<std::string, std::string>;

/// The text in a language; where it is not there, in the one without its country, in English, or in
/// any. Empty where there is none at all.
std::string textIn(const LessonText& text, const std::string& language);

/// One thing to do.
struct LessonStep {
    LessonText text;         ///< what to do
    LessonText hint;         ///< may be empty: what the program says by itself is told then
    std::size_t end = 0;     ///< steps of the solution that are done when this one is
    double tolerance = 0.0;  ///< how far proportions may be off, a share; see kLessonTolerance
};

inline constexpr double kLessonTolerance = 0.4;

/// A guided lesson: a sketch script that is its solution, cut into steps with a text for each
/// (docs/lesson-format.md).
struct Lesson {
    std::string id;
    std::vector<std::string> languages;  ///< in which every text is there
    LessonText title;
    LessonText summary;
    int minutes = 10;                ///< how long it takes
    std::vector<std::string> tools;  ///< that it needs, by name; empty: all are shown
    SketchScript solution;
    std::vector<LessonStep> steps;
    std::string picture;  ///< PNG of its end, or nothing
};

inline constexpr std::size_t kMaxLessonBytes = 16U << 20U;
inline constexpr std::size_t kMaxLessonSteps = 200;

/// Reads a lesson: a folder with lesson.json and what that names, this lesson.json itself, or all
/// of it in one file (.edgewright-lesson, a zip archive of the folder). Nothing is written. Errors:
/// FileNotFound, TooLarge, Damaged, Syntax, TooDeep, WrongFormat, WrongVersion, UnknownKey,
/// MissingKey, WrongType, and BadValue for what a value may not be, for a file outside the lesson's
/// folder and for a step that is not for lessons (save, open, export). Messages name the file and
/// the JSON path.
Result<Lesson> readLesson(const QString& path);

/// A folder of the lesson as one file. Errors: those of readLesson() and Internal.
Result<std::string> packLesson(const QString& folder);

}  // namespace ew
