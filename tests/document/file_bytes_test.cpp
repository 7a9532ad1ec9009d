// SPDX-License-Identifier: GPL-3.0-or-later
// The one way to write a file: full disks, links, permissions, what is no plain file.
#include "core/document/file_bytes.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <QFile>
#include <QTemporaryDir>
#include <filesystem>
#include <functional>
#include <thread>

#include "core/document/export_mesh.h"
#include "tests/document/fixtures.h"
#include "tests/document/full_disk.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

struct FileBytes : ::testing::Test {
    QString path(const char* name) const { return folder_.filePath(name); }
    std::string local(const char* name) const { return path(name).toStdString(); }
    std::string read(const char* name) const {
        const auto bytes = readFileBytes(path(name), 1U << 24U);
        EXPECT_TRUE(bytes) << bytes.error().message;
        return bytes ? *bytes : std::string();
    }
    std::size_t fileCount() const {
        const fs::path folder = folder_.path().toStdString();
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
    }
    struct stat status(const char* name) const {
        struct stat out {};
        EXPECT_EQ(::lstat(local(name).c_str(), &out), 0);
        return out;
    }
    QTemporaryDir folder_;
};

TEST_F(FileBytes, ANewFileHasTheUsualPermissions) {
    const mode_t mask = ::umask(027);
    ASSERT_TRUE(writeFileBytes(path("a"), "new"));
    ::umask(mask);
    EXPECT_EQ(read("a"), "new");
    EXPECT_EQ(status("a").st_mode & 07777U, 0640U);
    EXPECT_EQ(fileCount(), 1U);
}

TEST_F(FileBytes, AnOldFileKeepsPermissionsOwnerAndAttributes) {
    ASSERT_TRUE(writeFileBytes(path("a"), "old"));
    ASSERT_EQ(::chmod(local("a").c_str(), 0600), 0);
    const bool tagged = ::setxattr(local("a").c_str(), "user.tag", "x", 1, 0) == 0;
    const bool given = ::chown(local("a").c_str(), 12345, 23456) == 0;  // as root only
    ASSERT_TRUE(writeFileBytes(path("a"), "new and longer"));
    EXPECT_EQ(read("a"), "new and longer");
    EXPECT_EQ(status("a").st_mode & 07777U, 0600U);
    if (given) {
        EXPECT_EQ(status("a").st_uid, 12345U);
        EXPECT_EQ(status("a").st_gid, 23456U);
    }
    if (tagged) {
        char value = 0;
        EXPECT_EQ(::getxattr(local("a").c_str(), "user.tag", &value, 1), 1);
        EXPECT_EQ(value, 'x');
    }
    EXPECT_EQ(fileCount(), 1U);
}

TEST_F(FileBytes, LinksAreFollowed) {
    fs::create_directories(local("deep"));
    ASSERT_TRUE(writeFileBytes(path("deep/file"), "old"));
    fs::create_symlink("deep/file", local("one"));
    fs::create_symlink("one", local("two"));
    ASSERT_TRUE(writeFileBytes(path("two"), "new"));
    EXPECT_EQ(read("deep/file"), "new");
    EXPECT_TRUE(fs::is_symlink(local("one")) && fs::is_symlink(local("two")));
    // Also to a file that is not there yet.
    fs::create_symlink("deep/later", local("dangling"));
    ASSERT_TRUE(writeFileBytes(path("dangling"), "new"));
    EXPECT_EQ(read("deep/later"), "new");
    EXPECT_TRUE(fs::is_symlink(local("dangling")));
    fs::create_symlink("round", local("round"));
    const auto round = writeFileBytes(path("round"), "new");
    ASSERT_FALSE(round);
    EXPECT_EQ(round.error().code, Errc::CannotWrite);
}

TEST_F(FileBytes, AFileWithTwoNamesStaysOne) {
    ASSERT_TRUE(writeFileBytes(path("a"), "old and long"));
    fs::create_hard_link(local("a"), local("b"));
    ASSERT_TRUE(writeFileBytes(path("a"), "new"));
    EXPECT_EQ(read("a"), "new");
    EXPECT_EQ(read("b"), "new");
    EXPECT_EQ(status("a").st_ino, status("b").st_ino);
}

TEST_F(FileBytes, WhatIsNoPlainFileStaysWhatItIs) {
    ASSERT_EQ(::mkfifo(local("pipe").c_str(), 0600), 0);
    std::string got;
    std::thread reader([&] {
        char buffer[64];
        const int in = ::open(local("pipe").c_str(), O_RDONLY);
        for (ssize_t n = 0; (n = ::read(in, buffer, sizeof(buffer))) > 0;) {
            got.append(buffer, static_cast<std::size_t>(n));
        }
        ::close(in);
    });
    EXPECT_TRUE(writeFileBytes(path("pipe"), "through"));
    reader.join();
    EXPECT_EQ(got, "through");
    EXPECT_TRUE(S_ISFIFO(status("pipe").st_mode));
    EXPECT_TRUE(writeFileBytes("/dev/null", "away"));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    const auto full = writeFileBytes("/dev/full", "away");
    ASSERT_FALSE(full);
    EXPECT_NE(full.error().message.find("no room left"), std::string::npos) << full.error().message;
    EXPECT_FALSE(writeFileBytes(folder_.path(), "a folder"));
    EXPECT_FALSE(writeFileBytes("", "nowhere"));
    EXPECT_EQ(fileCount(), 1U);
}

