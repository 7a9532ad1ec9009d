// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

namespace ew::test {

/// A breach of a house rule.
struct Finding {
    std::string file;  ///< path from the project root
    int line = 0;      ///< from 1
    std::string message;

    /// "file:line: message".
    std::string text() const;
};

/// Path from the project root -> content.
using SourceTree = std::map<std::string, std::string>;

inline constexpr int kLongestFile = 500;  ///< [lines]

/// Checks the rules of the house on C++ sources:
/// - a room includes only itself and rooms above it: base, stroke, edge_graph, solid, tlib,
///   reading, surface (core/...), core/document, ui, app; none of them includes tests. The rooms
///   of core/reading are in order too: types, extract, evidence, solve, overlay, score, explain,
///   propose;
/// - project headers are included by their path from the root;
/// - Qt in core/document, ui and app only; OpenMesh, CGAL and OpenSubdiv in core/solid and
///   core/surface only; VTK in ui/viewport only. A header that includes such a library, itself or
///   through others, must not be included outside these folders either (Qt excepted);
/// - the program writes files through core/document/file_bytes.h only;
/// - no file is longer than kLongestFile lines; each starts with its licence.
/// \return findings in file and line order.
std::vector<Finding> checkSources(const SourceTree& tree);

/// The *.h and *.cpp files under core, ui, app and tests of a project folder.
SourceTree readSourceTree(const std::string& root);

}  // namespace ew::test
