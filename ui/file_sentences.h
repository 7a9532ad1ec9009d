// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtGlobal>

namespace ew {

/// What the readers of scripts and documents say of a file, for coreText(). %1 is the file's name,
/// %2 mostly the place in it; of two that fit, the earlier one counts.
inline constexpr const char* kFileSentences[] = {
    QT_TRANSLATE_NOOP("Core", "%1: not valid JSON at byte %2"),
    QT_TRANSLATE_NOOP("Core", "%1: the key %2 comes twice in one object"),
    QT_TRANSLATE_NOOP("Core", "%1: a number before byte %2 is beyond the range of numbers"),
    QT_TRANSLATE_NOOP("Core", "%1: the file holds too many values"),
    QT_TRANSLATE_NOOP("Core", "%1: nested deeper than %2 levels"),
    QT_TRANSLATE_NOOP("Core", "%1: larger than %2 MiB"),
    QT_TRANSLATE_NOOP("Core", "%1: this is not a sketch script (its format is %2)"),
    QT_TRANSLATE_NOOP("Core", "%1: this is not an Edgewright document (its format is %2)"),
    QT_TRANSLATE_NOOP("Core", "%1: version %2 is not known; this program reads version 1"),
    QT_TRANSLATE_NOOP("Core", "%1: more than %2 steps"),
    QT_TRANSLATE_NOOP("Core", "%1: %2: the key %3 or %4 is missing"),
    QT_TRANSLATE_NOOP("Core", "%1: %2: the key %3 is missing"),
    QT_TRANSLATE_NOOP("Core", "%1: %2: unknown key %3"),
    QT_TRANSLATE_NOOP("Core", "%1: %2: either %3 or %4, not both"),
    QT_TRANSLATE_NOOP("Core", "%1: %2: there is no step called %3"),
    QT_TRANSLATE_NOOP("Core", "%1: %2: the pressure must be from 0 to 1"),
    QT_TRANSLATE_NOOP("Core", "%1: %2 names no edge"),
    QT_TRANSLATE_NOOP("Core", "%1: %2 is too far away"),
    QT_TRANSLATE_NOOP("Core", "%1: %2 must hold numbers only"),
    QT_TRANSLATE_NOOP("Core", "%1: %2 must name a template"),
    QT_TRANSLATE_NOOP("Core", "%1: %2 must name a file"),
    QT_TRANSLATE_NOOP("Core", "%1: %2 must be a direction, not zero and not huge"),
    QT_TRANSLATE_NOOP("Core", "%1: %2 must be a list of %3 numbers"),
    QT_TRANSLATE_NOOP("Core", "%1: %2 must be a colour such as %3"),
    QT_TRANSLATE_NOOP("Core", "%1: %2 must be auto or a number from 0 to 10"),
    QT_TRANSLATE_NOOP("Core", "%1: %2 must be from %3 to %4 pixels each way"),
    QT_TRANSLATE_NOOP("Core", "%1: %2 must be from %3 to %4"),
    QT_TRANSLATE_NOOP("Core", "%1: %2 must be greater than %3"),
    QT_TRANSLATE_NOOP("Core", "%1: %2 must be %3, not %4"),
    QT_TRANSLATE_NOOP("Core", "%1: %2 must be %3"),
};

/// What stands in their places.
inline constexpr const char* kFileParts[] = {
    QT_TRANSLATE_NOOP("Core", "script"),           QT_TRANSLATE_NOOP("Core", "document"),
    QT_TRANSLATE_NOOP("Core", "an object"),        QT_TRANSLATE_NOOP("Core", "a list"),
    QT_TRANSLATE_NOOP("Core", "a text"),           QT_TRANSLATE_NOOP("Core", "a number"),
    QT_TRANSLATE_NOOP("Core", "a whole number"),   QT_TRANSLATE_NOOP("Core", "true or false"),
    QT_TRANSLATE_NOOP("Core", "script: %1"),       QT_TRANSLATE_NOOP("Core", "%1: script"),
    QT_TRANSLATE_NOOP("Core", "step %1 (%2): %3"), QT_TRANSLATE_NOOP("Core", "step %1 (%2)"),
    QT_TRANSLATE_NOOP("Core", "step %1: %2"),      QT_TRANSLATE_NOOP("Core", "step %1"),
};

/// The steps of a script by the words that stand for them in files.
inline constexpr const char* kStepWords[] = {
    QT_TRANSLATE_NOOP("Step", "camera"),
    QT_TRANSLATE_NOOP("Step", "thresholds"),
    QT_TRANSLATE_NOOP("Step", "stroke"),
    QT_TRANSLATE_NOOP("Step", "erase"),
    QT_TRANSLATE_NOOP("Step", "clear"),
    QT_TRANSLATE_NOOP("Step", "apply"),
    QT_TRANSLATE_NOOP("Step", "fillet"),
    QT_TRANSLATE_NOOP("Step", "sharpen"),
    QT_TRANSLATE_NOOP("Step", "crease"),
    QT_TRANSLATE_NOOP("Step", "subdivide"),
    QT_TRANSLATE_NOOP("Step", "map_strokes"),
    QT_TRANSLATE_NOOP("Step", "unmap_strokes"),
    QT_TRANSLATE_NOOP("Step", "define_template"),
    QT_TRANSLATE_NOOP("Step", "delete_solid"),
    QT_TRANSLATE_NOOP("Step", "undo"),
    QT_TRANSLATE_NOOP("Step", "redo"),
    QT_TRANSLATE_NOOP("Step", "save"),
    QT_TRANSLATE_NOOP("Step", "open"),
    QT_TRANSLATE_NOOP("Step", "export"),
    QT_TRANSLATE_NOOP("Step", "name"),
    QT_TRANSLATE_NOOP("Step", "compact"),
    QT_TRANSLATE_NOOP("Step", "pull"),
    QT_TRANSLATE_NOOP("Step", "move_body"),
    QT_TRANSLATE_NOOP("Step", "name_body"),
    QT_TRANSLATE_NOOP("Step", "show_body"),
    QT_TRANSLATE_NOOP("Step", "delete_body"),
    QT_TRANSLATE_NOOP("Step", "combine_bodies"),
    QT_TRANSLATE_NOOP("Step", "mirror_plane"),
    QT_TRANSLATE_NOOP("Step", "begin"),
};

}  // namespace ew
