// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/replay.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QUndoStack>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/document/report.h"
#include "core/document/resources.h"
#include "core/document/store.h"
#include "core/tlib/template_io.h"
#include "tests/document/fixtures.h"

namespace ew {
namespace {

using nlohmann::json;
using test::fakeDocument;

SketchScript script(const std::string& steps) {
    auto read = readSketchScript(
        R"({"format": "edgewright-sketch", "version": 1, "viewport": [640, 480],
            "thresholds": {"distance_px": 9}, "steps": [)" +
        steps + "]}");
    EXPECT_TRUE(read) << read.error().message;
    return read ? *read : SketchScript{};
}

const char* const kStroke = R"({"do": "stroke", "points": [[100, 100], [105, 103]]})";

TEST(Replay, BeginsWithTheHeadOfTheScript) {
    const auto d = fakeDocument();
    ASSERT_TRUE(d->addStroke(test::line({0, 0}, {1, 1})));
    const auto report = replay(*d, script(kStroke), {});
    EXPECT_EQ(report.firstFailure(), nullptr);
    EXPECT_EQ(d->camera().width, 640);
    EXPECT_EQ(d->thresholds().distancePx, 9);
    EXPECT_EQ(d->thresholds().angleDeg, 12);
    EXPECT_EQ(d->pendingStrokes().size(), 1U);
}

TEST(Replay, FindsStepsByIndexAndByName) {
    const SketchScript s = script(std::string(kStroke) + R"(, {"do": "apply"}, )" + kStroke +
                                  R"(, {"do": "apply"}, {"do": "clear"})");
    const std::vector<std::pair<std::string, std::size_t>> known{
        {"0", 0},       {"4", 4},       {"5", 5},        {"apply", 1},
        {"apply:1", 1}, {"apply:2", 3}, {"stroke:2", 2}, {"clear", 4}};
    for (const auto& [name, index] : known) {
        const auto found = findStep(s, name);
        ASSERT_TRUE(found) << name;
        EXPECT_EQ(*found, index) << name;
    }
    for (const char* bad : {"", "6", "-1", "1.5", "apply:3", "apply:0", "apply:", "apply:x",
                            "fillet", ":1", "99999999999999999999"}) {
        const auto found = findStep(s, bad);
        ASSERT_FALSE(found) << bad;
        EXPECT_EQ(found.error().code, Errc::BadValue) << bad;
    }
}

TEST(Replay, NormalisesDirectionsAndMergesCameras) {
    const auto d = fakeDocument();
    const auto report = replay(
        *d,
        script(
            R"({"do": "camera", "direction": [0, 3, -4]}, {"do": "camera", "world_per_pixel": 2})"),
        {});
    EXPECT_EQ(report.firstFailure(), nullptr);
    EXPECT_NEAR((d->camera().direction - Vec3(0, 0.6, -0.8)).norm(), 0, 1e-15);
    EXPECT_EQ(d->camera().worldPerPixel, 2);
    const auto bad = replay(*d, script(R"({"do": "camera", "up": [-2, 2, -2]})"), {});
    ASSERT_NE(bad.firstFailure(), nullptr);
    EXPECT_EQ(bad.firstFailure()->error->code, Errc::BadValue);
}

struct FailingStep {
    const char* step;
    Errc code;
};

TEST(Replay, FailingStepsLeaveTheDocumentAsItWas) {
    const std::vector<FailingStep> table{
        {R"({"do": "stroke", "points": []})", Errc::EmptySketch},
        {R"({"do": "stroke", "points": [[1e308, 0]]})", Errc::BadCoordinates},
        {R"({"do": "erase", "at": [600, 10]})", Errc::NoStroke},
        {R"({"do": "apply", "candidate": 9})", Errc::UnknownCandidate},
        {R"({"do": "apply", "template": "nothing"})", Errc::UnknownTemplate},
        {R"({"do": "apply", "operation": "add"})", Errc::OperationImpossible},
        {R"({"do": "fillet", "edges": "concave", "radius": 1})", Errc::NoEdge},
        {R"({"do": "fillet", "edges": "all", "radius": 1e300})", Errc::BadValue},
        {R"({"do": "fillet", "edges": "all", "radius": 1, "segments": 17})", Errc::BadValue},
        {R"({"do": "fillet", "edges": [[0, 0, 0, 9]], "radius": 1})", Errc::NoEdge},
        {R"({"do": "sharpen", "edges": "all"})", Errc::NoEdge},
        {R"({"do": "crease", "edges": "concave", "sharpness": 2})", Errc::NoEdge},
        {R"({"do": "subdivide", "scheme": "loop", "tolerance": 1e-12})", Errc::TooMuchMemory},
        {R"({"do": "map_strokes"})", Errc::NoSurface},
        {R"({"do": "unmap_strokes"})", Errc::NoStroke},
        {R"({"do": "define_template", "id": "x", "name": "X", "from": "solid"})",
         Errc::BadTemplate},
        {R"({"do": "undo", "count": 5})", Errc::NothingToUndo},
        {R"({"do": "redo"})", Errc::NothingToRedo},
        {R"({"do": "save", "path": "/tmp/x.edgewright"})", Errc::BadValue},
        {R"({"do": "save", "path": "../x.edgewright"})", Errc::BadValue},
        {R"({"do": "save", "path": "a/../../x.edgewright"})", Errc::BadValue},
        {R"({"do": "open", "path": "missing.edgewright"})", Errc::FileNotFound},
        {R"({"do": "export", "path": "/tmp/x.obj"})", Errc::BadValue},
        {R"({"do": "export", "path": ".."})", Errc::BadValue},
        {R"({"do": "export", "path": "x.blend"})", Errc::UnknownExtension},
    };
    const QTemporaryDir folder;
    ReplayOptions options{folder.path(), folder.path(), false};
    const auto d = fakeDocument();
    // Two bodies, and ink that can be read.
    const std::string two = std::string(kStroke) + R"(, {"do": "apply"}, )" + kStroke +
                            R"(, {"do": "apply"}, )" + kStroke;
    ASSERT_EQ(replay(*d, script(two), options).firstFailure(), nullptr);
    const auto state = &d->state();
    for (const FailingStep& failing : table) {
        const SketchScript one = script(failing.step);
        const StepReport report = runStep(*d, one.steps[0], 7, options);
        ASSERT_FALSE(report.ok) << failing.step;
        EXPECT_EQ(report.error->code, failing.code) << failing.step;
        EXPECT_FALSE(report.error->message.empty());
        EXPECT_EQ(report.index, 7);
        EXPECT_EQ(&d->state(), state) << failing.step;
        EXPECT_EQ(d->pendingStrokes().size(), 1U) << failing.step;
        EXPECT_EQ(d->undoStack().index(), 2) << failing.step;
    }
    EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

TEST(Replay, ARadiusAThousandTimesTooLargeIsClampedAndSaidSo) {
    const auto d = fakeDocument();
    const std::string box = std::string(kStroke) + R"(, {"do": "apply"}, )";
    const auto report =
        replay(*d, script(box + R"({"do": "fillet", "edges": "all", "radius": 5000})"), {});
    ASSERT_EQ(report.firstFailure(), nullptr);
    const StepReport& fillet = report.steps.back();
    EXPECT_EQ(fillet.notes.size(), d->shape()->clamped.size());
    ASSERT_FALSE(fillet.notes.empty());
    for (const std::string& note : fillet.notes) {
        EXPECT_NE(note.find("instead of 5000 mm"), std::string::npos) << note;
    }
}

TEST(Replay, StopsAtTheFirstFailureOrKeepsGoing) {
    const std::string steps =
        std::string(R"({"do": "apply"}, )") + kStroke + R"(, {"do": "apply"})";
    const auto d = fakeDocument();
    auto report = replay(*d, script(steps), {});
    ASSERT_EQ(report.steps.size(), 1U);
    EXPECT_EQ(report.firstFailure()->error->code, Errc::EmptySketch);
    EXPECT_TRUE(d->state().bodies.empty());
    ReplayOptions keepGoing;
    keepGoing.keepGoing = true;
    report = replay(*d, script(steps), keepGoing);
    ASSERT_EQ(report.steps.size(), 3U);
    EXPECT_EQ(report.firstFailure()->index, 0);
    EXPECT_EQ(d->state().bodies.size(), 1U);
    int told = 0;
    replay(*d, script(steps), keepGoing, [&](const StepReport&) { return ++told < 2; });
    EXPECT_EQ(told, 2);
}

TEST(Replay, SavesOpensAndExportsInItsFolders) {
    const QTemporaryDir scripts;
    const QTemporaryDir out;
    const auto d = fakeDocument();
    const std::string steps =
        std::string(kStroke) +
        R"(, {"do": "apply"}, {"do": "save", "path": "kept/a.edgewright"}, {"do": "undo"}, {"do": "clear"},
            {"do": "open", "path": "kept/a.edgewright"}, {"do": "export", "path": "deep/er/box.obj"},
            {"do": "undo"}, {"do": "redo"})";
    const auto report = replay(*d, script(steps), {scripts.path(), out.path(), false});
    ASSERT_EQ(report.firstFailure(), nullptr) << report.firstFailure()->error->message;
    EXPECT_EQ(d->state().bodies.size(), 1U);
    EXPECT_TRUE(QFileInfo(out.filePath("kept/a.edgewright")).isFile());
    EXPECT_TRUE(QFileInfo(out.filePath("deep/er/box.obj")).isFile());
    EXPECT_TRUE(QDir(scripts.path()).isEmpty());
}

TEST(Replay, OpensWhatItSavedAndElseWhatLiesBesideTheScript) {
    const QTemporaryDir scripts;
    const QTemporaryDir out;
    const auto boxes = [](int count) {
        std::string steps;
        for (int i = 0; i < count; ++i) {
            steps += std::string(kStroke) + R"(, {"do": "apply"}, )";
        }
        return steps;
    };
    const ReplayOptions options{scripts.path(), out.path(), false};
    const auto run = [&](const std::string& steps, const ReplayOptions& with) {
        const auto d = fakeDocument();
        const auto report = replay(*d, script(steps), with);
        EXPECT_EQ(report.firstFailure(), nullptr) << report.firstFailure()->error->message;
        return d->state().bodies.size();
    };
    const std::string save = R"({"do": "save", "path": "a.edgewright"})";
    const std::string open = R"({"do": "open", "path": "a.edgewright"})";
    run(boxes(1) + save, {{}, scripts.path(), false});
    run(boxes(2) + save, options);
    EXPECT_EQ(run(open, {scripts.path(), out.path(), false}), 1U) << "beside the script";
    EXPECT_EQ(run(boxes(3) + save + R"(, {"do": "undo"}, )" + open, options), 3U) << "just saved";
    EXPECT_EQ(run(open, {{}, out.path(), false}), 3U);
}

TEST(Replay, LeavesOutWhatWritesOrOpensFiles) {
    const QTemporaryDir folder;
    ReplayOptions options{folder.path(), folder.path(), false};
    options.leaveOutFiles = true;
    const auto d = fakeDocument();
    const auto report = replay(*d, script(std::string(kStroke) + R"(, {"do": "apply"},
        {"do": "save", "path": "a.edgewright"}, {"do": "export", "path": "/a.obj"},
        {"do": "open", "path": "none.edgewright"}, {"do": "undo"}, {"do": "redo"})"),
                               options);
    ASSERT_EQ(report.firstFailure(), nullptr);
    ASSERT_EQ(report.steps.size(), 7U);
    for (const StepReport& step : report.steps) {
        EXPECT_EQ(step.leftOut, step.index >= 2 && step.index <= 4) << step.index;
    }
    EXPECT_EQ(d->state().bodies.size(), 1U);
    EXPECT_TRUE(QDir(folder.path()).isEmpty());
}

TEST(Report, HasTheKeysOfTheContract) {
    const auto d = fakeDocument();
    ReplayOptions keepGoing;
    keepGoing.keepGoing = true;
    const std::string steps = std::string(kStroke) + "," + kStroke + R"(, {"do": "apply"},
        {"do": "apply", "candidate": 1}, {"do": "clear"})";
    const auto done = replay(*d, script(steps), keepGoing);
    const json report = json::parse(writeReport(*d, done, "box.json"));
    EXPECT_EQ(report["format"], "edgewright-report");
    EXPECT_EQ(report["version"], 1);
    EXPECT_EQ(report["script"], "box.json");
    ASSERT_EQ(report["steps"].size(), 5U);
    for (const json& s : report["steps"]) {
        for (const char* key : {"index", "do", "ok", "ms", "edge_graph", "match", "error"}) {
            EXPECT_TRUE(s.contains(key)) << key;
        }
    }
    const json& failed = report["steps"][2];
    EXPECT_EQ(failed["ok"], false);
    EXPECT_EQ(failed["error"]["code"], "ambiguous");
    EXPECT_TRUE(failed["error"]["where"].is_array());
    EXPECT_TRUE(failed["match"].is_null());
    EXPECT_EQ(failed["candidates"].size(), 2U);
    EXPECT_EQ(failed["edge_graph"]["vertices"].size(), 2U);

