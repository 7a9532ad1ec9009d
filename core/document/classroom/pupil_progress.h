// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/practice/practice_log.h"

namespace ew {

/// Seconds since 1970, UTC.
using ClassTime = std::int64_t;

/// What kept an attempt from being the step that was wanted.
struct FailedTry {
    ClassTime time = 0;
    std::string hint;  ///< code of an error or of an Unlike
    bool operator==(const FailedTry&) const = default;
};

/// What a pupil did at one step of a lesson.
struct StepProgress {
    int stars = 0;    ///< 1 to 3 where it is done, 0 where not
    int strokes = 0;  ///< of the attempt that did it
    int failed = 0;   ///< attempts that did not
    double seconds = 0.0;
    std::vector<FailedTry> tries;  ///< the newest kMostTries of those that failed since it was
                                   ///< begun last
    bool operator==(const StepProgress&) const = default;
};

/// How far a pupil is in a lesson.
struct LessonProgress {
    std::size_t step = 0;             ///< at which she is, or was last
    std::vector<StepProgress> steps;  ///< one for each of the lesson
    ClassTime begun = 0;
    ClassTime last = 0;     ///< when anything was last done
    std::string thumbnail;  ///< PNG of what she made, or nothing

    bool operator==(const LessonProgress&) const = default;
    int done() const;
    int stars() const;
    int mostStars() const;
    int strokes() const;
    int failed() const;
    double seconds() const;
    bool finished() const { return done() == static_cast<int>(steps.size()); }
};

/// What a class folder keeps of one pupil.
struct PupilProgress {
    std::string name;
    std::string machine;  ///< that wrote last
    std::string session;  ///< of the program on it, another one with each start
    std::string apart;    ///< folder of the same name that another machine writes to; or empty
    std::map<std::string, LessonProgress> lessons;  ///< by id
    std::vector<PracticeResult> practice;           ///< the oldest first
    bool operator==(const PupilProgress&) const = default;
};

inline constexpr std::size_t kMostTries = 20;
inline constexpr int kMostStars = 3;
/// Who fails this often at a step in a row is stuck there ...
inline constexpr int kStuckTries = 3;
/// ... and so is who works at it that long [s]: the shipped lessons take a minute or two a step.
inline constexpr double kStuckSeconds = 300.0;
/// Who does nothing for longer is away: that time does not count [s].
inline constexpr ClassTime kAwaySeconds = 120;

// What happens while a pupil works; each also counts the time since the last of them.

/// \param count  of the lesson's steps. Where it has changed, what was done is forgotten.
/// \pre step < count
void beginStep(PupilProgress& pupil, const std::string& lesson, std::size_t count, std::size_t step,
               ClassTime now);
/// \pre beginStep() for the lesson, as for the following.
void keepTime(PupilProgress& pupil, const std::string& lesson, ClassTime now);
void failStep(PupilProgress& pupil, const std::string& lesson, const std::string& hint,
              ClassTime now);
/// The best of several times counts.
void finishStep(PupilProgress& pupil, const std::string& lesson, int stars, int strokes,
                ClassTime now);

/// Where a pupil does not get on.
struct StuckPlace {
    std::string lesson;
    std::size_t step = 0;
    ClassTime since = 0;
    int failed = 0;    ///< attempts since she began the step last
    std::string hint;  ///< the newest, or empty
};

/// Is she stuck in the lesson that she worked at last?
std::optional<StuckPlace> stuckPlace(const PupilProgress& pupil);

/// What two machines know of one pupil: of each lesson what was written last, with the best stars
/// of both, and all exercises.
void mergeProgress(PupilProgress& into, const PupilProgress& other);

inline constexpr std::size_t kMaxProgressBytes = 8U << 20U;

/// As JSON text, and back. Errors: those of parseJson(); WrongFormat, WrongVersion, MissingKey,
/// WrongType, BadValue; messages name the JSON path.
std::string progressText(const PupilProgress& pupil);
Result<PupilProgress> readProgress(const std::string& text);

}  // namespace ew
