// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/lint/source_rules.h"

namespace ew::test {

/// A section of the paper ("4.1.2") and a file that has to do with it.
using PaperLink = std::pair<std::string, std::string>;

/// The links of docs/paper-map.md: of every table row whose first cell is a section number, the
/// paths between backquotes in the other cells (what has a slash and no space is a path).
std::set<PaperLink> linksOfMap(const std::string& markdown);

/// The links of the sources: every tag of that name, a backslash before it and a section in braces
/// behind it, in a comment that starts its line.
std::set<PaperLink> linksOfTags(const SourceTree& tree);

/// What map and tags do not agree in: a file of the map that is not there or lacks the tag, a tag
/// that the map lacks. In the order of sections and files.
std::vector<std::string> comparePaperMap(const std::string& markdown, const SourceTree& tree);

}  // namespace ew::test