    const json& applied = report["steps"][3];
    EXPECT_EQ(applied["ok"], true);
    EXPECT_TRUE(applied["error"].is_null());
    EXPECT_EQ(applied["edge_graph"]["edges"][0]["ends"], json({0, 1}));
    EXPECT_EQ(applied["edge_graph"]["edges"][0]["from"], "stroke");
    EXPECT_EQ(applied["edge_graph"]["noise"]["strokes"], 1);  // the dot; an overshoot is no stroke
    EXPECT_EQ(applied["edge_graph"]["noise"]["model_edges"], 0);
    EXPECT_EQ(applied["match"]["template"], "box");
    EXPECT_EQ(applied["match"]["operation"], "create");
    EXPECT_EQ(applied["match"]["aspect"], "explicit-3");
    EXPECT_EQ(applied["match"]["residual_px"], 0.25);
    EXPECT_EQ(applied["match"]["candidates"].size(), 2U);
    EXPECT_EQ(applied["match"]["candidates"][0]["score"], 1.0);

    // 6 x 4 x 4.5, moved to (10, 20, 30).
    const json& solid = report["solid"];
    EXPECT_EQ(solid["vertices"], 8);
    EXPECT_EQ(solid["edges"], 12);
    EXPECT_EQ(solid["faces"], 6);
    EXPECT_EQ(solid["shells"], 1);
    EXPECT_EQ(solid["genus"], 0);
    EXPECT_EQ(solid["closed"], true);
    EXPECT_NEAR(solid["volume"].get<double>(), 108, 1e-9);
    EXPECT_NEAR(solid["area"].get<double>(), 2 * (24 + 27 + 18), 1e-9);
    EXPECT_EQ(solid["bounds"], json({{10.0, 20.0, 30.0}, {16.0, 24.0, 34.5}}));
    EXPECT_EQ(solid["vertex_positions"].size(), 8U);
    EXPECT_EQ(report["surface"]["triangles"], 0);
    EXPECT_EQ(report["undo"], json({{"index", 1}, {"count", 1}}));
    EXPECT_GE(report["ms_total"].get<double>(), 0);
}

TEST(Report, AFailedStepHasTheSameKeysAsOneThatWorked) {
    const auto d = fakeDocument();
    ReplayOptions keepGoing;
    keepGoing.keepGoing = true;
    const std::string steps = R"({"do": "camera", "direction": [0, 0, -1]},
        {"do": "stroke", "points": [[1e308, 0]]}, {"do": "erase", "at": [1, 2]}, {"do": "apply"},
        {"do": "fillet", "edges": "all", "radius": 1}, {"do": "sharpen", "edges": [[1, 2, 3]]},
        {"do": "crease", "edges": "convex", "sharpness": "auto"},
        {"do": "subdivide", "scheme": "loop", "levels": 1}, {"do": "map_strokes"},
        {"do": "unmap_strokes"},
        {"do": "define_template", "id": "x", "name": "X", "from": "solid"}, {"do": "delete_solid"},
        {"do": "undo"}, {"do": "redo", "count": 2}, {"do": "save", "path": "../x"},
        {"do": "open", "path": "no.edgewright"}, {"do": "export", "path": "x.obj"})";
    const auto done = replay(*d, script(steps), keepGoing);
    const json report = json::parse(writeReport(*d, done, "failing.json"));
    ASSERT_EQ(report["steps"].size(), 17U);
    int index = 0;
    for (const json& s : report["steps"]) {
        SCOPED_TRACE(s["do"]);
        EXPECT_EQ(s["index"], index++);
        EXPECT_EQ(s["ok"], false);
        EXPECT_TRUE(s["ms"].is_number());
        EXPECT_TRUE(s.contains("edge_graph") && s.contains("match"));
        EXPECT_TRUE(s["match"].is_null());
        ASSERT_EQ(s["error"].size(), 3U);
        EXPECT_FALSE(s["error"]["code"].get<std::string>().empty());
        EXPECT_FALSE(s["error"]["message"].get<std::string>().empty());
        EXPECT_TRUE(s["error"]["where"].is_array());
    }
    EXPECT_TRUE(report["solid"].is_null());
    EXPECT_EQ(report["surface"]["triangles"], 0);
    EXPECT_EQ(report["surface"]["closed"], true);
    EXPECT_EQ(report["surface"]["volume"], 0.0);
    EXPECT_EQ(report["surface"]["max_deviation"], 0.0);
    EXPECT_EQ(report["undo"], json({{"index", 0}, {"count", 0}}));
    EXPECT_TRUE(report["ms_total"].is_number());
}

