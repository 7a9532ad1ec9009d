// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/support/hand_model.h"

namespace ew::test {

/// One column of the table.
struct LevelSpec {
    std::string_view name;
    HandLevel hand;
    double wantedRight = 1.0;         ///< share accepted and right, at least
    double allowedWrong = 0.0;        ///< share accepted in silence and wrong, at most
    double allowedVolumeError = 0.0;  ///< relative, cubes with a readable corner
};

inline constexpr std::array<LevelSpec, 4> kLevels{{
    {"exact", kExactHand, 1.0, 0.0, 1e-6},
    {"light", kLightHand, 0.995, 0.002, 0.08},
    {"normal", kNormalHand, 0.98, 0.005, 0.15},
    {"rough", kRoughHand, 0.90, 0.02, 0.30},
}};

/// A box whose three corner angles are all at least this wide tells its volume [degrees].
inline constexpr double kReadableCornerDeg = 98.0;

enum class Verdict { Right, WrongInSilence, NotAccepted };

/// What became of one drawing.
struct Outcome {
    int index = -1;
    std::string templateId;
    Verdict verdict = Verdict::NotAccepted;
    std::string detail;                 ///< why it is not right, one line
    std::optional<double> volumeError;  ///< relative; right cubes with a readable corner only
    bool amongCandidates = false;       ///< the right reading was offered
    std::optional<double> probability;  ///< told of what was accepted, else of the first candidate
    bool toldRight = false;             ///< was that one right?
    double ms = 0.0;                    ///< time of interpret()
};

/// Prints the table of one set of outcomes, one column a level. `only` restricts it to a template
/// where not empty. Columns that were not run are left out.
void printTable(const std::array<std::vector<Outcome>, kLevels.size()>& outcomes,
                const std::string& only);

/// Writes a line for each drawing that was read: the probability that was told of what was accepted
/// or, where none was, of the first candidate; 1 where that was right, else 0; 1 where it was
/// accepted, else 0. `calibrate` reads it. \return false where the file cannot be written.
bool writeTold(const std::string& path, const std::vector<Outcome>& outcomes);

/// The reasons of what was not right, most frequent first.
void printReasons(const LevelSpec& level, const std::vector<Outcome>& outcomes);

}  // namespace ew::test
