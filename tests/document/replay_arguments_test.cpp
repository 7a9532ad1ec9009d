// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/replay_arguments.h"

#include <gtest/gtest.h>

namespace ew {
namespace {

TEST(ReplayArguments, ReadsAll) {
    const auto a = parseReplayArguments({"s.json",       "--out",    "o",
                                         "--export",     "a.obj",    "b.stl",
                                         "--screenshot", "p.png",    "--size",
                                         "800x600",      "--report", "r.json",
                                         "--until",      "apply:2",  "--keep-going",
                                         "--templates",  "t",        "--allow-outside",
                                         "--faces",      "polygons"});
    ASSERT_TRUE(a) << a.error().message;
    EXPECT_EQ(a->script, "s.json");
    EXPECT_EQ(a->outFolder, "o");
    EXPECT_EQ(a->exports, (QStringList{"a.obj", "b.stl"}));
    EXPECT_EQ(a->screenshot, "p.png");
    EXPECT_EQ(a->size, QSize(800, 600));
    EXPECT_EQ(a->report, "r.json");
    EXPECT_EQ(a->until, "apply:2");
    EXPECT_EQ(a->templates, "t");
    EXPECT_TRUE(a->keepGoing);
    EXPECT_TRUE(a->allowOutside);
    EXPECT_EQ(a->faces, ExportFaces::Polygons);
}

TEST(ReplayArguments, ReadsHowThePictureLooks) {
    const auto a = parseReplayArguments(
        {"s.json", "--screenshot", "p.png", "--transparent", "--hidden-edges"});
    ASSERT_TRUE(a);
    EXPECT_TRUE(a->look.transparent && a->look.hiddenEdges);
    EXPECT_FALSE(a->look.cage || a->look.dark);
    EXPECT_EQ(lookOptions(a->look), (QStringList{"--transparent", "--hidden-edges"}));
    for (const QString& option : lookOptions({true, true, true, true, true})) {
        EXPECT_TRUE(replayHelp().contains(option)) << option.toStdString();
    }
}

TEST(ReplayArguments, HasDefaults) {
    const auto a = parseReplayArguments({"s.json"});
    ASSERT_TRUE(a);
    EXPECT_EQ(a->outFolder, ".");
    EXPECT_TRUE(a->exports.isEmpty());
    EXPECT_FALSE(a->keepGoing);
    EXPECT_FALSE(a->allowOutside);
    EXPECT_EQ(a->faces, ExportFaces::Simple);
    EXPECT_FALSE(a->size);
}

TEST(ReplayArguments, TakesTheScriptBehindTheExports) {
    const auto a =
        parseReplayArguments({"--export", "a.obj", "b.ply", "s.json", "--export", "c.stl"});
    ASSERT_TRUE(a);
    EXPECT_EQ(a->script, "s.json");
    EXPECT_EQ(a->exports, (QStringList{"a.obj", "b.ply", "c.stl"}));
}

TEST(ReplayArguments, HelpAndVersionNeedNoScript) {
    EXPECT_TRUE(parseReplayArguments({"--help"})->help);
    EXPECT_TRUE(parseReplayArguments({"--version"})->version);
    EXPECT_TRUE(replayHelp().contains("--keep-going"));
}

TEST(ReplayArguments, RefusesTheRest) {
    const std::vector<std::pair<QStringList, Errc>> table{
        {{}, Errc::MissingKey},
        {{"--keep-going"}, Errc::MissingKey},
        {{"s.json", "--bogus"}, Errc::UnknownKey},
        {{"s.json", "-x"}, Errc::UnknownKey},
        {{"s.json", "--out=o"}, Errc::UnknownKey},
        {{"s.json", "--out"}, Errc::MissingKey},
        {{"s.json", "--out", "--keep-going"}, Errc::MissingKey},
        {{"s.json", "--export"}, Errc::MissingKey},
        {{"s.json", "--report", ""}, Errc::BadValue},
        {{"s.json", "t.json"}, Errc::BadValue},
        {{"s.json", "--size", "800x600"}, Errc::BadValue},
        {{"s.json", "--dark"}, Errc::BadValue},
        {{"s.json", "--faces", "round"}, Errc::BadValue},
        {{"s.json", "--faces"}, Errc::MissingKey},
        {{"s.json", "--screenshot", "p.png", "--size", "800"}, Errc::BadValue},
        {{"s.json", "--screenshot", "p.png", "--size", "8x600"}, Errc::BadValue},
        {{"s.json", "--screenshot", "p.png", "--size", "99999x600"}, Errc::BadValue},
        {{"s.json", "--screenshot", "p.png", "--size", "800x600x1"}, Errc::BadValue},
    };
    for (const auto& [arguments, code] : table) {
        const auto a = parseReplayArguments(arguments);
        ASSERT_FALSE(a) << arguments.join(' ').toStdString();
        EXPECT_EQ(a.error().code, code) << arguments.join(' ').toStdString();
    }
}

}  // namespace
}  // namespace ew