TEST(Report, SaysNullWhereThereIsNoSolid) {
    const auto d = fakeDocument();
    const json report = json::parse(writeReport(*d, {}, "empty.json"));
    EXPECT_TRUE(report["solid"].is_null());
    EXPECT_TRUE(report["steps"].empty());
}

TEST(Report, AddsUpSeveralBodies) {
    const auto d = fakeDocument();
    const std::string twice =
        std::string(kStroke) + R"(, {"do": "apply"}, )" + kStroke + R"(, {"do": "apply"})";
    ASSERT_EQ(replay(*d, script(twice), {}).firstFailure(), nullptr);
    const SolidSummary sum = summarize(d->state().bodies);
    EXPECT_EQ(sum.vertices, 16);
    EXPECT_EQ(sum.shells, 2);
    EXPECT_NEAR(sum.volume, 2 * 48, 1e-9);
}

TEST(PathInside, KeepsToItsFolder) {
    EXPECT_EQ(*pathInside("/a/b", "c.obj"), "/a/b/c.obj");
    EXPECT_EQ(*pathInside("/a/b", "c/../d/e.obj"), "/a/b/d/e.obj");
    for (const char* bad : {"/c.obj", "..", "../c.obj", "c/../../d.obj", ".", "c/..", "c/"}) {
        const auto path = pathInside("/a/b", bad);
        ASSERT_FALSE(path) << bad;
        EXPECT_EQ(path.error().code, Errc::BadValue);
    }
}

