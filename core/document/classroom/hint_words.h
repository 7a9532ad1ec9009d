// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace ew {

/// What the code of a hint means, in a few words for the middle of a sentence: "a line is missing"
/// for "missing-edge". The code itself where there are no words for it.
std::string hintWords(const std::string& code);

}  // namespace ew
