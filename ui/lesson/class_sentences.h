// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

namespace ew {

/// What the core says of class folders and exercises, for coreText().
inline constexpr const char* kClassSentences[] = {
    QT_TRANSLATE_NOOP("Core", "A pupil has a name."),
    QT_TRANSLATE_NOOP("Core", "A pupil's name has at most %1 letters."),
    QT_TRANSLATE_NOOP("Core", "A pupil's name has letters only that can be seen."),
    QT_TRANSLATE_NOOP("Core", "There is no class folder at %1."),
    QT_TRANSLATE_NOOP("Core", "The class folder %1 may not be read."),
    QT_TRANSLATE_NOOP("Core", "The folder %1 cannot be made."),
    QT_TRANSLATE_NOOP("Core", "There are too many folders for one name in %1."),
    QT_TRANSLATE_NOOP("Core",
                      "%1 cannot be read; it was left as it is, and the work goes on in %2."),
    QT_TRANSLATE_NOOP(
        "Core", "The class folder %1 is gone. Put the stick back in, or connect the share again."),
    QT_TRANSLATE_NOOP("Core",
                      "Another machine (%1) writes to %2, too. That was left as it is, and the "
                      "work goes on in %3."),
    QT_TRANSLATE_NOOP("Core",
                      "%1 was written by a later version of the program and is left as it is."),
    QT_TRANSLATE_NOOP("Core",
                      "What could not be written to the class folder last time was brought there "
                      "now."),
    QT_TRANSLATE_NOOP("Core", "%1: This is no pupil's folder; it was left as it is."),
    QT_TRANSLATE_NOOP("Core", "%1: this is no pupil's progress"),
    QT_TRANSLATE_NOOP("Core", "%1: this program reads version 1"),
    QT_TRANSLATE_NOOP("Core", "%1: another lesson has this id, too"),
    QT_TRANSLATE_NOOP("Core", "A level is from 1 to %1."),
    QT_TRANSLATE_NOOP("Core", "No exercise was found for this number; try another one."),
};

/// Words of the overview (OverviewWords::say); they are said as they stand here.
inline constexpr const char* kClassWords[] = {
    QT_TRANSLATE_NOOP("Core", "Class overview: %1"),
    QT_TRANSLATE_NOOP("Core", "Pupils: %1; stuck: %2; lessons: %3."),
    QT_TRANSLATE_NOOP("Core", "Files that could not be read"),
    QT_TRANSLATE_NOOP("Core", "%1, step %2"),
    QT_TRANSLATE_NOOP("Core", "%1 attempts, the last one: %2"),
    QT_TRANSLATE_NOOP("Core", "since %1"),
    QT_TRANSLATE_NOOP("Core", "from another machine"),
    QT_TRANSLATE_NOOP("Core", "Pupil"),
    QT_TRANSLATE_NOOP("Core", "Stuck"),
    QT_TRANSLATE_NOOP("Core", "Steps"),
    QT_TRANSLATE_NOOP("Core", "Stars"),
    QT_TRANSLATE_NOOP("Core", "Time"),
    QT_TRANSLATE_NOOP("Core", "Last worked"),
    QT_TRANSLATE_NOOP("Core", "Lesson"),
    QT_TRANSLATE_NOOP("Core", "Title"),
    QT_TRANSLATE_NOOP("Core", "Steps done"),
    QT_TRANSLATE_NOOP("Core", "Most stars"),
    QT_TRANSLATE_NOOP("Core", "Minutes"),
    QT_TRANSLATE_NOOP("Core", "Strokes"),
    QT_TRANSLATE_NOOP("Core", "Failed attempts"),
    QT_TRANSLATE_NOOP("Core", "Stuck at step"),
    QT_TRANSLATE_NOOP("Core", "Stuck since"),
    QT_TRANSLATE_NOOP("Core", "Hint"),
    QT_TRANSLATE_NOOP("Core", "Folder"),
    // hintWords()
    QT_TRANSLATE_NOOP("Core", "nothing was made"),
    QT_TRANSLATE_NOOP("Core", "it was done to the wrong side"),
    QT_TRANSLATE_NOOP("Core", "another kind of shape"),
    QT_TRANSLATE_NOOP("Core", "the wrong place"),
    QT_TRANSLATE_NOOP("Core", "other proportions"),
    QT_TRANSLATE_NOOP("Core", "other settings"),
    QT_TRANSLATE_NOOP("Core", "several drawings at once"),
    QT_TRANSLATE_NOOP("Core", "a corner is open"),
    QT_TRANSLATE_NOOP("Core", "a line is missing"),
    QT_TRANSLATE_NOOP("Core", "a line is too many"),
    QT_TRANSLATE_NOOP("Core", "an edge at the back was drawn"),
    QT_TRANSLATE_NOOP("Core", "a line is curved"),
    QT_TRANSLATE_NOOP("Core", "a scribble"),
    QT_TRANSLATE_NOOP("Core", "the drawing is too small"),
    QT_TRANSLATE_NOOP("Core", "a drawing in perspective"),
    QT_TRANSLATE_NOOP("Core", "lines cross"),
    QT_TRANSLATE_NOOP("Core", "an outline with no lines in it"),
    QT_TRANSLATE_NOOP("Core", "a shape that is not known"),
    QT_TRANSLATE_NOOP("Core", "an impossible corner"),
    QT_TRANSLATE_NOOP("Core", "lines are not parallel"),
    QT_TRANSLATE_NOOP("Core", "it can be read in several ways"),
    QT_TRANSLATE_NOOP("Core", "the lines enclose nothing"),
    QT_TRANSLATE_NOOP("Core", "no line could be read"),
    QT_TRANSLATE_NOOP("Core", "nothing was drawn"),
};

}  // namespace ew
