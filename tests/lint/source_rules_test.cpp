// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/lint/source_rules.h"

#include <gtest/gtest.h>

namespace ew::test {
namespace {

const std::string kLicence = "// SPDX-License-Identifier: GPL-3.0-or-later\n";

/// The findings of one synthetic tree, as texts; every file gets the licence line, so that its own
/// first line is line 2.
std::vector<std::string> findings(SourceTree tree) {
    for (auto& [file, text] : tree) text = kLicence + text;
    std::vector<std::string> out;
    for (const Finding& f : checkSources(tree)) out.push_back(f.text());
    return out;
}

using Texts = std::vector<std::string>;

TEST(SourceRules, RoomsAboveMayBeIncluded) {
    EXPECT_EQ(findings({{"core/tlib/a.cpp",
                         "#include \"core/tlib/a.h\"\n#include \"core/base/vec.h\"\n"
                         "#include \"core/solid/solid.h\"\n#include <vector>\n"},
                        {"ui/main_window.cpp",
                         "#include \"core/document/document.h\"\n#include <QMenu>\n"},
                        {"app/main.cpp", "#include \"ui/main_window.h\"\n"}}),
              Texts{});
}

TEST(SourceRules, RoomsBelowMayNot) {
    EXPECT_EQ(findings({{"core/stroke/a.cpp", "#include <cmath>\n#include \"core/tlib/t.h\"\n"},
                        {"core/document/d.h", "  #  include \"ui/actions.h\"\n"},
                        {"ui/a.cpp", "#include \"app/b.h\"\n"}}),
              (Texts{"core/document/d.h:2: core/document includes ui/actions.h of a room below it",
                     "core/stroke/a.cpp:3: core/stroke includes core/tlib/t.h of a room below it",
                     "ui/a.cpp:2: ui includes app/b.h of a room below it"}));
}

TEST(SourceRules, EveryRoomIsOrdered) {
    const std::vector<std::string> order{"core/base",
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
    for (std::size_t from = 0; from < order.size(); ++from) {
        for (std::size_t to = 0; to < order.size(); ++to) {
            const SourceTree tree{{order[from] + "/a.cpp", "#include \"" + order[to] + "/b.h\"\n"}};
            EXPECT_EQ(findings(tree).size(), to > from ? 1U : 0U)
                << order[from] << " -> " << order[to];
        }
    }
}

TEST(SourceRules, TheProgramDoesNotIncludeTests) {
    EXPECT_EQ(findings({{"core/base/a.cpp", "#include \"tests/support/random.h\"\n"}}),
              Texts{"core/base/a.cpp:2: the program includes tests/support/random.h of the tests"});
}

TEST(SourceRules, QuotedIncludesArePathsFromTheRoot) {
    EXPECT_EQ(findings({{"core/base/a.cpp", "#include \"vec.h\"\n"},
                        {"ui/w.cpp", "#include \"w.moc\"\n"}}),
              Texts{"core/base/a.cpp:2: \"vec.h\" is no path from the project root"});
}

TEST(SourceRules, QtStaysInItsRooms) {
    for (const char* header : {"QString", "QtGui/QImage", "qtguiglobal.h",
                               "qpa/qwindowsysteminterface.h", "private/qguiapplication_p.h"}) {
        const std::string include = std::string("#include <") + header + ">\n";
        EXPECT_EQ(findings({{"core/reading/a.h", include}}),
                  Texts{std::string("core/reading/a.h:2: Qt is not for this room: ") + header});
        EXPECT_EQ(
            findings({{"core/document/a.h", include}, {"ui/a.h", include}, {"app/a.cpp", include}}),
            Texts{});
    }
}

TEST(SourceRules, SolidLibrariesStayInTheirRooms) {
    const std::string cgal = "#include <CGAL/Epick.h>\n";
    const std::string openMesh = "#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>\n";
    EXPECT_EQ(findings({{"core/solid/a.cpp", cgal + openMesh}, {"core/surface/a.h", cgal}}),
              Texts{});
    EXPECT_EQ(
        findings({{"core/tlib/a.cpp", cgal}}),
        Texts{
            "core/tlib/a.cpp:2: OpenMesh, CGAL and OpenSubdiv is not for this room: CGAL/Epick.h"});
}

TEST(SourceRules, PrivateHeadersDoNotLeaveTheirRoomEvenThroughOthers) {
    EXPECT_EQ(
        findings({{"core/solid/kernel.h", "#include <CGAL/Epick.h>\n"},
                  {"core/solid/brep.h", "#include \"core/solid/kernel.h\"\n"},
                  {"core/solid/brep.cpp", "#include \"core/solid/brep.h\"\n"},
                  {"core/surface/fillet.cpp", "#include \"core/solid/kernel.h\"\n"},
                  {"core/reading/a.cpp", "#include <vector>\n#include \"core/solid/brep.h\"\n"}}),
        Texts{"core/reading/a.cpp:3: core/solid/brep.h brings OpenMesh, CGAL and OpenSubdiv into a "
              "room that is not to know it"});
}

TEST(SourceRules, SqliteStaysInTheStore) {
    const std::string sqlite = "#include <sqlite3.h>\n";
    EXPECT_EQ(findings({{"core/store/database.cpp", sqlite}}), Texts{});
    EXPECT_EQ(findings({{"core/document/store.cpp", sqlite}}),
              Texts{"core/document/store.cpp:2: SQLite is not for this room: sqlite3.h"});
}

TEST(SourceRules, VtkStaysInTheViewport) {
    EXPECT_EQ(findings({{"ui/viewport/scene.cpp", "#include <vtkActor.h>\n"},
                        {"ui/viewport/scene.h", "#include <vtkNew.h>\n"},
                        {"ui/panels/a.cpp", "#include <vtkActor.h>\n"},
                        {"ui/main_window.cpp", "#include \"ui/viewport/scene.h\"\n"}}),
              (Texts{"ui/main_window.cpp:2: ui/viewport/scene.h brings VTK into a room that is not "
                     "to know it",
                     "ui/panels/a.cpp:2: VTK is not for this room: vtkActor.h"}));
}

TEST(SourceRules, FilesAreWrittenInOnePlace) {
    EXPECT_EQ(findings({{"core/document/file_bytes.cpp", "open(path, O_WRONLY);\n"},
                        {"tests/document/a.cpp", "std::ofstream(path);\n"},
                        {"core/tlib/a.cpp", "std::ifstream(path);\n"}}),
              Texts{});
    EXPECT_EQ(findings({{"app/a.cpp", "QSaveFile file(path);\n"},
                        {"ui/actions/a.cpp", "std::ofstream file(path);\n"}}),
              (Texts{"app/a.cpp:2: QSaveFile: write through writeFileBytes()",
                     "ui/actions/a.cpp:2: ofstream: write through writeFileBytes()"}));
}

TEST(SourceRules, FilesAreShortAndLicensed) {
    const std::string lines(kLongestFile - 1, '\n');
    EXPECT_EQ(findings({{"tests/base/a.cpp", lines}}), Texts{});
    EXPECT_EQ(findings({{"tests/base/a.cpp", lines + "x"}}),
              Texts{"tests/base/a.cpp:501: 501 lines, more than 500"});
    const auto bare = checkSources({{"core/base/a.h", "#pragma once\n"}});
    ASSERT_EQ(bare.size(), 1U);
    EXPECT_EQ(bare[0].text(), "core/base/a.h:1: does not start with the licence line");
}

TEST(SourceRules, TheProjectKeepsThem) {
    const SourceTree tree = readSourceTree(EDGEWRIGHT_SOURCE_DIR);
    ASSERT_TRUE(tree.contains("core/base/vec.h"));
    ASSERT_TRUE(tree.contains("tests/lint/source_rules_test.cpp"));
    for (const Finding& f : checkSources(tree)) ADD_FAILURE() << f.text();
}

}  // namespace
}  // namespace ew::test
