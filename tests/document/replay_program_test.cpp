// SPDX-License-Identifier: GPL-3.0-or-later
// The program edgewright-replay as a person calls it: exit status, files, messages.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <nlohmann/json.hpp>

#include "core/document/resources.h"
#include "core/document/sketch_script.h"
#include "core/document/store.h"
#include "tests/document/full_disk.h"

namespace ew {
namespace {

struct Outcome {
    int status = -1;
    std::string out, err;
};

class ReplayProgram : public ::testing::Test {
  protected:
    Outcome run(const QStringList& arguments, const QString& path = qEnvironmentVariable("PATH")) {
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        // Nothing of this may need a display, and the person's own templates stay out.
        environment.remove("DISPLAY");
        environment.remove("WAYLAND_DISPLAY");
        environment.insert("PATH", path);
        environment.insert("XDG_DATA_HOME", folder_.filePath("data"));
        process.setProcessEnvironment(environment);
        if (!output_.isEmpty()) process.setStandardOutputFile(output_);
        process.start(QCoreApplication::applicationDirPath() + "/../app/edgewright-replay",
                      arguments);
        EXPECT_TRUE(process.waitForFinished(60'000)) << process.errorString().toStdString();
        EXPECT_EQ(process.exitStatus(), QProcess::NormalExit);
        return {process.exitCode(), process.readAllStandardOutput().toStdString(),
                process.readAllStandardError().toStdString()};
    }

    void script(const QString& name, const std::string& steps) {
        ASSERT_TRUE(writeFileBytes(
            folder_.filePath(name),
            R"({"format": "edgewright-sketch", "version": 1, "steps": [)" + steps + "]}"));
    }

    bool exists(const QString& name) const { return QFileInfo(folder_.filePath(name)).isFile(); }

    QString output_;  ///< where what is printed goes to; empty: into the outcome
    QTemporaryDir folder_;
};

TEST_F(ReplayProgram, AWorkingCopyHoldsEvenAViewThatNothingIsDrawnIn) {
    script("view.json", R"({"do": "camera", "center": [7, 8, 9]})");
    EXPECT_EQ(run({"view.json", "--work-copy", "copies"}).status, 0);
    const Outcome found = run({"--recover", "copies", "--out", "back"});
    EXPECT_EQ(found.status, 0) << found.err;
    const auto list = nlohmann::json::parse(found.out, nullptr, false);
    ASSERT_EQ(list.size(), 1U) << found.out;
    const std::string path = list[0]["restored"];
    const auto file = loadDocument(
        QDir(folder_.path()).absoluteFilePath(QString::fromStdString(path)), TemplateLibrary());
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_EQ(file->view.camera.center, Vec3(7, 8, 9));
}

TEST_F(ReplayProgram, SucceedsAndReports) {
    script("ok.json", R"({"do": "stroke", "points": [[1, 2], [3, 4]]}, {"do": "clear"})");
    const Outcome r = run({"ok.json", "--out", "a/b", "--report", "a/r.json"});
    EXPECT_EQ(r.status, 0) << r.err;
    EXPECT_TRUE(r.err.empty()) << r.err;
    EXPECT_NE(r.out.find("step 1 clear: done"), std::string::npos) << r.out;
    ASSERT_TRUE(exists("a/r.json"));
    const auto report =
        nlohmann::json::parse(*readFileBytes(folder_.filePath("a/r.json"), 1U << 20U));
    EXPECT_EQ(report["script"], "ok.json");
    EXPECT_EQ(report["steps"].size(), 2U);
}

TEST_F(ReplayProgram, NamesTheStepThatFailed) {
    script("fails.json", R"({"do": "clear"}, {"do": "apply"}, {"do": "undo"}, {"do": "clear"})");
    Outcome r = run({"fails.json", "--report", "r.json"});
    EXPECT_EQ(r.status, 1);
    EXPECT_NE(r.err.find("step 1 (apply)"), std::string::npos) << r.err;
    EXPECT_NE(r.err.find("empty-sketch"), std::string::npos) << r.err;
    auto report = nlohmann::json::parse(*readFileBytes(folder_.filePath("r.json"), 1U << 20U));
    EXPECT_EQ(report["steps"].size(), 2U);
    EXPECT_EQ(report["steps"][1]["error"]["code"], "empty-sketch");
    r = run({"fails.json", "--report", "r.json", "--keep-going"});
    EXPECT_EQ(r.status, 1);
    EXPECT_NE(r.err.find("step 1 (apply)"), std::string::npos) << r.err;
    report = nlohmann::json::parse(*readFileBytes(folder_.filePath("r.json"), 1U << 20U));
    EXPECT_EQ(report["steps"].size(), 4U);
}

TEST_F(ReplayProgram, RefusesUnusableInput) {
    script("ok.json", R"({"do": "clear"})");
    script("unknown.json", R"({"do": "stroke", "pts": []})");
    ASSERT_TRUE(writeFileBytes(folder_.filePath("cut.json"), "{\"format\": \"edge"));
    QFile huge(folder_.filePath("huge.json"));
    ASSERT_TRUE(huge.open(QIODevice::WriteOnly) && huge.resize(qint64{100} << 20U));
    EXPECT_EQ(run({}).status, 2);
    EXPECT_EQ(run({"missing.json"}).status, 2);
    EXPECT_EQ(run({"."}).status, 2);
    EXPECT_EQ(run({"cut.json"}).status, 2);
    EXPECT_EQ(run({"huge.json"}).status, 2);
    EXPECT_EQ(run({"ok.json", "--bogus"}).status, 2);
    EXPECT_EQ(run({"ok.json", "--templates", "missing"}).status, 2);
    EXPECT_EQ(run({"ok.json", "--out", "ok.json/x"}).status, 2);
    EXPECT_EQ(run({"ok.json", "--report", "no/such/folder/r.json"}).status, 2);
    const Outcome unknown = run({"unknown.json"});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_NE(unknown.err.find("step 0 (stroke): unknown key \"pts\""), std::string::npos)
        << unknown.err;
}

TEST_F(ReplayProgram, AnExportWithoutASolidFails) {
    script("ok.json", R"({"do": "clear"})");
    const Outcome r = run({"ok.json", "--export", "a.obj"});
    EXPECT_EQ(r.status, 1);
    EXPECT_NE(r.err.find("no-solid"), std::string::npos) << r.err;
    EXPECT_FALSE(exists("a.obj"));
    EXPECT_EQ(run({"ok.json", "--export", "a.blend"}).status, 2);
}

/// The nine visible edges of a box of 60 x 40 x 30, drawn exactly, and an apply.
SketchScript drawnBox() {
    SketchScript script;
    OrthographicCamera camera;
    camera.direction = Vec3(-1, 1.3, -0.8).normalized();
    script.steps.emplace_back(CameraStep{camera.direction, {}, {}, {}, {}});
    const auto corner = [&](int x, int y, int z) {
        return camera.project(Vec3(60 * x, 40 * y, 30 * z));
    };
    const std::vector<std::vector<Vec2>> polylines{
        {corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1), corner(0, 0, 1)},
        {corner(0, 0, 1), corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1)},
        {corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1)}};
    for (const auto& polyline : polylines) {
        StrokeStep stroke;
        for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
            constexpr int kPieces = 20;
            for (int k = 0; k < kPieces; ++k) {
                const double t = static_cast<double>(k) / kPieces;
                PenSample sample;
                sample.position = (1 - t) * polyline[i] + t * polyline[i + 1];
                stroke.stroke.samples.push_back(sample);
            }
        }
        PenSample last;
        last.position = polyline.back();
        stroke.stroke.samples.push_back(last);
        script.steps.emplace_back(std::move(stroke));
    }
    script.steps.emplace_back(ApplyStep{});
    return script;
}