TEST(PathInside, ALinkThatLeadsOutIsOutside) {
    const QTemporaryDir folder;
    const std::filesystem::path root = QFileInfo(folder.path()).filesystemCanonicalFilePath();
    std::filesystem::create_directories(root / "out" / "deep");
    std::filesystem::create_directories(root / "away");
    std::ofstream(root / "away" / "there.obj") << "mine";
    std::filesystem::create_directory_symlink("../away", root / "out" / "folder");
    std::filesystem::create_symlink("../away/there.obj", root / "out" / "file.obj");
    std::filesystem::create_symlink("../away/later.obj", root / "out" / "dangling.obj");
    std::filesystem::create_symlink("round.obj", root / "out" / "round.obj");
    std::filesystem::create_directory_symlink("deep", root / "out" / "inside");
    std::filesystem::create_directory_symlink("out", root / "linked");
    const QString out = folder.filePath("out");
    for (const char* bad : {"folder/a.obj", "folder/there.obj", "folder/new/a.obj", "file.obj",
                            "dangling.obj", "deep/../folder/a.obj"}) {
        const auto path = pathInside(out, bad);
        ASSERT_FALSE(path) << bad;
        EXPECT_EQ(path.error().code, Errc::BadValue);
        EXPECT_NE(path.error().message.find("symbolic link"), std::string::npos);
    }
    for (const char* good : {"a.obj", "deep/a.obj", "inside/a.obj", "new/folder/a.obj"}) {
        EXPECT_TRUE(pathInside(out, good)) << good;
        EXPECT_TRUE(pathInside(folder.filePath("linked"), good)) << good;
    }
}

