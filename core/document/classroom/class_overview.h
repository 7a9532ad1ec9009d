// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "core/document/classroom/pupil_progress.h"
#include "core/document/file_fault.h"
#include "core/document/lesson/lesson.h"

namespace ew {

/// A lesson as a class sees it.
struct ClassLesson {
    std::string id;
    LessonText title;
    int minutes = 0;
    std::size_t steps = 0;
    QString path;  ///< empty: somebody worked at it, but it is not there
};

/// The lessons of a class: those in its folder `lessons`; where there are none, the shipped ones.
/// The shorter come first.
/// \param problems  what is wrong with single lessons is added.
std::vector<ClassLesson> classLessons(const QString& classFolder, const QString& shippedLessons,
                                      std::vector<FileFault>& problems);

/// One pupil of a class.
struct ClassPupil {
    QString folder;  ///< absolute
    PupilProgress progress;
    std::optional<StuckPlace> stuck;

    int done() const;  ///< steps of all lessons
    int stars() const;
    double seconds() const;
    ClassTime last() const;  ///< 0 where she has done nothing yet
    /// The document of a lesson, or empty.
    QString document(const std::string& lesson) const;
};

/// What a teacher wants to know of a class.
struct ClassOverview {
    QString folder;    ///< absolute
    std::string name;  ///< of the folder
    std::vector<ClassLesson> lessons;
    std::vector<ClassPupil> pupils;   ///< by name
    std::vector<FileFault> problems;  ///< files that cannot be read, or do not belong there

    int steps() const;  ///< of all lessons
};

/// Reads a class folder; nothing is written. What is wrong with single files keeps the others from
/// nothing. Cost: a file for each pupil. Errors: FileNotFound where there is no such folder, or it
/// may not be read.
Result<ClassOverview> readClass(const QString& folder, const QString& shippedLessons);

/// Names of the pupils of a class, each once. Errors: as readClass().
Result<std::vector<QString>> pupilNames(const QString& folder);

}  // namespace ew
