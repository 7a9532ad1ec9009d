// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/document/lesson/attempt.h"
#include "core/document/practice/practice_shape.h"

namespace ew {

/// How a solid that is to be drawn is shown.
enum class PracticeKind {
    View,        ///< "view": as it is to be drawn
    ThreeViews,  ///< "three-views": from the front, the right and above
};

/// An exercise. It is a lesson of one step, so whatever leads through lessons leads through it.
struct PracticeTask {
    int level = 1;
    std::uint32_t seed = 0;
    PracticeKind kind = PracticeKind::View;
    PracticeShape shape;
    Lesson lesson;
};

/// The exercise of a number: the same on every machine. Its solid is one that the program reads
/// from a drawing by a ruler. Errors: BadValue for a level that there is not; NoSolution.
Result<PracticeTask> practiceTask(int level, std::uint32_t seed, const TemplateLibrary& shipped);

/// What a hand did.
struct StrokeMeasure {
    int strokes = 0;
    double seconds = 0.0;   ///< while the pen was down; 0 where that is not known
    double wobblePx = 0.0;  ///< how far the ink is from straight lines, rms
};
StrokeMeasure measureStrokes(const std::vector<Stroke>& strokes);

/// How well an exercise was done.
struct PracticeGrade {
    Attempt attempt;
    StrokeMeasure hand;
    double accuracy = 0.0;  ///< 0 to 1: of the proportions; 0 where it is not done
};

/// How near the proportions of one made solid are to those of the wanted, 0 to 1.
double practiceAccuracy(const DocumentState& wanted, const DocumentState& made);

/// Judges a drawing by what is understood of it. Errors: those of tryStep().
Result<PracticeGrade> gradePractice(const PracticeTask& task, const SketchScript& answer,
                                    const TemplateLibrary& shipped);

std::string practiceKindName(PracticeKind kind);

}  // namespace ew
