// SPDX-License-Identifier: GPL-3.0-or-later
// Exercises: the same for a class, readable, graded by what is understood.
#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QProcess>
#include <QTemporaryDir>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "core/document/file_bytes.h"
#include "core/document/lesson/lesson_check.h"
#include "core/document/practice/practice_log.h"
#include "core/document/practice/practice_picture.h"
#include "core/document/practice/practice_task.h"
#include "core/hand/hand_model.h"
#include "tests/lesson/shipped.h"

namespace ew::test {
namespace {

PracticeTask task(int level, std::uint32_t seed) {
    auto made = practiceTask(level, seed, shippedLibrary());
    EXPECT_TRUE(made) << level << ", " << seed << ": " << made.error().message;
    return *std::move(made);
}

std::vector<Line2> linesOf(const SketchScript& script) {
    std::vector<Line2> lines;
    for (const ScriptStep& step : script.steps) {
        const auto* drawn = std::get_if<StrokeStep>(&step);
        if (drawn == nullptr) continue;
        lines.push_back(
            {drawn->stroke.samples.front().position, drawn->stroke.samples.back().position});
    }
    return lines;
}

SketchScript drawn(const std::vector<Line2>& lines, const HandLevel& noise, unsigned seed) {
    Random random(seed);
    HandHabits habits;
    habits.oneStrokePerEdge = 1.0;
    habits.shortTrails = habits.wholeFaces = habits.longTrails = 0.0;
    SketchScript out;
    for (const Stroke& s : drawByHand(lines, noise, random, habits)) {
        out.steps.push_back(StrokeStep{s, false});
    }
    return out;
}

TEST(Practice, EveryLevelHasExercisesThatTheirOwnSolutionDoes) {
    for (int level = 1; level <= kPracticeLevels; ++level) {
        std::set<PracticeKind> kinds;
        std::set<std::string> pictures;
        for (std::uint32_t seed = 1; seed <= 8; ++seed) {
            SCOPED_TRACE("level " + std::to_string(level) + ", seed " + std::to_string(seed));
            const PracticeTask made = task(level, seed);
            kinds.insert(made.kind);
            pictures.insert(practiceSvg(made));
            for (const LessonFault& fault : checkLesson(made.lesson, shippedLibrary())) {
                ADD_FAILURE() << fault.path << ": " << fault.error.message;
            }
        }
        EXPECT_EQ(kinds.size(), 2U) << "level " << level;
        EXPECT_EQ(pictures.size(), 8U) << "level " << level;
    }
}

TEST(Practice, ASeedMakesAClassDrawTheSame) {
    const PracticeTask once = task(3, 12);
    const PracticeTask again = task(3, 12);
    EXPECT_TRUE(once.shape.solid.identicalTo(again.shape.solid));
    EXPECT_EQ(writeSketchScript(once.lesson.solution), writeSketchScript(again.lesson.solution));
    EXPECT_NE(practiceSvg(once), practiceSvg(task(3, 13)));
    EXPECT_EQ(practiceTask(0, 1, shippedLibrary()).error().code, Errc::BadValue);
    EXPECT_EQ(practiceTask(kPracticeLevels + 1, 1, shippedLibrary()).error().code, Errc::BadValue);
}

TEST(Practice, HandsAreGradedByTheShapeAndMeasured) {
    int done = 0;
    for (std::uint32_t seed = 1; seed <= 6; ++seed) {
        SCOPED_TRACE(seed);
        const PracticeTask made = task(1, seed);
        std::vector<Line2> lines = linesOf(made.lesson.solution);
        const auto ruled = gradePractice(made, drawn(lines, kExactHand, seed), shippedLibrary());
        ASSERT_TRUE(ruled) << ruled.error().message;
        EXPECT_TRUE(ruled->attempt.done) << ruled->attempt.hint;
        EXPECT_GT(ruled->accuracy, 0.95);
        EXPECT_LT(ruled->hand.wobblePx, 0.5);
        EXPECT_GE(ruled->hand.strokes, 9);
        const auto rough = gradePractice(made, drawn(lines, kNormalHand, seed), shippedLibrary());
        ASSERT_TRUE(rough);
        EXPECT_GT(rough->hand.wobblePx, ruled->hand.wobblePx);
        done += rough->attempt.done ? 1 : 0;
        for (Line2& line : lines) {
            for (Vec2& p : line) p.x() = 1280.0 - p.x();  // the mirror image is as good
        }
        const auto mirrored = gradePractice(made, drawn(lines, kExactHand, seed), shippedLibrary());
        ASSERT_TRUE(mirrored);
        EXPECT_TRUE(mirrored->attempt.done) << mirrored->attempt.hint;
        // Without one line it may still be plain what is meant.
        lines.resize(lines.size() - 3);
        const auto less = gradePractice(made, drawn(lines, kExactHand, seed), shippedLibrary());
        ASSERT_TRUE(less);
        EXPECT_FALSE(less->attempt.done);
        EXPECT_FALSE(less->attempt.hint.empty());
        EXPECT_EQ(less->accuracy, 0.0);
    }
    EXPECT_GE(done, 5);
}

TEST(Practice, AnotherSolidIsNotIt) {
    const PracticeTask box = task(1, 1);
    const PracticeTask stairs = task(4, 1);
    const auto grade =
        gradePractice(box, drawn(linesOf(stairs.lesson.solution), kExactHand, 1), shippedLibrary());
    ASSERT_TRUE(grade);
    EXPECT_FALSE(grade->attempt.done);
    EXPECT_EQ(grade->attempt.hint, "wrong-shape");
}

TEST(Practice, PenTimesAreAdded) {
    Stroke stroke = straightStroke({0, 0}, {300, 0});
    for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
        stroke.samples[i].timeMs = 10.0 * static_cast<double>(i);
    }
    const StrokeMeasure hand = measureStrokes({stroke, stroke});
    EXPECT_EQ(hand.strokes, 2);
    EXPECT_NEAR(hand.seconds, 2 * (static_cast<double>(stroke.samples.size()) - 1) / 100, 1e-9);
    EXPECT_LT(hand.wobblePx, 0.1);
}

TEST(PracticePicture, ShowsHiddenEdgesInThreeViewsOnly) {
    int dashed = 0;
    for (std::uint32_t seed = 1; seed <= 8; ++seed) {
        const std::string box = practiceSvg(task(1, seed));
        EXPECT_EQ(box.find("dasharray"), std::string::npos) << "all of its edges lie behind others";
        const PracticeTask made = task(4, seed);
        const std::string svg = practiceSvg(made);
        const bool three = made.kind == PracticeKind::ThreeViews;
        const bool dashes = svg.find("dasharray") != std::string::npos;
        EXPECT_TRUE(three || !dashes);
        dashed += dashes ? 1 : 0;
        EXPECT_EQ(svg.find(">Front<") != std::string::npos, three);
        EXPECT_EQ(svg.find("nan"), std::string::npos);
    }
    EXPECT_GE(dashed, 1);
}

TEST(PracticeLog, KeepsTheNewestAndLeavesWhatItCannotRead) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("deep/practice.json");
    const PracticeLog log(path);
    EXPECT_TRUE(log.list()->empty());
    PracticeResult result{1'700'000'000, 2, 17, 0.9, 12.5, 1.25, 9};
    ASSERT_TRUE(log.add(result));
    EXPECT_EQ(*log.list(), std::vector<PracticeResult>{result});
    std::vector<PracticeResult> many;
    for (std::uint32_t i = 0; i < kMostResults + 5; ++i) {
        result.seed = i;
        addResult(many, result);
    }
    EXPECT_EQ(many.size(), kMostResults);
    EXPECT_EQ(many.front().seed, 5U);
    const std::string whole = *readFileBytes(path, 1U << 20U);
    ASSERT_TRUE(writeFileBytes(path, whole.substr(0, whole.size() / 2)));
    EXPECT_FALSE(log.list());
    EXPECT_FALSE(log.add(result));
    EXPECT_EQ(*readFileBytes(path, 1U << 20U), whole.substr(0, whole.size() / 2));
}

TEST(PracticeProgram, PrintsAnExerciseAndGradesAnAnswer) {
    const QTemporaryDir folder;
    const auto run = [&](const QStringList& words, std::string& out) {
        QProcess program;
        program.start(QCoreApplication::applicationDirPath() + "/../app/edgewright-lesson", words);
        EXPECT_TRUE(program.waitForFinished(60'000));
        out = program.readAllStandardOutput().toStdString();
        return program.exitCode();
    };
    const QStringList exercise{"practice", "--level", "2", "--seed", "5"};
    std::string out;
    const QString solution = folder.filePath("solution.json");
    ASSERT_EQ(run(exercise + QStringList{"--json", "--solution", solution, "--svg",
                                         folder.filePath("a.svg")},
                  out),
              0);
    const auto json = nlohmann::json::parse(out);
    EXPECT_EQ(json["level"], 2);
    EXPECT_EQ(json["svg"].get<std::string>(), *readFileBytes(folder.filePath("a.svg"), 1U << 20U));
    ASSERT_EQ(run(exercise + QStringList{"--answer", solution, "--json"}, out), 0) << out;
    EXPECT_EQ(nlohmann::json::parse(out)["done"], true);
    SketchScript empty;
    ASSERT_TRUE(writeFileBytes(folder.filePath("empty.json"), writeSketchScript(empty)));
    EXPECT_EQ(run(exercise + QStringList{"--answer", folder.filePath("empty.json")}, out), 1);
    EXPECT_TRUE(out.starts_with("not-yet")) << out;
    EXPECT_EQ(run({"practice", "--level", "9", "--seed", "5"}, out), 2);
    EXPECT_EQ(run({"practice", "--level", "1"}, out), 2);
}

}  // namespace
}  // namespace ew::test
