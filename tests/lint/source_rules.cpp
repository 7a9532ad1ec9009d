// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/lint/source_rules.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <tuple>

namespace ew::test {
namespace {

/// From top to bottom; a room includes only what stands above it.
constexpr std::array<std::string_view, 20> kRooms{"core/base",
                                                  "core/stroke",
                                                  "core/hand",
                                                  "core/edge_graph",
                                                  "core/solid",
                                                  "core/tlib",
                                                  "core/reading/types",
                                                  "core/reading/extract",
                                                  "core/reading/evidence",
                                                  "core/reading/solve",
                                                  "core/reading/overlay",
                                                  "core/reading/score",
                                                  "core/reading/explain",
                                                  "core/reading/propose",
                                                  "core/reading",
                                                  "core/surface",
                                                  "core/store",
                                                  "core/document",
                                                  "ui",
                                                  "app"};

bool isUnder(std::string_view path, std::string_view folder) {
    return path.size() > folder.size() && path.starts_with(folder) && path[folder.size()] == '/';
}

bool isUnderAny(std::string_view path, const std::vector<std::string_view>& folders) {
    return std::any_of(folders.begin(), folders.end(),
                       [&](std::string_view f) { return isUnder(path, f); });
}

/// Index into kRooms, -1 where the path is in none (tests, other libraries).
int roomOf(std::string_view path) {
    for (std::size_t i = 0; i < kRooms.size(); ++i) {
        if (isUnder(path, kRooms[i])) return static_cast<int>(i);
    }
    return -1;
}

struct Include {
    int line = 0;
    std::string path;
    bool quoted = false;
};

std::vector<Include> includesOf(const std::string& text) {
    std::vector<Include> out;
    std::istringstream in(text);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        std::size_t i = line.find_first_not_of(" \t");
        if (i == std::string::npos || line[i] != '#') continue;
        i = line.find_first_not_of(" \t", i + 1);
        if (i == std::string::npos || line.compare(i, 7, "include") != 0) continue;
        i = line.find_first_of("<\"", i + 7);
        if (i == std::string::npos) continue;
        const char close = line[i] == '<' ? '>' : '"';
        const std::size_t end = line.find(close, i + 1);
        if (end == std::string::npos) continue;
        out.push_back({number, line.substr(i + 1, end - i - 1), close == '"'});
    }
    return out;
}

/// A library that only some folders may know.
struct Library {
    std::string_view name;
    std::vector<std::string_view> folders;  ///< where it may be included
    bool headersToo;  ///< headers that bring it along must not leave the folders either
    bool (*owns)(std::string_view header);
};

bool isQtHeader(std::string_view h) {
    if (h.starts_with("qpa/") || h.starts_with("private/q") || h.starts_with("qt")) return true;
    return h.size() > 1 && h[0] == 'Q' &&
           (h[1] == 't' || std::isupper(static_cast<unsigned char>(h[1])) != 0);
}
bool isSolidLibraryHeader(std::string_view h) {
    return h.starts_with("OpenMesh/") || h.starts_with("CGAL/") || h.starts_with("opensubdiv/");
}
bool isSqliteHeader(std::string_view h) { return h.starts_with("sqlite3"); }
bool isVtkHeader(std::string_view h) { return h.starts_with("vtk"); }

const std::vector<Library>& libraries() {
    static const std::vector<Library> all{
        {"Qt", {"core/document", "ui", "app"}, false, isQtHeader},
        {"OpenMesh, CGAL and OpenSubdiv",
         {"core/solid", "core/surface"},
         true,
         isSolidLibraryHeader},
        {"SQLite", {"core/store"}, true, isSqliteHeader},
        {"VTK", {"ui/viewport"}, true, isVtkHeader},
    };
    return all;
}

using IncludeMap = std::map<std::string, std::vector<Include>>;

/// Headers that include the library, themselves or through others.
std::set<std::string> carriers(const IncludeMap& includes, const Library& library) {
    std::set<std::string> found;
    for (bool grown = true; grown;) {
        grown = false;
        for (const auto& [file, list] : includes) {
            if (!file.ends_with(".h") || found.contains(file)) continue;
            const bool carries = std::any_of(list.begin(), list.end(), [&](const Include& i) {
                return library.owns(i.path) || found.contains(i.path);
            });
            if (!carries) continue;
            found.insert(file);
            grown = true;
        }
    }
    return found;
}

void checkLibraries(const IncludeMap& includes, std::vector<Finding>& out) {
    for (const Library& library : libraries()) {
        const std::set<std::string> carrying =
            library.headersToo ? carriers(includes, library) : std::set<std::string>{};
        for (const auto& [file, list] : includes) {
            if (roomOf(file) < 0 || isUnderAny(file, library.folders)) continue;
            for (const Include& i : list) {
                if (library.owns(i.path)) {
                    out.push_back({file, i.line,
                                   std::string(library.name) + " is not for this room: " + i.path});
                } else if (carrying.contains(i.path)) {
                    out.push_back({file, i.line,
                                   i.path + " brings " + std::string(library.name) +
                                       " into a room that is not to know it"});
                }
            }
        }
    }
}

void checkDirection(const std::string& file, const std::vector<Include>& list,
                    std::vector<Finding>& out) {
    const int room = roomOf(file);
    if (room < 0) return;
    for (const Include& i : list) {
        if (isUnder(i.path, "tests")) {
            out.push_back({file, i.line, "the program includes " + i.path + " of the tests"});
            continue;
        }
        const int target = roomOf(i.path);
        if (target > room) {
            out.push_back({file, i.line,
                           std::string(kRooms[static_cast<std::size_t>(room)]) + " includes " +
                               i.path + " of a room below it"});
        }
        if (i.quoted && target < 0 && !i.path.ends_with(".moc")) {
            out.push_back({file, i.line, "\"" + i.path + "\" is no path from the project root"});
        }
    }
}

/// Files are written by one function, which loses nothing on a full disk.
void checkWriters(const std::string& file, const std::string& text, std::vector<Finding>& out) {
    constexpr std::string_view kWriter = "core/document/file_bytes.cpp";
    constexpr std::array<std::string_view, 6> kWays{
        "QSaveFile", "QTemporaryFile", "QFile::WriteOnly", "ofstream", "fopen(", "O_WRONLY"};
    if (roomOf(file) < 0 || file == kWriter) return;
    std::istringstream in(text);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        for (const std::string_view way : kWays) {
            if (line.find(way) == std::string::npos) continue;
            out.push_back({file, number, std::string(way) + ": write through writeFileBytes()"});
        }
    }
}