TEST_F(FileBytes, ADescriptorOfTheProgramIsWrittenToAsItIs) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const QString number = QString::number(ends[1]);
    EXPECT_TRUE(writeFileBytes("/proc/self/fd/" + number, "one "));
    EXPECT_TRUE(writeFileBytes("/dev/fd/" + number, "two "));
    EXPECT_TRUE(writeFileBytes(QStringLiteral("/proc/%1/fd/").arg(::getpid()) + number, "three"));
    ASSERT_TRUE(QFile::link("/dev/fd/" + number, path("link")));
    EXPECT_TRUE(writeFileBytes(path("link"), "!"));
    ::close(ends[1]);
    char buffer[64];
    const ssize_t n = ::read(ends[0], buffer, sizeof(buffer));
    EXPECT_EQ(std::string(buffer, static_cast<std::size_t>(std::max<ssize_t>(n, 0))),
              "one two three!");
    ::close(ends[0]);
    EXPECT_FALSE(writeFileBytes("/dev/fd/" + number, "closed"));
    // A file that stdout was sent to keeps what was said before.
    const int file = ::open(local("log").c_str(), O_WRONLY | O_CREAT, 0600);
    ASSERT_EQ(::write(file, "said ", 5), 5);
    EXPECT_TRUE(writeFileBytes("/dev/fd/" + QString::number(file), "more "));
    ASSERT_EQ(::write(file, "end", 3), 3);
    ::close(file);
    EXPECT_EQ(read("log"), "said more end");
}

TEST_F(FileBytes, StampsTellOneWritingFromAnother) {
    EXPECT_FALSE(fileStamp(path("a")));
    ASSERT_TRUE(writeFileBytes(path("a"), "same"));
    const auto first = fileStamp(path("a"));
    ASSERT_TRUE(first);
    EXPECT_EQ(fileStamp(path("a")), first);
    ASSERT_TRUE(writeFileBytes(path("a"), "same"));
    EXPECT_NE(fileStamp(path("a")), first);
}

/// A disk of its own with a document and nothing free, for everything that writes.
struct FullDisk : FileBytes {
    void SetUp() override {
        document_ = test::fakeDocument();
        ASSERT_TRUE(document_->addStroke(test::line({0, 0}, {5, 5})));
        ASSERT_TRUE(document_->apply());
        disk_ = std::make_unique<test::SmallDisk>(folder_.path().toStdString());
        if (!disk_->mounted()) GTEST_SKIP() << "a small disk may not be mounted here";
    }
    std::unique_ptr<Document> document_;
    std::unique_ptr<test::SmallDisk> disk_;
};

TEST_F(FullDisk, AFailedWritingLeavesWhatWasThere) {
    const auto saves = [&](const QString& to) { return document_->save(to); };
    const auto exports = [&](const QString& to) -> Result<void> {
        const auto note = document_->exportTo(to);
        if (!note) return fail(note.error());
        return {};
    };
    const auto writes = [&](const QString& to) { return writeFileBytes(to, "a few bytes"); };
    struct Case {
        const char* name;
        std::function<Result<void>(const QString&)> write;
    };
    const std::vector<Case> cases{{"d.edgewright", saves}, {"m.obj", exports}, {"m.stl", exports},
                                  {"m.ply", exports},      {"m.glb", exports}, {"m.3mf", exports},
                                  {"r.json", writes}};
    for (const Case& c : cases) ASSERT_TRUE(c.write(path(c.name))) << c.name;
    ASSERT_TRUE(writeFileBytes(path("twice"), "a few bytes"));
    fs::create_hard_link(local("twice"), local("again"));
    disk_->fill();
    const std::size_t files = fileCount();
    for (const Case& c : cases) {
        SCOPED_TRACE(c.name);
        const std::string before = read(c.name);
        ASSERT_FALSE(before.empty());
        const auto done = c.write(path(c.name));
        ASSERT_FALSE(done);
        EXPECT_EQ(done.error().code, Errc::CannotWrite);
        EXPECT_NE(done.error().message.find("no room left on the disk"), std::string::npos)
            << done.error().message;
        EXPECT_EQ(read(c.name), before);
        const auto other = c.write(path((std::string("new-") + c.name).c_str()));
        EXPECT_FALSE(other);
    }
    EXPECT_FALSE(writeFileBytes(path("twice"), std::string(100'000, 'x')));
    EXPECT_EQ(read("twice"), "a few bytes");
    EXPECT_EQ(fileCount(), files) << "nothing was left behind";
    EXPECT_EQ(document_->filePath(), path("d.edgewright"));
}

}  // namespace
}  // namespace ew
