// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/lint/paper_map.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace ew::test {
namespace {

const std::string kMap =
    "| section | files |\n"
    "| --- | --- |\n"
    "| 4.1 | `core/a.h` (`struct A`), `core/b.h` |\n"
    "| 6 | `b.h` beside it |\n"
    "Not a row: `core/c.h`\n";

TEST(PaperMap, RowsAndTagsAreRead) {
    EXPECT_EQ(linksOfMap(kMap), (std::set<PaperLink>{{"4.1", "core/a.h"}, {"4.1", "core/b.h"}}));
    EXPECT_EQ(
        linksOfTags({{"core/a.h", "/// An A. \\paper{4.1} \\paper{6.2}\nf(\"\\paper{9}\");\n"},
                     {"core/b.h", "    // \\paper{4.1}\n"}}),
        (std::set<PaperLink>{{"4.1", "core/a.h"}, {"4.1", "core/b.h"}, {"6.2", "core/a.h"}}));
}

TEST(PaperMap, DifferencesAreFoundBothWays) {
    const SourceTree whole{{"core/a.h", "/// \\paper{4.1}\n"}, {"core/b.h", "/// \\paper{4.1}\n"}};
    EXPECT_EQ(comparePaperMap(kMap, whole), std::vector<std::string>{});
    EXPECT_EQ(comparePaperMap(kMap, {{"core/a.h", "/// \\paper{4.2}\n"}}),
              (std::vector<std::string>{"core/a.h lacks \\paper{4.1}",
                                        "the map names core/b.h at 4.1, which is not there",
                                        "core/a.h has \\paper{4.2}, the map does not name it"}));
}

TEST(PaperMap, OfTheProjectAgreesWithItsTags) {
    std::ifstream in(EDGEWRIGHT_SOURCE_DIR "/docs/paper-map.md");
    std::ostringstream text;
    text << in.rdbuf();
    EXPECT_GE(linksOfMap(text.str()).size(), 30U);
    for (const std::string& finding :
         comparePaperMap(text.str(), readSourceTree(EDGEWRIGHT_SOURCE_DIR))) {
        ADD_FAILURE() << finding;
    }
}

}  // namespace
}  // namespace ew::test
