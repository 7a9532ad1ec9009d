// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/classroom/hint_words.h"

#include <string_view>
#include <utility>

namespace ew {

std::string hintWords(const std::string& code) {
    constexpr std::pair<std::string_view, std::string_view> kWords[] = {
        {"not-yet", "nothing was made"},
        {"wrong-side", "it was done to the wrong side"},
        {"wrong-shape", "another kind of shape"},
        {"wrong-place", "the wrong place"},
        {"wrong-proportions", "other proportions"},
        {"wrong-settings", "other settings"},
        {"separate-drawings", "several drawings at once"},
        {"open-end", "a corner is open"},
        {"missing-edge", "a line is missing"},
        {"extra-edge", "a line is too many"},
        {"hidden-line", "an edge at the back was drawn"},
        {"curved-edge", "a line is curved"},
        {"curved-stroke", "a line is curved"},
        {"scribble", "a scribble"},
        {"too-small", "the drawing is too small"},
        {"perspective", "a drawing in perspective"},
        {"self-crossing", "lines cross"},
        {"flat-drawing", "an outline with no lines in it"},
        {"no-match", "a shape that is not known"},
        {"impossible-corner", "an impossible corner"},
        {"not-parallel", "lines are not parallel"},
        {"ambiguous", "it can be read in several ways"},
        {"no-region", "the lines enclose nothing"},
        {"only-noise", "no line could be read"},
        {"empty-sketch", "nothing was drawn"},
    };
    for (const auto& [known, words] : kWords) {
        if (code == known) return std::string(words);
    }
    return code;
}

}  // namespace ew