TEST_F(ReplayProgram, MakesADrawnBoxSavesItAndOpensIt) {
    SketchScript box = drawnBox();
    box.steps.emplace_back(SaveStep{"box.edgewright"});
    ASSERT_TRUE(writeFileBytes(folder_.filePath("box.json"), writeSketchScript(box)));
    Outcome r = run({"box.json", "--report", "r.json", "--export", "a.obj", "a.stl", "a.ply"});
    ASSERT_EQ(r.status, 0) << r.err;
    EXPECT_NE(r.out.find("create cube"), std::string::npos) << r.out;
    for (const char* name : {"a.obj", "a.stl", "a.ply", "box.edgewright"}) {
        EXPECT_TRUE(exists(name)) << name;
    }
    auto report = nlohmann::json::parse(*readFileBytes(folder_.filePath("r.json"), 1U << 20U));
    EXPECT_NEAR(report["solid"]["volume"].get<double>(), 72'000, 72'000 * 1e-6);
    EXPECT_EQ(report["undo"]["index"], 1);
    const auto positions = report["solid"]["vertex_positions"];

    script("again.json",
           R"({"do": "open", "path": "box.edgewright"}, {"do": "undo"}, {"do": "redo"})");
    r = run({"again.json", "--report", "r.json"});
    ASSERT_EQ(r.status, 0) << r.err;
    report = nlohmann::json::parse(*readFileBytes(folder_.filePath("r.json"), 1U << 20U));
    EXPECT_EQ(report["solid"]["vertex_positions"], positions);

    script("ink.json",
           R"({"do": "open", "path": "box.edgewright"}, {"do": "undo"}, {"do": "apply"})");
    r = run({"ink.json", "--report", "r.json"});
    ASSERT_EQ(r.status, 0) << r.err;
    report = nlohmann::json::parse(*readFileBytes(folder_.filePath("r.json"), 1U << 20U));
    EXPECT_EQ(report["solid"]["vertex_positions"], positions);
}

