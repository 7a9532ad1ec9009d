// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/lesson/attempt.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QProcess>
#include <QTemporaryDir>
#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/document/file_bytes.h"
#include "core/document/lesson/lesson_check.h"
#include "core/hand/hand_model.h"
#include "tests/lesson/shipped.h"

namespace ew::test {
namespace {

Lesson lessonOf(const QString& id) {
    auto lesson = readLesson(lessonFolder(id));
    EXPECT_TRUE(lesson) << lesson.error().message;
    return *std::move(lesson);
}

std::size_t beginOf(const Lesson& lesson, std::size_t step) {
    return step == 0 ? 0 : lesson.steps[step - 1].end;
}

/// The ghost lines of a step: its solution's strokes from end to end, corner by corner.
std::vector<Line2> linesOf(const Lesson& lesson, std::size_t step) {
    std::vector<Line2> out;
    for (std::size_t i = beginOf(lesson, step); i < lesson.steps[step].end; ++i) {
        const auto* drawn = std::get_if<StrokeStep>(&lesson.solution.steps[i]);
        if (drawn == nullptr) continue;
        const auto& samples = drawn->stroke.samples;
        Vec2 from = samples.front().position;
        for (std::size_t k = 1; k < samples.size(); ++k) {
            const Vec2& here = samples[k].position;
            const bool last = k + 1 == samples.size();
            const Vec2 in = (here - samples[k - 1].position).normalized();
            constexpr double kStraight = 0.99;
            if (!last && in.dot((samples[k + 1].position - here).normalized()) > kStraight)
                continue;
            out.push_back({from, here});
            from = here;
        }
    }
    return out;
}

SketchScript scriptOf(const std::vector<Stroke>& strokes) {
    SketchScript out;
    for (const Stroke& s : strokes) out.steps.push_back(StrokeStep{s, false});
    return out;
}

SketchScript ruled(const std::vector<Line2>& lines) {
    Random random(1);
    HandHabits habits;
    habits.oneStrokePerEdge = 1.0;
    habits.shortTrails = habits.wholeFaces = habits.longTrails = 0.0;
    return scriptOf(drawByHand(lines, kExactHand, random, habits));
}

Attempt attempt(const Lesson& lesson, std::size_t step, const SketchScript& script) {
    const auto tried = tryStep(lesson, step, script, shippedLibrary());
    EXPECT_TRUE(tried) << tried.error().message;
    return tried.value_or(Attempt{});
}

TEST(ShippedLessons, PassTheirOwnCheck) {
    const QStringList ids = shippedLessons();
    EXPECT_EQ(ids.size(), 9);
    for (const QString& id : ids) {
        SCOPED_TRACE(id.toStdString());
        const Lesson lesson = lessonOf(id);
        EXPECT_EQ(QString::fromStdString(lesson.id), id);
        EXPECT_LE(lesson.minutes, 10);
        for (const LessonFault& fault : checkLesson(lesson, shippedLibrary())) {
            ADD_FAILURE() << fault.path << ": " << fault.error.message;
        }
    }
}

TEST(Attempts, AnyOrderAndSideOfTheDrawingIsAsGood) {
    const Lesson lesson = lessonOf("first-box");
    std::vector<Line2> lines = linesOf(lesson, 0);
    ASSERT_EQ(lines.size(), 9U);
    std::reverse(lines.begin(), lines.end());
    for (Line2& line : lines) std::swap(line[0], line[1]);
    EXPECT_TRUE(attempt(lesson, 0, ruled(lines)).done);
    for (Line2& line : lines) {
        for (Vec2& p : line) p.x() = 1280.0 - p.x();  // the mirror image
    }
    EXPECT_TRUE(attempt(lesson, 0, ruled(lines)).done);
    for (Line2& line : lines) {
        for (Vec2& p : line) p = 1.3 * p + Vec2(-300, 40);  // elsewhere and larger
    }
    EXPECT_TRUE(attempt(lesson, 0, ruled(lines)).done);
}

TEST(Attempts, NothingDrawnIsNotYet) {
    const Attempt nothing = attempt(lessonOf("first-box"), 0, {});
    EXPECT_FALSE(nothing.done);
    EXPECT_EQ(nothing.hint, "not-yet");
    EXPECT_FALSE(nothing.message.empty());
}

TEST(Attempts, TheHintNamesWhatIsWrong) {
    const Lesson lesson = lessonOf("first-box");
    const std::vector<Line2> box = linesOf(lesson, 0);
    const auto hintOf = [&](const std::vector<Line2>& lines) {
        return attempt(lesson, 0, ruled(lines)).hint;
    };
    int missed = 0;
    for (std::size_t i = 0; i < box.size(); ++i) {
        std::vector<Line2> lines = box;
        lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(i));
        // Some boxes are plain without one of their lines, too.
        const std::string hint = hintOf(lines);
        EXPECT_TRUE(hint == "missing-edge" || hint.empty()) << i << " " << hint;
        missed += hint.empty() ? 0 : 1;
    }
    EXPECT_GE(missed, 4);
    std::vector<Line2> more = box;
    more.push_back({box[0][0], box[0][0] + 1.4 * (box[4][1] - box[0][0])});
    EXPECT_EQ(hintOf(more), "extra-edge");

    std::vector<Line2> small = box;
    for (Line2& line : small) {
        for (Vec2& p : line) p = Vec2(640, 400) + 0.03 * (p - Vec2(640, 400));
    }
    EXPECT_EQ(hintOf(small), "too-small");

    std::vector<Line2> two = box;
    for (const Line2& line : box) two.push_back({line[0] + Vec2(430, 0), line[1] + Vec2(430, 0)});
    const std::string hint = hintOf(two);
    EXPECT_EQ(hint, "separate-drawings");

