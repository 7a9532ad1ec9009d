// SPDX-License-Identifier: GPL-3.0-or-later
// Names of pupils and what is kept of their work, without a disk.
#include <gtest/gtest.h>

#include <QFile>
#include <QString>
#include <nlohmann/json.hpp>
#include <set>

#include "core/document/classroom/hint_words.h"
#include "core/document/classroom/pupil_name.h"
#include "core/document/classroom/pupil_progress.h"
#include "core/document/lesson/likeness.h"

namespace ew::test {
namespace {

constexpr ClassTime kMorning = 1'700'000'000;

TEST(PupilNames, AreKeptAsTheyAreMeant) {
    EXPECT_EQ(*pupilName("  Anna   Lena "), "Anna Lena");
    EXPECT_EQ(*pupilName("Mu\u0308ller"), "M\u00fcller") << "composed and not: one name";
    EXPECT_EQ(*pupilName("a/b\\c:d"), "a/b\\c:d");
    EXPECT_EQ(*pupilName(QString(300, 'x')), QString(300, 'x'));
    EXPECT_EQ(pupilName("  ").error().code, Errc::BadValue);
    EXPECT_EQ(pupilName(QString(501, 'x')).error().code, Errc::BadValue);
    EXPECT_EQ(pupilName(QString("a") + QChar(0x1b) + "b").error().code, Errc::BadValue);
    EXPECT_EQ(pupilName(QString("a") + QChar(0xd83d)).error().code, Errc::BadValue);
}

TEST(PupilNames, MakeFoldersThatAnyDiskTakes) {
    const QStringList names{"Anna",
                            "anna",
                            "ANNA",
                            "An/na",
                            "An\\na",
                            "An:na",
                            "../../etc",
                            "..",
                            ".",
                            "CON",
                            "nul",
                            "-rf",
                            "\U0001F600",
                            "\U0001F600\U0001F600",
                            "\u30a2\u30f3\u30ca",
                            "Anna.",
                            "Anna\u200bB",
                            QString(300, 'x'),
                            QString(299, 'x') + 'y',
                            QString(200, QChar(0x4e00))};
    std::set<QString> folders;
    for (const QString& name : names) {
        SCOPED_TRACE(name.toStdString());
        const QString folder = pupilFolderName(*pupilName(name));
        EXPECT_TRUE(folders.insert(folder.toLower()).second) << folder.toStdString();
        constexpr qsizetype kLongest = 120;  // bytes; disks take 255
        EXPECT_LE(QFile::encodeName(folder).size(), kLongest);
        EXPECT_FALSE(folder.startsWith('.') || folder.startsWith('-') || folder.endsWith('.'));
        for (const QChar c : folder) {
            EXPECT_TRUE(c.isLetterOrNumber() || c == '-' || c == '_') << folder.toStdString();
        }
        EXPECT_EQ(folder, pupilFolderName(*pupilName(name))) << "the same on every machine";
        EXPECT_EQ(pupilFolderName(*pupilName(name), 2), folder + "-2");
    }
    EXPECT_TRUE(pupilFolderName("Anna Lena").startsWith("Anna-Lena-"));
}

PupilProgress begun() {
    PupilProgress pupil;
    pupil.name = "Anna";
    beginStep(pupil, "first-box", 2, 0, kMorning);
    return pupil;
}

TEST(PupilProgress, CountsTimeButNotWhileSheIsAway) {
    PupilProgress pupil = begun();
    keepTime(pupil, "first-box", kMorning + 30);
    keepTime(pupil, "first-box", kMorning + 100);
    EXPECT_EQ(pupil.lessons.at("first-box").seconds(), 100.0);
    keepTime(pupil, "first-box", kMorning + 5'000);
    EXPECT_EQ(pupil.lessons.at("first-box").seconds(), 100.0);
    keepTime(pupil, "first-box", kMorning + 5'010);
    EXPECT_EQ(pupil.lessons.at("first-box").seconds(), 110.0);
    keepTime(pupil, "first-box", kMorning);  // a clock that is set back
    EXPECT_EQ(pupil.lessons.at("first-box").seconds(), 110.0);
}

TEST(PupilProgress, TheBestOfSeveralTimesCounts) {
    PupilProgress pupil = begun();
    finishStep(pupil, "first-box", 2, 12, kMorning + 10);
    beginStep(pupil, "first-box", 2, 0, kMorning + 20);
    finishStep(pupil, "first-box", 1, 20, kMorning + 30);
    const LessonProgress& lesson = pupil.lessons.at("first-box");
    EXPECT_EQ(lesson.stars(), 2);
    EXPECT_EQ(lesson.strokes(), 12);
    EXPECT_EQ(lesson.done(), 1);
    EXPECT_EQ(lesson.mostStars(), 6);
    EXPECT_FALSE(lesson.finished());
    beginStep(pupil, "first-box", 2, 1, kMorning + 40);
    finishStep(pupil, "first-box", 3, 3, kMorning + 50);
    EXPECT_TRUE(pupil.lessons.at("first-box").finished());
    beginStep(pupil, "first-box", 3, 0, kMorning + 60);
    EXPECT_EQ(pupil.lessons.at("first-box").done(), 0) << "the lesson is another one now";
}

TEST(PupilProgress, WhoFailsThreeTimesIsStuckUntilItIsDone) {
    PupilProgress pupil = begun();
    failStep(pupil, "first-box", "open-end", kMorning + 10);
    failStep(pupil, "first-box", "open-end", kMorning + 20);
    EXPECT_FALSE(stuckPlace(pupil));
    failStep(pupil, "first-box", "missing-edge", kMorning + 30);
    const auto stuck = stuckPlace(pupil);
    ASSERT_TRUE(stuck);
    EXPECT_EQ(stuck->lesson, "first-box");
    EXPECT_EQ(stuck->step, 0U);
    EXPECT_EQ(stuck->since, kMorning + 10);
    EXPECT_EQ(stuck->failed, 3);
    EXPECT_EQ(stuck->hint, "missing-edge");
    finishStep(pupil, "first-box", 1, 9, kMorning + 40);
    EXPECT_FALSE(stuckPlace(pupil));
    EXPECT_EQ(pupil.lessons.at("first-box").failed(), 3) << "that it was hard stays known";
}

TEST(PupilProgress, WhoTakesLongIsStuck) {
    PupilProgress pupil = begun();
    for (int i = 1; i <= 5; ++i) keepTime(pupil, "first-box", kMorning + 100 * i);
    const auto stuck = stuckPlace(pupil);
    ASSERT_TRUE(stuck);
    EXPECT_EQ(stuck->since, kMorning + 300);
    EXPECT_EQ(stuck->failed, 0);
    beginStep(pupil, "printer", 4, 0, kMorning + 600);
    EXPECT_FALSE(stuckPlace(pupil)) << "she went on to something else";
}

TEST(PupilProgress, ReadsBackWhatItWrote) {
    PupilProgress pupil = begun();
    pupil.name = "An\"na \U0001F600/";
    pupil.machine = "room-7";
    pupil.session = "x1";
    pupil.apart = "Anna-1";
    pupil.lessons["first-box"].thumbnail = std::string("\x89PNG\0\xff", 6);
    failStep(pupil, "first-box", "open-end", kMorning + 10);
    finishStep(pupil, "first-box", 3, 9, kMorning + 20);
    failStep(pupil, "first-box", "wrong-shape", kMorning + 25);
    const auto read = readProgress(progressText(pupil));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(*read, pupil);
}

TEST(PupilProgress, CutAnywhereItIsRefused) {
    PupilProgress pupil = begun();
    failStep(pupil, "first-box", "open-end", kMorning + 10);
    const std::string text = progressText(pupil);
    for (std::size_t n = 0; n + 2 < text.size(); n += 3) {
        EXPECT_FALSE(readProgress(text.substr(0, n))) << n;
    }
}

TEST(PupilProgress, BadValuesAreNamedByTheirPlace) {
    const auto expectError = [](const char* pointer, const nlohmann::json& value, Errc code) {
        auto tree = nlohmann::json::parse(progressText(begun()));
        tree[nlohmann::json::json_pointer(pointer)] = value;
        const auto read = readProgress(tree.dump());
        ASSERT_FALSE(read) << pointer;
        EXPECT_EQ(read.error().code, code) << pointer;
        EXPECT_NE(read.error().message.find(pointer), std::string::npos) << read.error().message;
    };
    expectError("/format", "edgewright-lesson", Errc::WrongFormat);
    expectError("/version", 2, Errc::WrongVersion);
    expectError("/name", 7, Errc::WrongType);
    expectError("/lessons", nlohmann::json::array(), Errc::WrongType);
    expectError("/lessons/first-box/steps", nlohmann::json::array(), Errc::BadValue);
    expectError("/lessons/first-box/step", 2, Errc::BadValue);
    expectError("/lessons/first-box/last", "yesterday", Errc::BadValue);
    expectError("/lessons/first-box/steps/0/stars", 4, Errc::BadValue);
    expectError("/lessons/first-box/steps/0/seconds", -1, Errc::BadValue);
}

TEST(PupilProgress, OfTwoMachinesTheBetterIsKept) {
    PupilProgress here = begun();
    finishStep(here, "first-box", 3, 9, kMorning + 10);
    PupilProgress there = begun();
    finishStep(there, "first-box", 1, 15, kMorning + 20);
    beginStep(there, "first-box", 2, 1, kMorning + 30);
    beginStep(there, "printer", 4, 0, kMorning + 40);
    for (const bool swap : {false, true}) {
        PupilProgress merged = swap ? there : here;
        mergeProgress(merged, swap ? here : there);
        const LessonProgress& box = merged.lessons.at("first-box");
        EXPECT_EQ(box.stars(), 3);
        EXPECT_EQ(box.strokes(), 9);
        EXPECT_EQ(box.step, 1U) << "where she was last";
        EXPECT_TRUE(merged.lessons.contains("printer"));
    }
}

TEST(HintWords, SayWhatAStepWasNot) {
    for (const Unlike unlike : {Unlike::NotYet, Unlike::Bodies, Unlike::Side, Unlike::Shape,
                                Unlike::Place, Unlike::Proportions, Unlike::Settings}) {
        EXPECT_NE(hintWords(unlikeName(unlike)), unlikeName(unlike));
    }
    EXPECT_EQ(hintWords("missing-edge"), "a line is missing");
    EXPECT_EQ(hintWords("something-new"), "something-new");
}

}  // namespace
}  // namespace ew::test
