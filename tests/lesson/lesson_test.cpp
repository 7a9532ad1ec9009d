// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/lesson/lesson.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <nlohmann/json.hpp>
#include <random>

#include "core/document/file_bytes.h"
#include "core/document/lesson/lesson_check.h"
#include "core/document/zip_file.h"
#include "tests/lesson/shipped.h"

namespace ew::test {
namespace {

using nlohmann::json;

/// A lesson of one step, as small as one can be.
json smallLesson() {
    return {{"format", "edgewright-lesson"},
            {"version", 1},
            {"id", "small"},
            {"languages", {"en", "de"}},
            {"title", {{"en", "Small"}, {"de", "Klein"}}},
            {"solution",
             {{"format", "edgewright-sketch"},
              {"version", 1},
              {"steps", {{{"do", "thresholds"}, {"distance_px", 20.0}}}}}},
            {"steps", {{{"text", {{"en", "Do it."}, {"de", "Mach es."}}}, {"end", 1}}}}};
}

class LessonFile : public testing::Test {
  protected:
    QString write(const std::string& bytes, const QString& name = QStringLiteral("lesson.json")) {
        const QString path = folder_.filePath(name);
        EXPECT_TRUE(writeFileBytes(path, bytes));
        return path;
    }
    void expectError(const json& lesson, Errc code, const std::string& place) {
        const auto read = readLesson(write(lesson.dump()));
        ASSERT_FALSE(read) << place;
        EXPECT_EQ(read.error().code, code) << read.error().message;
        EXPECT_NE(read.error().message.find(place), std::string::npos) << read.error().message;
    }
    QTemporaryDir folder_;
};

TEST_F(LessonFile, IsReadFromAFolderFromItsFileAndFromAPack) {
    const QString file = write(smallLesson().dump());
    for (const QString& path : {folder_.path(), file}) {
        const auto lesson = readLesson(path);
        ASSERT_TRUE(lesson) << lesson.error().message;
        EXPECT_EQ(lesson->id, "small");
        EXPECT_EQ(textIn(lesson->title, "de"), "Klein");
        EXPECT_EQ(lesson->steps.size(), 1U);
    }
    const auto packed = packLesson(folder_.path());
    ASSERT_TRUE(packed) << packed.error().message;
    const auto again = readLesson(write(*packed, QStringLiteral("small.edgewright-lesson")));
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->title, readLesson(file)->title);
}

TEST_F(LessonFile, TextsFallBackToEnglishAndThenToAny) {
    const LessonText both{{"en", "Box"}, {"de", "Quader"}};
    EXPECT_EQ(textIn(both, "de"), "Quader");
    EXPECT_EQ(textIn(both, "de_AT"), "Quader");
    EXPECT_EQ(textIn(both, "ja"), "Box");
    EXPECT_EQ(textIn({{"fr", "Boite"}}, "ja"), "Boite");
    EXPECT_EQ(textIn({}, "en"), "");
}

TEST_F(LessonFile, WhatIsWrongIsToldAtItsPlace) {
    const auto with = [](const char* path, const json& value) {
        json lesson = smallLesson();
        lesson[json::json_pointer(path)] = value;
        return lesson;
    };
    expectError(with("/format", "edgewright-sketch"), Errc::WrongFormat, "/format");
    expectError(with("/version", 2), Errc::WrongVersion, "/version");
    expectError(with("/id", "../x"), Errc::BadValue, "/id");
    expectError(with("/languages", {"e"}), Errc::BadValue, "/languages");
    expectError(with("/languages", {"en", "en"}), Errc::BadValue, "/languages");
    expectError(with("/languages", json::array()), Errc::BadValue, "/languages");
    expectError(with("/title", "Small"), Errc::WrongType, "/title");
    expectError(with("/title/en", std::string(5'000, 'x')), Errc::BadValue, "/title/en");
    expectError(with("/minutes", 0), Errc::BadValue, "/minutes");
    expectError(with("/colour", 1), Errc::UnknownKey, "colour");
    expectError(with("/steps", json::array()), Errc::BadValue, "/steps");
    expectError(with("/steps/0/end", 2), Errc::BadValue, "/steps/0/end");
    expectError(with("/steps/0/end", 0), Errc::BadValue, "/steps/0/end");
    expectError(with("/steps/0/tolerance", -1), Errc::BadValue, "/steps/0/tolerance");
    expectError(with("/steps/0/text", 7), Errc::WrongType, "/steps/0/text");
    json shorter = smallLesson();
    shorter.erase("title");
    expectError(shorter, Errc::MissingKey, "title");
}

TEST_F(LessonFile, AStepThatWritesOrOpensFilesIsRefused) {
    for (const char* word : {"save", "open", "export"}) {
        json lesson = smallLesson();
        lesson["solution"]["steps"][0] = {{"do", word}, {"path", "x.obj"}};
        expectError(lesson, Errc::BadValue, "/steps/0");
    }
}

TEST_F(LessonFile, FilesOutsideItsFolderAreRefused) {
    for (const char* name : {"../solution.json", "/etc/passwd", "a/../../x"}) {
        json lesson = smallLesson();
        lesson["solution"] = name;
        expectError(lesson, Errc::BadValue, "/solution");
        lesson = smallLesson();
        lesson["picture"] = name;
        expectError(lesson, Errc::BadValue, "/picture");
    }
    const QTemporaryDir outside;
    ASSERT_TRUE(writeFileBytes(outside.filePath("s.json"), "{}"));
    ASSERT_TRUE(QFile::link(outside.filePath("s.json"), folder_.filePath("s.json")));
    json lesson = smallLesson();
    lesson["solution"] = "s.json";
    expectError(lesson, Errc::BadValue, "/solution");
}

TEST_F(LessonFile, AMissingFileIsNamed) {
    json lesson = smallLesson();
    lesson["solution"] = "solution.json";
    expectError(lesson, Errc::FileNotFound, "solution.json");
    EXPECT_EQ(readLesson(folder_.filePath("none")).error().code, Errc::FileNotFound);
}

TEST_F(LessonFile, CutAnywhereItIsRefused) {
    const std::string whole = smallLesson().dump();
    for (std::size_t n = 0; n < whole.size(); n += 7) {
        EXPECT_FALSE(readLesson(write(whole.substr(0, n)))) << n;
    }
    write(whole);
    const std::string packed = *packLesson(folder_.path());
    std::mt19937 random(4);
    for (int i = 0; i < 50; ++i) {
        EXPECT_FALSE(readLesson(write(packed.substr(0, random() % packed.size()),
                                      QStringLiteral("cut.edgewright-lesson"))));
    }
}

TEST_F(LessonFile, ATextThatIsMissingInALanguageIsAFault) {
    json lesson = smallLesson();
    lesson["steps"][0]["text"].erase("de");
    lesson["title"]["fr"] = "Petit";
    const auto read = readLesson(write(lesson.dump()));
    ASSERT_TRUE(read);
    const auto faults = checkLesson(*read, shippedLibrary());
    ASSERT_EQ(faults.size(), 2U);
    EXPECT_EQ(faults[0].path, "/title/fr");
    EXPECT_EQ(faults[1].path, "/steps/0/text");
    EXPECT_NE(faults[1].error.message.find("de"), std::string::npos);
}

TEST_F(LessonFile, ASolutionThatFailsIsAFault) {
    json lesson = smallLesson();
    lesson["solution"]["steps"][0] = {{"do", "apply"}};
    const auto read = readLesson(write(lesson.dump()));
    ASSERT_TRUE(read);
    const auto faults = checkLesson(*read, shippedLibrary());
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults[0].path, "/steps/0");
    EXPECT_EQ(faults[0].error.code, Errc::EmptySketch);
}

}  // namespace
}  // namespace ew::test