    EXPECT_EQ(hintOf(linesOf(lessonOf("prism-and-pyramid"), 0)), "wrong-shape");
    EXPECT_EQ(hintOf(linesOf(lesson, 1)), "wrong-proportions") << "a flat box is another one";
}

TEST(Attempts, OnASolidThePlaceAndTheSideCount) {
    const Lesson lesson = lessonOf("cut-and-add");
    const std::vector<Line2> boss = linesOf(lesson, 1);
    const std::vector<Line2> notch = linesOf(lesson, 2);
    EXPECT_TRUE(attempt(lesson, 1, ruled(boss)).done);
    EXPECT_EQ(attempt(lesson, 1, ruled(notch)).hint, "wrong-side");
    EXPECT_EQ(attempt(lesson, 2, ruled(boss)).hint, "no-change") << "it stands there already";
    // Along the top face, half the base's length away.
    std::vector<Line2> away = boss;
    const Vec2 along = 0.9 * (notch[1][1] - notch[1][0]);
    for (Line2& line : away) {
        for (Vec2& p : line) p -= 2.0 * along;
    }
    EXPECT_EQ(attempt(lesson, 1, ruled(away)).hint, "wrong-place");
}

TEST(Attempts, AStepAboutTheThresholdsIsDoneByThem) {
    const Lesson lesson = lessonOf("thresholds");
    EXPECT_EQ(attempt(lesson, 1, {}).hint, "not-yet");
    SketchScript script;
    script.steps.push_back(ThresholdsStep{60.0, std::nullopt});
    EXPECT_EQ(attempt(lesson, 1, script).hint, "wrong-settings");
    script.steps.push_back(ThresholdsStep{32.0, std::nullopt});
    EXPECT_TRUE(attempt(lesson, 1, script).done);
}

TEST(Attempts, WhatIsNoDrawingIsNoStepForLessons) {
    const Lesson lesson = lessonOf("first-box");
    SketchScript script;
    script.steps.push_back(SaveStep{"x.edgewright"});
    EXPECT_EQ(tryStep(lesson, 0, script, shippedLibrary()).error().code, Errc::BadValue);
    EXPECT_EQ(tryStep(lesson, 99, {}, shippedLibrary()).error().code, Errc::BadValue);
}

TEST(Attempts, HandsFinishByTracing) {
    int tried = 0;
    int done = 0;
    for (const QString& id : shippedLessons()) {
        const Lesson lesson = lessonOf(id);
        for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
            const auto& last = lesson.solution.steps[lesson.steps[step].end - 1];
            if (!std::holds_alternative<ApplyStep>(last)) continue;
            for (std::uint64_t n = 0; n < 4; ++n) {
                Random random(Random::mix(n, step));
                const auto strokes = drawByHand(linesOf(lesson, step), kNormalHand, random);
                const Attempt a = attempt(lesson, step, scriptOf(strokes));
                ++tried;
                done += a.done ? 1 : 0;
                if (!a.done) {
                    std::printf("%s step %zu hand %d: %s %s\n", id.toStdString().c_str(), step,
                                static_cast<int>(n), a.hint.c_str(), a.message.c_str());
                }
            }
        }
    }
    EXPECT_GE(done * 100, tried * 90) << done << " of " << tried;
}

TEST(LessonProgram, ChecksAndTries) {
    const QTemporaryDir folder;
    const QString strokes = folder.filePath("strokes.json");
    const auto run = [&](const QStringList& words) {
        QProcess process;
        process.start(QCoreApplication::applicationDirPath() + "/../app/edgewright-lesson", words);
        EXPECT_TRUE(process.waitForFinished(60'000));
        return std::pair(process.exitCode(), process.readAllStandardOutput().toStdString());
    };
    EXPECT_EQ(run({"check", lessonFolder("first-box")}), std::pair(0, std::string()));
    EXPECT_EQ(run({"check", folder.filePath("none")}).first, 2);
    EXPECT_EQ(run({"fly"}).first, 2);
    EXPECT_EQ(run({}).first, 2);
    EXPECT_EQ(run({"--help"}).first, 0);
    ASSERT_TRUE(writeFileBytes(folder.filePath("broken.json"), "{}"));
    const auto [status, line] = run({"check", folder.filePath("broken.json")});
    EXPECT_EQ(status, 1);
    EXPECT_NE(line.find("broken.json: /"), std::string::npos) << line;

    const Lesson lesson = lessonOf("first-box");
    const auto tryLines = [&](const std::vector<Line2>& lines) {
        EXPECT_TRUE(writeFileBytes(strokes, writeSketchScript(ruled(lines))));
        const auto [code, text] =
            run({"try", lessonFolder("first-box"), "--step", "0", "--strokes", strokes, "--json"});
        return std::pair(code, nlohmann::json::parse(text));
    };
    std::vector<Line2> lines = linesOf(lesson, 0);
    auto [good, said] = tryLines(lines);
    EXPECT_EQ(good, 0);
    EXPECT_TRUE(said["done"].get<bool>());
    EXPECT_TRUE(said["hint"].is_null());
    lines.pop_back();
    auto [bad, told] = tryLines(lines);
    EXPECT_EQ(bad, 1);
    EXPECT_FALSE(told["done"].get<bool>());
    EXPECT_EQ(told["hint"], "missing-edge");
    EXPECT_FALSE(told["message"].get<std::string>().empty());
    EXPECT_EQ(run({"try", lessonFolder("first-box"), "--step", "9", "--strokes", strokes}).first,
              2);
    EXPECT_EQ(run({"try", lessonFolder("first-box"), "--step", "0"}).first, 2);
}

}  // namespace
}  // namespace ew::test
