// SPDX-License-Identifier: GPL-3.0-or-later
// A class folder as several machines write to it, and what a teacher is told of it.
#include <gtest/gtest.h>
#include <sys/mount.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <ctime>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/document/classroom/class_overview.h"
#include "core/document/classroom/overview_text.h"
#include "core/document/classroom/pupil_files.h"
#include "core/document/classroom/pupil_name.h"
#include "core/document/file_bytes.h"
#include "core/document/sketch_script.h"
#include "tests/document/full_disk.h"
#include "tests/lesson/shipped.h"

namespace ew::test {
namespace {

constexpr ClassTime kMorning = 1'700'000'000;
const ClassWriter kHere{"here", "session-1"};
const ClassWriter kThere{"there", "session-2"};

QString shippedFolder() { return QStringLiteral(EDGEWRIGHT_SOURCE_DIR "/resources/lessons"); }

struct ClassFolder : ::testing::Test {
    QString folder() const { return folder_.path() + "/5b"; }
    void SetUp() override { ASSERT_TRUE(QDir().mkpath(folder())); }
    PupilFiles join(const QString& name, const ClassWriter& writer = kHere) const {
        auto files = PupilFiles::join(folder(), name, writer);
        EXPECT_TRUE(files) << files.error().message;
        return *std::move(files);
    }
    static std::string read(const QString& path) {
        return readFileBytes(path, kMaxProgressBytes).value_or("");
    }
    ClassOverview overview() const {
        auto found = readClass(folder(), shippedFolder());
        EXPECT_TRUE(found) << found.error().message;
        return *std::move(found);
    }
    static PupilProgress worked(PupilProgress progress, int stars) {
        beginStep(progress, "first-box", 2, 0, kMorning);
        finishStep(progress, "first-box", stars, 9, kMorning + 60);
        return progress;
    }
    QTemporaryDir folder_;
};

TEST_F(ClassFolder, KeepsWhatAPupilDoesInAFolderOfHerOwn) {
    PupilFiles anna = join("Anna");
    EXPECT_EQ(QFileInfo(anna.folder()).fileName(), pupilFolderName("Anna"));
    ASSERT_TRUE(anna.write(worked(anna.progress(), 3)));
    ASSERT_TRUE(anna.writeDocument("first-box", "a document"));
    const PupilFiles again = join("Anna", kThere);
    EXPECT_EQ(again.folder(), anna.folder()) << "on another machine, too";
    EXPECT_EQ(again.progress().lessons.at("first-box").stars(), 3);
    EXPECT_EQ(read(anna.folder() + "/first-box.edgewright"), "a document");
}

TEST_F(ClassFolder, TakesNamesThatNoFileCanHave) {
    const QStringList names{"a/b",  "a-b",     "\U0001F600", QString(300, 'x'), "..",
                            "Anna", "anna",    "a:b",        "../../outside",   "CON",
                            ".",    "Anna\\b", "-",          QString(301, 'x')};
    for (const QString& name : names) {
        PupilFiles files = join(name);
        ASSERT_TRUE(files.write(worked(files.progress(), 1))) << name.toStdString();
    }
    EXPECT_EQ(QDir(folder() + "/work").entryList(QDir::Dirs | QDir::NoDotAndDotDot).size(),
              names.size());
    EXPECT_EQ(QDir(folder_.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
              QStringList{"5b"});
    EXPECT_EQ(overview().pupils.size(), static_cast<std::size_t>(names.size()));
    for (const QString& name : names) {
        EXPECT_EQ(join(name).progress().lessons.at("first-box").stars(), 1);
    }
}

TEST_F(ClassFolder, AnotherPupilsFolderOfThatNameIsLeftAlone) {
    const QString place = folder() + "/work/" + pupilFolderName("Anna");
    ASSERT_TRUE(QDir().mkpath(place));
    PupilProgress other;
    other.name = "Berta";  // two names of one sum
    const std::string text = progressText(other);
    ASSERT_TRUE(writeFileBytes(place + "/progress.json", text));
    PupilFiles anna = join("Anna");
    ASSERT_TRUE(anna.write(worked(anna.progress(), 2)));
    EXPECT_EQ(anna.folder(), place + "-2");
    EXPECT_EQ(read(place + "/progress.json"), text);
    EXPECT_EQ(join("Anna", kThere).folder(), place + "-2");
}

TEST_F(ClassFolder, TwoMachinesWithOneNameLoseNothingAndAreTold) {
    PupilFiles first = join("Anna", kHere);
    ASSERT_TRUE(first.write(worked(first.progress(), 3)));
    ASSERT_TRUE(first.writeDocument("first-box", "of the first"));
    PupilFiles second = join("Anna", kThere);
    EXPECT_EQ(second.folder(), first.folder());
    ASSERT_TRUE(second.writeDocument("printer", "of the second"));
    const std::string theirs = read(second.folder() + "/progress.json");

    EXPECT_FALSE(first.takeNotice());
    ASSERT_TRUE(first.writeDocument("printer", "of the first"));
    const auto notice = first.takeNotice();
    ASSERT_TRUE(notice);
    EXPECT_EQ(notice->code, Errc::InUse);
    EXPECT_NE(notice->message.find("there"), std::string::npos);
    EXPECT_NE(notice->message.find(second.folder().toStdString()), std::string::npos);
    EXPECT_FALSE(first.takeNotice()) << "it is told once";
    EXPECT_EQ(first.folder(), second.folder() + "-2");
    EXPECT_EQ(read(second.folder() + "/progress.json"), theirs);
    EXPECT_EQ(read(second.folder() + "/printer.edgewright"), "of the second");
    EXPECT_EQ(read(first.folder() + "/printer.edgewright"), "of the first");
    EXPECT_EQ(first.progress().lessons.at("first-box").stars(), 3);
    ASSERT_TRUE(first.write(worked(first.progress(), 2)));
    ASSERT_TRUE(second.write(worked(second.progress(), 1)));
    EXPECT_FALSE(second.takeNotice());
    // Each goes on where it was.
    EXPECT_EQ(join("Anna", kHere).folder(), first.folder());
    EXPECT_EQ(join("Anna", kThere).folder(), second.folder());
    const ClassOverview both = overview();
    ASSERT_EQ(both.pupils.size(), 2U);
    EXPECT_EQ(both.pupils[0].progress.apart.empty() + both.pupils[1].progress.apart.empty(), 1);
}

TEST_F(ClassFolder, ManyWritersAtOnceLoseNothing) {
    std::vector<PupilFiles> writers;
    for (int i = 0; i < 6; ++i) {
        const std::string number = std::to_string(i);
        writers.push_back(join("Anna", {"machine-" + number, "session-" + number}));
    }
    for (int round = 0; round < 3; ++round) {
        for (std::size_t i = 0; i < writers.size(); ++i) {
            PupilProgress p = writers[i].progress();
            beginStep(p, "own-" + std::to_string(i), 3, static_cast<std::size_t>(round), kMorning);
            ASSERT_TRUE(writers[i].write(p));
        }
    }
    std::set<QString> folders;
    for (std::size_t i = 0; i < writers.size(); ++i) {
        EXPECT_TRUE(folders.insert(writers[i].folder()).second);
        const auto kept = readProgress(read(writers[i].folder() + "/progress.json"));
        ASSERT_TRUE(kept);
        EXPECT_EQ(kept->lessons.at("own-" + std::to_string(i)).step, 2U);
    }
}

TEST_F(ClassFolder, ProgressThatIsCutIsLeftAndTold) {
    PupilFiles anna = join("Anna");
    ASSERT_TRUE(anna.write(worked(anna.progress(), 3)));
    const QString file = anna.folder() + "/progress.json";
    const std::string cut = read(file).substr(0, 40);
    ASSERT_TRUE(writeFileBytes(file, cut));
    PupilFiles again = join("Anna", kThere);
    const auto notice = again.takeNotice();
    ASSERT_TRUE(notice);
    EXPECT_EQ(notice->code, Errc::Damaged);
    EXPECT_NE(notice->message.find(file.toStdString()), std::string::npos);
    ASSERT_TRUE(again.write(worked(again.progress(), 1)));
    // So does the program that has it open.
    ASSERT_TRUE(anna.write(worked(anna.progress(), 3)));
    EXPECT_EQ(anna.progress().lessons.at("first-box").stars(), 3);
    EXPECT_EQ(read(file), cut);
}

TEST_F(ClassFolder, AFolderThatAnotherProgramBeginsThisMomentIsTheSameOne) {
    const QString place = folder() + "/work/" + pupilFolderName("Anna");
    ASSERT_TRUE(QDir().mkpath(place));
    ASSERT_TRUE(writeFileBytes(place + "/.ew1x2y3z", "{\"format\""));
    PupilFiles anna = join("Anna");
    EXPECT_EQ(anna.folder(), place);
    EXPECT_FALSE(anna.takeNotice());
    const QString other = folder() + "/work/" + pupilFolderName("Berta");
    ASSERT_TRUE(QDir().mkpath(other));
    ASSERT_TRUE(writeFileBytes(other + "/essay.odt", "x"));
    PupilFiles berta = join("Berta");
    EXPECT_EQ(berta.folder(), other + "-2") << "what is somebody's is left alone";
}

TEST_F(ClassFolder, AFolderThatIsGoneIsToldAndNothingIsMadeInItsPlace) {
    PupilFiles anna = join("Anna");
    ASSERT_TRUE(QDir().rename(folder(), folder_.filePath("pulled")));
    // An empty folder is left where a stick was.
    for (const bool emptyPlace : {false, true}) {
        if (emptyPlace) {
            ASSERT_TRUE(QDir().mkpath(folder()));
        }
        const auto written = anna.write(worked(anna.progress(), 3));
        ASSERT_FALSE(written);
        EXPECT_EQ(written.error().code, Errc::FileNotFound);
        EXPECT_NE(written.error().message.find(folder().toStdString()), std::string::npos);
        EXPECT_FALSE(anna.writeDocument("first-box", "x"));
        if (emptyPlace) {
            EXPECT_TRUE(QDir(folder()).isEmpty());
        }
    }
    ASSERT_TRUE(QDir().rmdir(folder()));
    EXPECT_EQ(PupilFiles::join(folder(), "Anna", kHere).error().code, Errc::FileNotFound);
    EXPECT_EQ(readClass(folder(), {}).error().code, Errc::FileNotFound);
    // Back again, it goes on.
    ASSERT_TRUE(QDir().rename(folder_.filePath("pulled"), folder()));
    ASSERT_TRUE(anna.write(worked(anna.progress(), 3)));
    EXPECT_FALSE(anna.takeNotice());
}

TEST_F(ClassFolder, AFolderThatMayNotBeWrittenIsTold) {
    const SmallDisk disk(folder().toStdString());
    if (!disk.mounted()) GTEST_SKIP() << "no disk can be mounted here";
    PupilFiles anna = join("Anna");
    ASSERT_TRUE(anna.write(worked(anna.progress(), 1)));
    const std::string place = folder().toStdString();
    ASSERT_EQ(::mount("tmpfs", place.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, "size=256k"), 0);
    const auto written = anna.write(worked(anna.progress(), 3));
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, Errc::CannotWrite);
    EXPECT_NE(written.error().message.find(anna.folder().toStdString()), std::string::npos);
    EXPECT_EQ(PupilFiles::join(folder(), "Berta", kHere).error().code, Errc::CannotWrite);
    EXPECT_EQ(PupilFiles::join(folder(), "Anna", kThere).error().code, Errc::CannotWrite);
    EXPECT_EQ(overview().pupils.at(0).stars(), 1) << "it can still be looked at";
}

TEST_F(ClassFolder, OnAFullDiskWhatWasThereStays) {
    const SmallDisk disk(folder().toStdString());
    if (!disk.mounted()) GTEST_SKIP() << "no disk can be mounted here";
    PupilFiles anna = join("Anna");
    ASSERT_TRUE(anna.write(worked(anna.progress(), 1)));
    const std::string before = read(anna.folder() + "/progress.json");
    disk.fill();
    const auto written = anna.write(worked(anna.progress(), 3));
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, Errc::CannotWrite);
    EXPECT_NE(written.error().message.find("no room"), std::string::npos);
    EXPECT_EQ(read(anna.folder() + "/progress.json"), before);
    EXPECT_FALSE(PupilFiles::join(folder(), "Berta", kHere));
    ASSERT_TRUE(QFile::remove(folder() + "/filler"));
    ASSERT_TRUE(anna.write(worked(anna.progress(), 3)));
    EXPECT_FALSE(anna.takeNotice());
    // A folder that stayed empty is hers all the same.
    PupilFiles berta = join("Berta");
    EXPECT_EQ(QFileInfo(berta.folder()).fileName(), pupilFolderName("Berta"));
}

TEST_F(ClassFolder, WhatCouldNotBeWrittenIsBroughtThereNextTime) {
    const QString shelf = folder_.filePath("shelf");
    PupilFiles anna = join("Anna");
    ASSERT_TRUE(anna.writeDocument("first-box", "old"));
    ASSERT_TRUE(QDir().rename(folder(), folder_.filePath("pulled")));
    const PupilProgress mine = worked(anna.progress(), 3);
    ASSERT_FALSE(anna.write(mine));
    ASSERT_TRUE(anna.shelve(shelf, mine, "first-box", "new"));
    ASSERT_TRUE(anna.shelve(shelf, mine, "printer", "first"));
    ASSERT_TRUE(QDir().rename(folder_.filePath("pulled"), folder()));

    PupilFiles berta = join("Berta");
    ASSERT_TRUE(berta.unshelve(shelf));
    EXPECT_TRUE(berta.progress().lessons.empty()) << "it is none of hers";
    PupilFiles again = join("Anna");
    ASSERT_TRUE(again.unshelve(shelf));
    EXPECT_TRUE(again.takeNotice());
    EXPECT_EQ(again.progress().lessons.at("first-box").stars(), 3);
    EXPECT_EQ(read(again.folder() + "/first-box.edgewright"), "old");
    EXPECT_EQ(read(again.folder() + "/first-box (2).edgewright"), "new");
    EXPECT_EQ(read(again.folder() + "/printer.edgewright"), "first");
    ASSERT_TRUE(again.unshelve(shelf));
    EXPECT_FALSE(again.takeNotice()) << "the shelf is empty";
}

TEST_F(ClassFolder, ForeignFilesAreNamedAndLeft) {
    PupilFiles anna = join("Anna");
    ASSERT_TRUE(anna.write(worked(anna.progress(), 3)));
    const QString work = folder() + "/work/";
    ASSERT_TRUE(writeFileBytes(work + "notes.txt", "hello"));
    ASSERT_TRUE(writeFileBytes(work + ".DS_Store", "x"));
    ASSERT_TRUE(writeFileBytes(work + "Thumbs.db", "x"));
    ASSERT_TRUE(QDir().mkpath(work + "empty"));
    ASSERT_TRUE(QDir().mkpath(work + "cut"));
    ASSERT_TRUE(writeFileBytes(work + "cut/progress.json", "{\"format\": \"edge"));
    ASSERT_TRUE(QDir().mkpath(work + "later"));
    ASSERT_TRUE(writeFileBytes(work + "later/progress.json",
                               "{\"format\": \"edgewright-pupil\", \"version\": 9}"));
    const ClassOverview found = overview();
    EXPECT_EQ(found.pupils.size(), 1U);
    std::map<std::string, Errc> problems;
    for (const FileFault& f : found.problems) {
        problems[QString::fromStdString(f.file).mid(work.size()).toStdString()] = f.code;
    }
    const std::map<std::string, Errc> expected{{"cut/progress.json", Errc::Syntax},
                                               {"empty/progress.json", Errc::FileNotFound},
                                               {"later/progress.json", Errc::WrongVersion},
                                               {"notes.txt", Errc::WrongFormat}};
    EXPECT_EQ(problems, expected);
    EXPECT_EQ(read(work + "notes.txt"), "hello");
}

TEST_F(ClassFolder, ItsOwnLessonsTakeThePlaceOfTheShippedOnes) {
    EXPECT_EQ(overview().lessons.size(), 9U);
    const QString own = folder() + "/lessons";
    ASSERT_TRUE(QDir().mkpath(own));
    ASSERT_TRUE(
        writeFileBytes(own + "/box.edgewright-lesson", *packLesson(lessonFolder("first-box"))));
    ASSERT_TRUE(writeFileBytes(own + "/broken.edgewright-lesson", "PK"));
    const ClassOverview found = overview();
    ASSERT_EQ(found.lessons.size(), 1U);
    EXPECT_EQ(found.lessons[0].id, "first-box");
    EXPECT_EQ(found.lessons[0].steps, 2U);
    ASSERT_EQ(found.problems.size(), 1U);
    EXPECT_TRUE(found.problems[0].file.ends_with("broken.edgewright-lesson"));
}

ClassOverview smallClass() {
    ClassOverview out;
    out.name = "5b <x>";
    out.lessons = {{"first-box", {{"en", "Your first box"}, {"de", "Der erste Quader"}}, 5, 2, {}}};
    ClassPupil anna;
    anna.progress.name = "=cmd|' /C calc'!A0, \"<b>Anna</b>";
    anna.folder = "/class/work/anna";
    beginStep(anna.progress, "first-box", 2, 0, kMorning);
    for (int i = 1; i <= 3; ++i)
        failStep(anna.progress, "first-box", "open-end", kMorning + 30 * i);
    anna.stuck = stuckPlace(anna.progress);
    out.pupils.push_back(anna);
    ClassPupil berta;
    berta.progress.name = "Berta";
    berta.folder = "/class/work/berta";
    out.pupils.push_back(berta);
    return out;
}

TEST(OverviewText, CsvIsQuotedAndHoldsNoFormula) {
    const std::string bytes = overviewCsv(smallClass());
    ASSERT_TRUE(bytes.starts_with("\xef\xbb\xbf"));
    const QString csv = QString::fromStdString(bytes.substr(3));
    const QStringList lines = csv.split("\r\n");
    ASSERT_EQ(lines.size(), 4) << csv.toStdString();
    EXPECT_TRUE(lines[0].startsWith("Pupil,Lesson,Title,Steps done,Steps,Stars"));
    EXPECT_TRUE(lines[1].startsWith(
        "\"'=cmd|' /C calc'!A0, \"\"<b>Anna</b>\",first-box,Your first box,0,2,0,6,1.5,0,3,"))
        << lines[1].toStdString();
    EXPECT_TRUE(lines[1].contains(",1,"));
    EXPECT_TRUE(lines[1].endsWith(",open-end,anna"));
    EXPECT_TRUE(lines[2].startsWith("Berta,,,"));
    EXPECT_EQ(lines[2].count(','), lines[0].count(','));
}

TEST(OverviewText, HtmlTakesNamesForText) {
    const std::string html = overviewHtml(smallClass());
    EXPECT_EQ(html.find("<b>Anna"), std::string::npos);
    EXPECT_NE(html.find("&lt;b&gt;Anna"), std::string::npos);
    EXPECT_NE(html.find("5b &lt;x&gt;"), std::string::npos);
    EXPECT_EQ(html.find("http"), std::string::npos) << "it needs no other file";
    ClassOverview turned = smallClass();
    std::swap(turned.pupils[0], turned.pupils[1]);
    const std::string other = overviewHtml(turned);
    EXPECT_LT(other.find("&lt;b&gt;Anna"), other.find(">Berta<")) << "who is stuck comes first";
    EXPECT_NE(html.find("Your first box, step 1: 3 attempts, the last one: a corner is open"),
              std::string::npos);
    OverviewWords german;
    german.language = "de_DE";
    german.say = [](const std::string& text) { return text == "Pupil" ? "Name" : text; };
    const std::string page = overviewHtml(smallClass(), german);
    EXPECT_NE(page.find("Der erste Quader"), std::string::npos);
    EXPECT_NE(page.find(">Name</button>"), std::string::npos);
    EXPECT_NE(page.find("lang=\"de\""), std::string::npos);
}

TEST(OverviewText, JsonSaysWhoIsStuck) {
    const auto json = nlohmann::json::parse(overviewJson(smallClass()));
    EXPECT_EQ(json["format"], "edgewright-class-overview");
    EXPECT_EQ(json["pupils"][0]["stuck"]["hint"], "open-end");
    EXPECT_EQ(json["pupils"][0]["lessons"][0]["seconds"], 90);
    EXPECT_TRUE(json["pupils"][1]["stuck"].is_null());
}

TEST(OverviewText, TellsTimesAsPeopleDo) {
    EXPECT_EQ(durationText(0), "0 min");
    EXPECT_EQ(durationText(20), "< 1 min");
    EXPECT_EQ(durationText(95), "2 min");
    EXPECT_EQ(durationText(3599), "1 h 00 min");
    EXPECT_EQ(durationText(3900), "1 h 05 min");
}

TEST_F(ClassFolder, OfTwoHundredAndFiftyPupilsIsReadInASecond) {
    constexpr int kPupils = 250;
    const std::string picture(3'000, '\x7f');
    for (int i = 0; i < kPupils; ++i) {
        PupilProgress p;
        p.name = "Pupil " + std::to_string(i);
        for (const QString& lesson : shippedLessons()) {
            for (std::size_t step = 0; step < 5; ++step) {
                beginStep(p, lesson.toStdString(), 5, step, kMorning);
                for (int k = 0; k < 5; ++k) failStep(p, lesson.toStdString(), "open-end", kMorning);
            }
            p.lessons[lesson.toStdString()].thumbnail = picture;
        }
        const QString place = folder() + "/work/" + QString::number(i);
        ASSERT_TRUE(QDir().mkpath(place));
        ASSERT_TRUE(writeFileBytes(place + "/progress.json", progressText(p)));
    }
    const std::clock_t before = std::clock();
    const ClassOverview found = overview();
    const double seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
    EXPECT_EQ(found.pupils.size(), std::size_t{kPupils});
    RecordProperty("seconds", std::to_string(seconds));
#ifdef NDEBUG
    EXPECT_LT(seconds, 1.0) << "of the processor";
#endif
}

class ClassProgram : public ClassFolder {
  protected:
    int run(const QStringList& arguments) {
        QProcess program;
        program.start(QCoreApplication::applicationDirPath() + "/../app/edgewright-lesson",
                      arguments);
        EXPECT_TRUE(program.waitForFinished(60'000));
        out_ = program.readAllStandardOutput().toStdString();
        errors_ = program.readAllStandardError().toStdString();
        return program.exitCode();
    }
    std::string out_, errors_;
};

TEST_F(ClassProgram, KeepsAttemptsAndTellsOfThem) {
    SketchScript nothing;
    const QString strokes = folder_.filePath("strokes.json");
    ASSERT_TRUE(writeFileBytes(strokes, writeSketchScript(nothing)));
    const QStringList attempt{"try",       lessonFolder("first-box"),
                              "--step",    "0",
                              "--strokes", strokes,
                              "--class",   folder(),
                              "--pupil",   "An/na"};
    for (int i = 0; i < 3; ++i) EXPECT_EQ(run(attempt), 1) << errors_;
    EXPECT_EQ(run({"overview", folder(), "--json", "--csv", folder_.filePath("a.csv"), "--html",
                   folder_.filePath("a.html")}),
              0)
        << errors_;
    const auto json = nlohmann::json::parse(out_);
    ASSERT_EQ(json["pupils"].size(), 1U);
    EXPECT_EQ(json["pupils"][0]["name"], "An/na");
    EXPECT_EQ(json["pupils"][0]["stuck"]["hint"], "not-yet");
    EXPECT_EQ(json["pupils"][0]["stuck"]["failed"], 3);
    EXPECT_NE(read(folder_.filePath("a.csv")).find("An/na"), std::string::npos);
    EXPECT_NE(read(folder_.filePath("a.html")).find("<title>Class overview: 5b"),
              std::string::npos);
    EXPECT_EQ(run({"overview", folder()}), 0);
    EXPECT_NE(out_.find("An/na: steps 0 / "), std::string::npos) << out_;
    EXPECT_NE(out_.find("stuck: Your first box, step 1"), std::string::npos) << out_;

    ASSERT_TRUE(writeFileBytes(folder() + "/work/foreign", "x"));
    EXPECT_EQ(run({"overview", folder()}), 1);
    EXPECT_NE(out_.find("/work/foreign: /: "), std::string::npos) << out_;
    EXPECT_EQ(run({"overview", folder_.filePath("none")}), 2);
    EXPECT_NE(errors_.find("There is no class folder at"), std::string::npos) << errors_;
    EXPECT_EQ(run({"overview", folder(), "--csv", folder_.filePath("none/a.csv")}), 2);
    EXPECT_EQ(run(attempt.mid(0, 8)), 2) << "a class without a pupil";
}

}  // namespace
}  // namespace ew::test
