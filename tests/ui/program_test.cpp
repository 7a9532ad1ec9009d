// SPDX-License-Identifier: GPL-3.0-or-later
// The programs with a window or a picture, as a person calls them: exit status and messages.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImageReader>
#include <QProcess>
#include <QTemporaryDir>

#include "core/document/document.h"
#include "core/document/file_bytes.h"
#include "tests/document/full_disk.h"

namespace ew::test {
namespace {

struct Outcome {
    int status = -1;
    std::string out, err;
};

class Programs : public testing::Test {
  protected:
    /// \param display  empty: none.
    Outcome run(const QString& program, const QStringList& arguments, const QString& display) {
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
            environment.remove(name);
        }
        if (!display.isEmpty()) environment.insert("DISPLAY", display);
        environment.insert("XDG_CONFIG_HOME", folder_.filePath("config"));
        environment.insert("XDG_DATA_HOME", folder_.filePath("data"));
        environment.insert("LANG", "C.UTF-8");
        process.setProcessEnvironment(environment);
        process.setWorkingDirectory(folder_.path());
        process.start(QCoreApplication::applicationDirPath() + "/../../app/" + program, arguments);
        EXPECT_TRUE(process.waitForFinished(60'000)) << process.errorString().toStdString();
        EXPECT_EQ(process.exitStatus(), QProcess::NormalExit) << "it crashed";
        return {process.exitCode(), process.readAllStandardOutput().toStdString(),
                process.readAllStandardError().toStdString()};
    }
    QString display() const { return qEnvironmentVariable("DISPLAY"); }
    QString path(const char* name) const { return folder_.filePath(name); }
    QTemporaryDir folder_;
};

TEST_F(Programs, WordsNeedNoDisplay) {
    for (const char* program : {"edgewright", "edgewright-render"}) {
        SCOPED_TRACE(program);
        const Outcome version = run(program, {"--version"}, {});
        EXPECT_EQ(version.status, 0) << version.err;
        EXPECT_NE(version.out.find(EDGEWRIGHT_VERSION), std::string::npos) << version.out;
        const Outcome help = run(program, {"--help"}, {});
        EXPECT_EQ(help.status, 0) << help.err;
        EXPECT_NE(help.out.find("Usage: "), std::string::npos) << help.out;
    }
}

TEST_F(Programs, WithoutADisplayTheySaySo) {
    for (const QString& none : {QString(), QStringLiteral(":98765")}) {
        for (const char* program : {"edgewright", "edgewright-render"}) {
            SCOPED_TRACE(program);
            const Outcome r = run(program, {}, none);
            EXPECT_EQ(r.status, 2);
            EXPECT_NE(r.err.find("There is no display"), std::string::npos) << r.err;
        }
    }
}

TEST_F(Programs, UnusableArgumentsAndFilesAreStatusTwo) {
    EXPECT_EQ(run("edgewright", {"--bogus"}, display()).status, 2);
    EXPECT_EQ(run("edgewright", {"a", "b", "--screenshot", "p.png"}, display()).status, 2);
    EXPECT_EQ(run("edgewright", {"--language", "tlh"}, display()).status, 2);
    EXPECT_EQ(run("edgewright-render", {"--bogus"}, display()).status, 2);
    const Outcome missing = run("edgewright", {"none.json", "--screenshot", "p.png"}, display());
    EXPECT_EQ(missing.status, 2);
    EXPECT_NE(missing.err.find("none.json"), std::string::npos) << missing.err;
    EXPECT_EQ(run("edgewright", {"--screenshot", "p.png"}, display()).status, 0);
    EXPECT_EQ(run("edgewright", {"--screenshot", "no/folder/p.png"}, display()).status, 2);
}

TEST_F(Programs, APictureOnAFullDiskIsAFailure) {
    ASSERT_TRUE(QDir(folder_.path()).mkdir("disk"));
    const SmallDisk disk(path("disk").toStdString());
    if (!disk.mounted()) GTEST_SKIP() << "a small disk may not be mounted here";
    ASSERT_TRUE(Document(TemplateLibrary()).save(path("d.edgewright")));
    ASSERT_TRUE(writeFileBytes(path("disk/p.png"), "mine"));
    disk.fill();
    EXPECT_EQ(run("edgewright", {"--screenshot", "disk/p.png"}, display()).status, 2);
    const Outcome r = run("edgewright-render", {"d.edgewright", "disk/p.png", "64x64"}, display());
    EXPECT_EQ(r.status, 3);
    EXPECT_NE(r.err.find("no room left"), std::string::npos) << r.err;
    EXPECT_EQ(*readFileBytes(path("disk/p.png"), 100), "mine");
    EXPECT_EQ(run("edgewright-render", {"d.edgewright", "p.png", "64x64"}, display()).status, 0);
    EXPECT_TRUE(QFileInfo(path("p.png")).isFile());
}

TEST_F(Programs, APictureIsWhatItsNameSays) {
    ASSERT_TRUE(Document(TemplateLibrary()).save(path("d.edgewright")));
    const std::vector<std::pair<QString, QByteArray>> table{
        {"p.png", "png"}, {"p.jpg", "jpeg"}, {"P.JPEG", "jpeg"}, {"p.bmp", "bmp"}, {"p", "png"}};
    for (const auto& [name, format] : table) {
        SCOPED_TRACE(name.toStdString());
        for (const QString& program :
             {QStringLiteral("edgewright"), QStringLiteral("edgewright-replay")}) {
            QFile::remove(folder_.filePath(name));
            QStringList arguments{"--screenshot", name};
            if (program != "edgewright") arguments = QStringList{"d.edgewright"} + arguments;
            const Outcome r = run(program, arguments, display());
            EXPECT_EQ(r.status, 0) << r.err;
            EXPECT_EQ(QImageReader::imageFormat(folder_.filePath(name)), format);
        }
    }
    // A document is read while the window is there already; the program ends all the same.
    const Outcome opened = run("edgewright", {"d.edgewright", "--screenshot", "o.png"}, display());
    EXPECT_EQ(opened.status, 0) << opened.err;
    EXPECT_EQ(run("edgewright", {"d.edgewright", "--first-frame"}, display()).status, 0);
    for (const char* name : {"p.gif", "p.xyz"}) {
        SCOPED_TRACE(name);
        const Outcome window = run("edgewright", {"--screenshot", name}, display());
        EXPECT_EQ(window.status, 2);
        EXPECT_NE(window.err.find("names no format"), std::string::npos) << window.err;
        const Outcome replay =
            run("edgewright-replay", {"d.edgewright", "--screenshot", name}, display());
        EXPECT_EQ(replay.status, 2);
        EXPECT_NE(replay.err.find("(cannot-write)"), std::string::npos) << replay.err;
        EXPECT_FALSE(QFileInfo::exists(path(name)));
    }
    const Outcome seenThrough = run(
        "edgewright-replay", {"d.edgewright", "--screenshot", "t.jpg", "--transparent"}, display());
    EXPECT_EQ(seenThrough.status, 2);
    EXPECT_NE(seenThrough.err.find("cannot be transparent"), std::string::npos) << seenThrough.err;
}

}  // namespace
}  // namespace ew::test
