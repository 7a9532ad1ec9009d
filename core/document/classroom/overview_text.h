// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "core/document/classroom/class_overview.h"

namespace ew {

/// The language of what is written of a class.
struct OverviewWords {
    std::string language = "en";  ///< code, as lessons have it
    /// An English text in that language.
    std::function<std::string(const std::string&)> say = [](const std::string& text) {
        return text;
    };
    std::function<std::string(ClassTime)> time;  ///< a moment; where empty: 2024-05-31 10:15
};

/// One row for each pupil and lesson that she has begun (one for a pupil who has begun none), with
/// a head row; commas, CRLF, UTF-8 with a byte order mark, as spreadsheets want it. A text that a
/// spreadsheet would take for a formula begins with an apostrophe.
std::string overviewCsv(const ClassOverview& overview, const OverviewWords& words = {});

/// One page that needs no other file: a row for each pupil, a column for each lesson with a picture
/// of what she made; it is sorted by a click on a head. Names are text in it, whatever they hold.
std::string overviewHtml(const ClassOverview& overview, const OverviewWords& words = {});

/// All of it for programs, without the pictures.
std::string overviewJson(const ClassOverview& overview);

/// "12 min", "1 h 05 min", "less than a minute" as "< 1 min".
std::string durationText(double seconds);

/// Stars and how many there could be: "7 / 9".
std::string starsText(int stars, int most);

/// Where a pupil is stuck, in a sentence: "First box, step 2: 4 attempts, the last one: a line is
/// missing".
std::string stuckText(const ClassOverview& overview, const StuckPlace& stuck,
                      const OverviewWords& words = {});

}  // namespace ew