void checkText(const std::string& file, const std::string& text, std::vector<Finding>& out) {
    const auto lines = static_cast<int>(std::count(text.begin(), text.end(), '\n')) +
                       (text.empty() || text.back() == '\n' ? 0 : 1);
    if (lines > kLongestFile) {
        out.push_back(
            {file, kLongestFile + 1,
             std::to_string(lines) + " lines, more than " + std::to_string(kLongestFile)});
    }
    if (!text.starts_with("// SPDX-License-Identifier: GPL-3.0-or-later\n")) {
        out.push_back({file, 1, "does not start with the licence line"});
    }
}

}  // namespace

std::string Finding::text() const { return file + ":" + std::to_string(line) + ": " + message; }

std::vector<Finding> checkSources(const SourceTree& tree) {
    std::vector<Finding> out;
    IncludeMap includes;
    for (const auto& [file, text] : tree) {
        includes[file] = includesOf(text);
        checkText(file, text, out);
        checkWriters(file, text, out);
        checkDirection(file, includes[file], out);
    }
    checkLibraries(includes, out);
    std::sort(out.begin(), out.end(), [](const Finding& a, const Finding& b) {
        return std::tie(a.file, a.line, a.message) < std::tie(b.file, b.line, b.message);
    });
    return out;
}

SourceTree readSourceTree(const std::string& root) {
    namespace fs = std::filesystem;
    SourceTree tree;
    for (const char* top : {"core", "ui", "app", "tests"}) {
        if (!fs::is_directory(fs::path(root) / top)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(root) / top)) {
            const std::string extension = entry.path().extension().string();
            if (!entry.is_regular_file() || (extension != ".h" && extension != ".cpp")) continue;
            std::ifstream in(entry.path(), std::ios::binary);
            std::ostringstream text;
            text << in.rdbuf();
            tree[entry.path().lexically_relative(root).generic_string()] = text.str();
        }
    }
    return tree;
}

}  // namespace ew::test
