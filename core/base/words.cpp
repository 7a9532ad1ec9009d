// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace ew {

namespace {

bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
char small(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

bool startsWithVowelSound(const std::string& name) {
    if (name.empty()) return false;
    const bool spelled = isLetter(name[0]) && (name.size() == 1 || !isLetter(name[1]));
    if (spelled) return std::string_view("aefhilmnorsx").find(small(name[0])) != std::string::npos;
    // "8-gon", "11-sided", "18 mm slot"
    if (name[0] == '8' || name.starts_with("11") || name.starts_with("18")) return true;
    std::string word(name.size(), ' ');
    std::transform(name.begin(), name.end(), word.begin(), small);
    constexpr std::array<std::string_view, 3> kSilentH{"hour", "honest", "heir"};
    constexpr std::array<std::string_view, 6> kLikeYouOrWon{"uni", "use", "usu",
                                                            "uti", "eu",  "one"};
    const auto begins = [&](std::string_view start) { return word.starts_with(start); };
    if (std::any_of(kSilentH.begin(), kSilentH.end(), begins)) return true;
    if (std::any_of(kLikeYouOrWon.begin(), kLikeYouOrWon.end(), begins)) return false;
    return std::string_view("aeiou").find(word[0]) != std::string_view::npos;
}

}  // namespace

std::string withArticle(const std::string& name) {
    // "2 solids" are several.
    const bool several = !name.empty() && name[0] >= '2' && name[0] <= '9' && name.find(' ') == 1 &&
                         name.back() == 's';
    if (several) return name;
    return (startsWithVowelSound(name) ? "an " : "a ") + name;
}

}  // namespace ew
