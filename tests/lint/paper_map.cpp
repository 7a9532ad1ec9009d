// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/lint/paper_map.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>

namespace ew::test {
namespace {

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

bool isSection(std::string_view text) {
    return !text.empty() && text.front() != '.' && text.back() != '.' &&
           std::all_of(text.begin(), text.end(),
                       [](unsigned char c) { return std::isdigit(c) != 0 || c == '.'; });
}

bool isPath(std::string_view text) {
    return text.find('/') != std::string_view::npos && text.find(' ') == std::string_view::npos;
}

}  // namespace

std::set<PaperLink> linksOfMap(const std::string& markdown) {
    std::set<PaperLink> links;
    std::istringstream in(markdown);
    std::string line;
    while (std::getline(in, line)) {
        if (!line.starts_with("|")) continue;
        const std::size_t bar = line.find('|', 1);
        if (bar == std::string::npos) continue;
        const std::string section(trimmed(std::string_view(line).substr(1, bar - 1)));
        if (!isSection(section)) continue;
        for (std::size_t open = line.find('`', bar); open != std::string::npos;) {
            const std::size_t close = line.find('`', open + 1);
            if (close == std::string::npos) break;
            const std::string text = line.substr(open + 1, close - open - 1);
            if (isPath(text)) links.emplace(section, text);
            open = line.find('`', close + 1);
        }
    }
    return links;
}

std::set<PaperLink> linksOfTags(const SourceTree& tree) {
    constexpr std::string_view kTag = "\\paper{";
    std::set<PaperLink> links;
    for (const auto& [file, text] : tree) {
        std::istringstream in(text);
        std::string line;
        while (std::getline(in, line)) {
            if (!trimmed(line).starts_with("//")) continue;
            for (std::size_t at = line.find(kTag); at != std::string::npos;) {
                const std::size_t begin = at + kTag.size();
                const std::size_t end = line.find('}', begin);
                if (end == std::string::npos) break;
                links.emplace(line.substr(begin, end - begin), file);
                at = line.find(kTag, end);
            }
        }
    }
    return links;
}

std::vector<std::string> comparePaperMap(const std::string& markdown, const SourceTree& tree) {
    const std::set<PaperLink> map = linksOfMap(markdown);
    const std::set<PaperLink> tags = linksOfTags(tree);
    std::set<PaperLink> all = map;
    all.insert(tags.begin(), tags.end());
    std::vector<std::string> findings;
    for (const PaperLink& link : all) {
        const auto& [section, file] = link;
        if (!map.contains(link)) {
            findings.push_back(file + " has \\paper{" + section + "}, the map does not name it");
        } else if (!tree.contains(file)) {
            findings.push_back("the map names " + file + " at " + section + ", which is not there");
        } else if (!tags.contains(link)) {
            findings.push_back(file + " lacks \\paper{" + section + "}");
        }
    }
    return findings;
}

}  // namespace ew::test