TEST_F(ReplayProgram, ReplaysAnExampleToItsSurface) {
    const QString mouse = *resourcesFolder() + "/examples/mouse.json";
    const Outcome r = run({mouse, "--report", "r.json", "--export", "mouse.glb"});
    EXPECT_EQ(r.status, 0) << r.err;
    EXPECT_TRUE(exists("mouse.glb"));
    const auto report =
        nlohmann::json::parse(*readFileBytes(folder_.filePath("r.json"), 1U << 26U));
    EXPECT_EQ(report["surface"]["kind"], "surface");
    EXPECT_EQ(report["surface"]["closed"], true);
    // Up to the fillet there is the polyhedron.
    EXPECT_EQ(run({mouse, "--report", "r.json", "--until", "fillet"}).status, 0);
    const auto before =
        nlohmann::json::parse(*readFileBytes(folder_.filePath("r.json"), 1U << 26U));
    EXPECT_EQ(before["surface"]["kind"], "none");
    EXPECT_EQ(before["solid"]["faces"], report["solid"]["faces"]);
}

TEST_F(ReplayProgram, StopsBeforeTheStepThatWasNamed) {
    script("s.json", R"({"do": "clear"}, {"do": "undo"}, {"do": "clear"})");
    EXPECT_EQ(run({"s.json"}).status, 1);
    const Outcome r = run({"s.json", "--until", "undo", "--report", "r.json"});
    EXPECT_EQ(r.status, 0) << r.err;
    const auto report =
        nlohmann::json::parse(*readFileBytes(folder_.filePath("r.json"), 1U << 20U));
    EXPECT_EQ(report["steps"].size(), 1U);
    EXPECT_EQ(run({"s.json", "--until", "2"}).status, 1);
    const Outcome none = run({"s.json", "--until", "apply"});
    EXPECT_EQ(none.status, 2);
    EXPECT_NE(none.err.find("bad-value"), std::string::npos) << none.err;
}

TEST_F(ReplayProgram, SaysWhatAScreenshotNeeds) {
    script("ok.json", R"({"do": "clear"})");
    const Outcome r = run({"ok.json", "--screenshot", "p.png"}, "/no/such/folder");
    EXPECT_EQ(r.status, 2);
    EXPECT_NE(r.err.find("not-available"), std::string::npos) << r.err;
    EXPECT_FALSE(exists("p.png"));
}

TEST_F(ReplayProgram, AFullDiskIsSaidAndLosesNothing) {
    QDir(folder_.path()).mkdir("disk");
    const test::SmallDisk disk(folder_.filePath("disk").toStdString());
    if (!disk.mounted()) GTEST_SKIP() << "a small disk may not be mounted here";
    script("save.json", R"({"do": "clear"}, {"do": "save", "path": "d.edgewright"})");
    ASSERT_EQ(run({"save.json", "--out", "disk", "--report", "disk/r.json"}).status, 0);
    const auto document = readFileBytes(folder_.filePath("disk/d.edgewright"), 1U << 20U);
    const auto report = readFileBytes(folder_.filePath("disk/r.json"), 1U << 20U);
    ASSERT_TRUE(document && report);
    disk.fill();
    Outcome r = run({"save.json", "--out", "disk"});
    EXPECT_EQ(r.status, 1);
    EXPECT_NE(r.err.find("cannot-write"), std::string::npos) << r.err;
    script("clear.json", R"({"do": "clear"})");
    r = run({"clear.json", "--report", "disk/r.json"});
    EXPECT_EQ(r.status, 2);
    EXPECT_NE(r.err.find("no room left on the disk"), std::string::npos) << r.err;
    EXPECT_EQ(*readFileBytes(folder_.filePath("disk/d.edgewright"), 1U << 20U), *document);
    EXPECT_EQ(*readFileBytes(folder_.filePath("disk/r.json"), 1U << 20U), *report);
}