TEST(Resources, MergesShippedAndPersonalTemplates) {
    const QTemporaryDir shipped;
    const QTemporaryDir personal;
    const auto put = [](const QTemporaryDir& dir, const char* file, const Template& t) {
        ASSERT_TRUE(writeFileBytes(dir.filePath(file), writeTemplate(t)));
    };
    put(shipped, "box.json", test::boxTemplate("box", "Box"));
    put(personal, "a.json", test::boxTemplate("box", "Other box"));
    put(personal, "b.json", test::boxTemplate("slab", "Slab"));
    ASSERT_TRUE(writeFileBytes(personal.filePath("c.json"), "{"));
    const auto load = loadTemplates(shipped.path(), personal.path());
    ASSERT_TRUE(load) << load.error().message;
    EXPECT_EQ(load->library.size(), 2U);
    EXPECT_GE(load->library.find("slab"), 0);
    ASSERT_EQ(load->problems.size(), 2U);
    EXPECT_EQ(load->problems[1].code, Errc::DuplicateId);
    EXPECT_TRUE(loadTemplates(shipped.path(), personal.filePath("missing")));
    EXPECT_EQ(loadTemplates(shipped.filePath("missing"), {}).error().code, Errc::FileNotFound);
}

TEST(Resources, FindsTheShippedTemplates) {
    const auto folder = resourcesFolder();
    ASSERT_TRUE(folder) << folder.error().message;
    const auto load = loadTemplates();
    ASSERT_TRUE(load) << load.error().message;
    for (const Error& problem : load->problems) ADD_FAILURE() << problem.message;
    EXPECT_GE(load->library.find("cube"), 0);
}

}  // namespace
}  // namespace ew
