// SPDX-License-Identifier: GPL-3.0-or-later
// The programs with a window or a picture, as a person calls them: exit status and messages.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
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
    EXPECT_EQ(run("edgewright", {"a", "b"}, display()).status, 2);
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

}  // namespace
}  // namespace ew::test
