// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/recent_files.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QUrl>
#include <thread>

#include "core/document/file_bytes.h"
#include "core/document/file_names.h"

namespace ew {
namespace {

class Recent : public testing::Test {
  protected:
    QString file(const QString& name) {
        const QString path = folder_.filePath(name);
        EXPECT_TRUE(writeFileBytes(path, "x"));
        return path;
    }
    std::vector<std::string> names() const {
        std::vector<std::string> out;
        for (const RecentFile& f : recent_.list()) {
            out.push_back(QFileInfo(f.path).fileName().toStdString());
        }
        return out;
    }
    QTemporaryDir folder_;
    RecentFiles recent_{folder_.filePath("state/recent.json")};
};

using Names = std::vector<std::string>;

TEST_F(Recent, TheNewestComesFirstAndEachOnce) {
    EXPECT_TRUE(recent_.list().empty());
    for (const char* name : {"a", "b", "c", "a"}) ASSERT_TRUE(recent_.add(file(name), {}));
    EXPECT_EQ(names(), (Names{"a", "c", "b"}));
}

TEST_F(Recent, PinnedOnesStayInFront) {
    for (const char* name : {"a", "b", "c"}) ASSERT_TRUE(recent_.add(file(name), {}));
    ASSERT_TRUE(recent_.setPinned(file("a"), true));
    EXPECT_EQ(names(), (Names{"a", "c", "b"}));
    for (int i = 0; i < 2 * RecentFiles::kMost; ++i) {
        ASSERT_TRUE(recent_.add(file(QString::number(i)), {}));
    }
    EXPECT_EQ(names().size(), RecentFiles::kMost + 1U);
    EXPECT_EQ(names().front(), "a");
    ASSERT_TRUE(recent_.setPinned(file("a"), false));
    EXPECT_NE(names().front(), "a");
}

TEST_F(Recent, AFileThatVanishedIsShownAsSuchWithItsPicture) {
    const std::string png("\x89PNG\x00\xff", 6);
    ASSERT_TRUE(recent_.add(file("a"), png));
    ASSERT_TRUE(recent_.add(file("a"), {})) << "no new picture keeps the old one";
    QFile::remove(folder_.filePath("a"));
    const auto list = recent_.list();
    ASSERT_EQ(list.size(), 1U);
    EXPECT_TRUE(list[0].missing);
    EXPECT_EQ(list[0].thumbnail, png);
    ASSERT_TRUE(recent_.remove(folder_.filePath("a")));
    EXPECT_TRUE(recent_.list().empty());
}

TEST_F(Recent, ABrokenListIsEmptyAndMadeAnew) {
    ASSERT_TRUE(recent_.add(file("a"), {}));
    const QString path = folder_.filePath("state/recent.json");
    for (const char* text :
         {"", "{", "[]", "{\"files\": 3}",
          "{\"format\": \"edgewright-recent\", \"files\": [1, {}, {\"path\": 2}]}"}) {
        ASSERT_TRUE(writeFileBytes(path, text));
        EXPECT_TRUE(recent_.list().empty()) << text;
    }
    ASSERT_TRUE(recent_.add(file("b"), {}));
    EXPECT_EQ(names(), Names{"b"});
}

TEST_F(Recent, WindowsSideBySideLoseNothingOfEachOther) {
    constexpr int kEach = 10;
    const auto work = [&](const char* stem) {
        RecentFiles mine(folder_.filePath("state/recent.json"));
        for (int i = 0; i < kEach; ++i) {
            EXPECT_TRUE(mine.add(folder_.filePath(QString(stem) + QString::number(i)), {}));
        }
    };
    std::thread other(work, "x");
    work("y");
    other.join();
    EXPECT_EQ(recent_.list().size(), 2U * kEach);
}

TEST(LocalFile, TakesPathsAndFileUrls) {
    const QString here = QDir::current().absoluteFilePath("a b.edgewright");
    EXPECT_EQ(*localFile("a b.edgewright"), here);
    EXPECT_EQ(*localFile("./a b.edgewright"), here);
    EXPECT_EQ(*localFile(QUrl::fromLocalFile(here).toString(QUrl::FullyEncoded)), here);
    EXPECT_EQ(*localFile("/x/\xc3\xa4.edgewright"), QString::fromUtf8("/x/\xc3\xa4.edgewright"));
    for (const char* url : {"https://example.org/a.edgewright", "file://host/a.edgewright"}) {
        EXPECT_EQ(localFile(url).error().code, Errc::BadValue) << url;
    }
}

}  // namespace
}  // namespace ew
