// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace ew {

/// A name with its indefinite article, for English sentences: "a Cube", "an Octagon", "an L-prism"
/// (a letter that is spelled), "a U-profile"; "2 solids" has none. Spelling decides, but for a few
/// words.
std::string withArticle(const std::string& name);

}  // namespace ew