TEST_F(ReplayProgram, WritesBelowItsOutputFolderOnly) {
    SketchScript box = drawnBox();
    box.steps.emplace_back(SaveStep{"mine.edgewright"});
    box.steps.emplace_back(ExportStep{"notes.obj"});
    box.steps.emplace_back(OpenStep{"mine.edgewright"});
    ASSERT_TRUE(writeFileBytes(folder_.filePath("box.json"), writeSketchScript(box)));
    ASSERT_TRUE(writeFileBytes(folder_.filePath("mine.edgewright"), "mine"));
    ASSERT_TRUE(writeFileBytes(folder_.filePath("notes.obj"), "notes"));
    const Outcome r = run({"box.json", "--out", "out"});
    EXPECT_EQ(r.status, 0) << r.err;
    EXPECT_EQ(*readFileBytes(folder_.filePath("mine.edgewright"), 100), "mine");
    EXPECT_EQ(*readFileBytes(folder_.filePath("notes.obj"), 100), "notes");
    EXPECT_TRUE(exists("out/mine.edgewright") && exists("out/notes.obj"));

    const std::string absolute = folder_.filePath("abs.edgewright").toStdString();
    for (const std::string& path : {absolute, std::string("../up.edgewright")}) {
        script("away.json", R"({"do": "save", "path": ")" + path + "\"}");
        const Outcome refused = run({"away.json", "--out", "out"});
        EXPECT_EQ(refused.status, 1);
        EXPECT_NE(refused.err.find("--allow-outside"), std::string::npos) << refused.err;
        EXPECT_FALSE(exists("abs.edgewright") || exists("up.edgewright"));
    }
    script("away.json", R"({"do": "save", "path": ")" + absolute +
                            R"("}, {"do": "save", "path": "../up.edgewright"},
                               {"do": "open", "path": ")" +
                            absolute + "\"}");
    const Outcome allowed = run({"away.json", "--out", "out", "--allow-outside"});
    EXPECT_EQ(allowed.status, 0) << allowed.err;
    EXPECT_TRUE(exists("abs.edgewright") && exists("up.edgewright"));
}

TEST_F(ReplayProgram, ALinkBelowTheOutputFolderIsNoWayOut) {
    SketchScript box = drawnBox();
    box.steps.emplace_back(ExportStep{"away/notes.obj"});
    ASSERT_TRUE(writeFileBytes(folder_.filePath("box.json"), writeSketchScript(box)));
    ASSERT_TRUE(QDir(folder_.path()).mkpath("out") && QDir(folder_.path()).mkpath("elsewhere"));
    ASSERT_TRUE(QFile::link("../elsewhere", folder_.filePath("out/away")));
    const Outcome refused = run({"box.json", "--out", "out"});
    EXPECT_EQ(refused.status, 1);
    EXPECT_NE(refused.err.find("--allow-outside"), std::string::npos) << refused.err;
    EXPECT_FALSE(exists("elsewhere/notes.obj"));
    EXPECT_EQ(run({"box.json", "--out", "out", "--allow-outside"}).status, 0);
    EXPECT_TRUE(exists("elsewhere/notes.obj"));
}

TEST_F(ReplayProgram, TheReportGoesIntoThePipeThatStdoutIs) {
    ASSERT_TRUE(writeFileBytes(folder_.filePath("box.json"), writeSketchScript(drawnBox())));
    const Outcome r = run({"box.json", "--out", "out", "--report", "/dev/stdout"});
    EXPECT_EQ(r.status, 0) << r.err;
    EXPECT_NE(r.out.find("solid: 8 vertices"), std::string::npos) << r.out;
    EXPECT_NE(r.out.find("\"steps\""), std::string::npos) << r.out;
}

TEST_F(ReplayProgram, SaysWhatAFileOfAnotherKindIs) {
    const std::string stl = "solid box\nendsolid box\n";
    ASSERT_TRUE(writeFileBytes(folder_.filePath("bh.stl"), stl));
    const Outcome r = run({"bh.stl"});
    EXPECT_EQ(r.status, 2);
    EXPECT_NE(
        r.err.find("bh.stl is no Edgewright document or sketch script: it holds an STL mesh."),
        std::string::npos)
        << r.err;
    script("open.json", R"({"do": "open", "path": "bh.stl"})");
    const Outcome opened = run({"open.json"});
    EXPECT_EQ(opened.status, 1);
    EXPECT_NE(opened.err.find("it holds an STL mesh"), std::string::npos) << opened.err;
    EXPECT_NE(opened.err.find("wrong-format"), std::string::npos) << opened.err;
}

TEST_F(ReplayProgram, WhatCannotBeToldIsAFailure) {
    script("ok.json", R"({"do": "clear"})");
    EXPECT_EQ(run({"ok.json"}).status, 0);
    output_ = "/dev/full";
    EXPECT_EQ(run({"ok.json"}).status, 2);
}

TEST_F(ReplayProgram, HelpsAndTellsItsVersion) {
    const Outcome help = run({"--help"});
    EXPECT_EQ(help.status, 0);
    EXPECT_NE(help.out.find("--screenshot"), std::string::npos);
    const Outcome version = run({"--version"});
    EXPECT_EQ(version.status, 0);
    EXPECT_NE(version.out.find(EDGEWRIGHT_VERSION), std::string::npos);
}

}  // namespace
}  // namespace ew
