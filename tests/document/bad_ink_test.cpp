// SPDX-License-Identifier: GPL-3.0-or-later
// Ink that no solid can come from, all the way from the text of a script: a coded error each, and
// solid, ink and history as they were.
#include <gtest/gtest.h>

#include <QUndoStack>
#include <cmath>
#include <numbers>

#include "core/document/document.h"
#include "core/document/replay.h"
#include "core/document/sketch_script.h"

namespace ew {
namespace {

const TemplateLibrary& library() {
    static const TemplateLibrary kShipped =
        loadLibrary(EDGEWRIGHT_SOURCE_DIR "/resources/templates")->library;
    return kShipped;
}

using Lines = std::vector<std::vector<Vec2>>;

/// The edges of a box that the default camera sees.
Lines boxAt(const Vec3& corner) {
    const OrthographicCamera camera;
    const auto p = [&](double x, double y, double z) {
        return camera.project(corner + Vec3(40 * x, 30 * y, 20 * z));
    };
    return {{p(0, 0, 0), p(1, 0, 0), p(1, 1, 0), p(1, 1, 1), p(0, 1, 1), p(0, 0, 1), p(0, 0, 0)},
            {p(1, 0, 1), p(1, 0, 0)},
            {p(1, 0, 1), p(0, 0, 1)},
            {p(1, 0, 1), p(1, 1, 1)}};
}

/// radius(t) about the middle of the viewport, t in turns.
template <class Radius>
std::vector<Vec2> roundAbout(double turns, double squeeze, Radius radius) {
    std::vector<Vec2> points;
    for (double t = 0; t <= turns; t += 0.01) {
        const double a = 2 * std::numbers::pi * t;
        points.push_back(Vec2(640, 400) +
                         radius(t) * Vec2(std::cos(a), std::sin(squeeze * a + 0.3)));
    }
    return points;
}

std::string strokeStep(const std::vector<Vec2>& points) {
    std::string text = R"({"do": "stroke", "points": [)";
    for (const Vec2& p : points) {
        if (text.back() == ']') text += ",";
        text += "[" + std::to_string(p.x()) + "," + std::to_string(p.y()) + "]";
    }
    return text + "]}";
}

SketchScript script(const std::string& steps) {
    auto read = readSketchScript(R"({"format": "edgewright-sketch", "version": 1, "steps": [)" +
                                 steps + "]}");
    EXPECT_TRUE(read) << read.error().message;
    return read ? std::move(*read) : SketchScript{};
}

SketchScript script(const Lines& lines, const std::string& last) {
    std::string steps;
    for (const auto& points : lines) steps += strokeStep(points) + ", ";
    return script(steps + last);
}

const char* const kApply = R"({"do": "apply"})";

/// Runs the steps on what is there already; the report of the first that fails, if one does.
std::optional<StepReport> firstFailure(Document& d, const SketchScript& script) {
    for (std::size_t i = 0; i < script.steps.size(); ++i) {
        StepReport report = runStep(d, script.steps[i], static_cast<int>(i), {});
        if (!report.ok) return report;
    }
    return {};
}

struct BadInk {
    const char* name;
    Lines lines;
    std::vector<Errc> codes;  ///< any of these says what is wrong
};

std::vector<BadInk> badInk() {
    Lines boxAndTriangle = boxAt({-60, 0, 0});
    boxAndTriangle.push_back({Vec2(900, 300), Vec2(1050, 340), Vec2(960, 480), Vec2(900, 300)});
    std::vector<Vec2> pentagram;
    for (int i = 0; i <= 5; ++i) {
        const double a = 0.8 * std::numbers::pi * i;
        pentagram.emplace_back(640 + 200 * std::cos(a), 400 + 200 * std::sin(a));
    }
    auto closedScribble = roundAbout(9, 1.3, [](double t) { return 150 - 9 * t; });
    closedScribble.push_back(closedScribble.front());
    Lines crowd;  // more lines than anybody means as one drawing
    for (int i = 0; i < 500; ++i) {
        const double a = 0.37 * i;
        crowd.push_back({Vec2(640 + 600 * std::cos(a), 400 + 380 * std::sin(1.7 * a)),
                         Vec2(640 + 600 * std::cos(2.3 * a), 400 + 380 * std::sin(a + 1))});
    }
    const std::vector<Errc> noLines{Errc::Scribble, Errc::CurvedStroke};
    const std::vector<Errc> crosses{Errc::SelfCrossing};
    return {
        {"nothing", {}, {Errc::EmptySketch}},
        {"one dot", {{Vec2(640, 400)}}, {Errc::OnlyNoise}},
        {"a dot of many samples", {std::vector<Vec2>(500, Vec2(640, 400))}, {Errc::OnlyNoise}},
        {"closed scribble", {closedScribble}, noLines},
        {"circle", {roundAbout(1, 1, [](double) { return 120.0; })}, noLines},
        {"a box and a triangle", boxAndTriangle, {Errc::SeparateDrawings}},
        {"bow tie",
         {{Vec2(500, 300), Vec2(800, 600), Vec2(800, 300), Vec2(500, 600), Vec2(500, 300)}},
         crosses},
        {"pentagram", {pentagram}, crosses},
        {"a crowd of lines", crowd, {Errc::TooManyStrokes}},
        {"as far out as ink may be",
         {{Vec2(-1e6, -1e6), Vec2(1e6, -1e6), Vec2(1e6, 1e6), Vec2(-1e6, -1e6)}},
         {Errc::FlatDrawing}},
    };
}

bool sameInk(const std::vector<PendingStroke>& a, const std::vector<PendingStroke>& b) {
    return std::equal(
        a.begin(), a.end(), b.begin(), b.end(), [](const PendingStroke& x, const PendingStroke& y) {
            const auto same = [](const PenSample& s, const PenSample& t) {
                return s.position == t.position && s.pressure == t.pressure && s.timeMs == t.timeMs;
            };
            return x.id == y.id &&
                   std::equal(x.stroke.samples.begin(), x.stroke.samples.end(),
                              y.stroke.samples.begin(), y.stroke.samples.end(), same);
        });
}

/// A document with a solid and one step of history.
std::unique_ptr<Document> withBox() {
    auto d = std::make_unique<Document>(library());
    EXPECT_FALSE(firstFailure(*d, script(boxAt({-20, -15, 0}), kApply)));
    EXPECT_EQ(d->state().bodies.size(), 1U);
    return d;
}

/// Draws and applies; the apply fails with one of the codes and changes nothing.
void expectRefused(Document& d, const BadInk& bad, const std::string& apply,
                   const std::vector<Errc>& codes) {
    ASSERT_FALSE(firstFailure(d, script(bad.lines, R"({"do": "thresholds"})")));
    const auto state = &d.state();
    const auto ink = d.pendingStrokes();
    const int index = d.undoStack().index();
    const auto report = firstFailure(d, script(apply));
    ASSERT_TRUE(report);
    const auto code = report->error->code;
    EXPECT_TRUE(codes.empty() || std::find(codes.begin(), codes.end(), code) != codes.end())
        << errcName(code) << ": " << report->error->message;
    EXPECT_NE(code, Errc::Internal);
    EXPECT_FALSE(report->error->message.empty());
    EXPECT_EQ(&d.state(), state);
    EXPECT_EQ(d.undoStack().index(), index);
    EXPECT_EQ(d.pendingStrokes().size(), bad.lines.size());
    EXPECT_TRUE(sameInk(d.pendingStrokes(), ink));
}

TEST(BadInk, IsRefusedWithItsCodeOnAnEmptySheet) {
    for (const BadInk& bad : badInk()) {
        SCOPED_TRACE(bad.name);
        Document d(library());
        expectRefused(d, bad, kApply, bad.codes);
        // What could not be read is no hindrance to what comes after it.
        d.clearStrokes();
        EXPECT_FALSE(firstFailure(d, script(boxAt({-20, -15, 0}), kApply)));
    }
}

TEST(BadInk, IsRefusedBesideASolid) {
    for (const BadInk& bad : badInk()) {
        SCOPED_TRACE(bad.name);
        const auto d = withBox();
        expectRefused(*d, bad, R"({"do": "apply", "operation": "create"})", bad.codes);
    }
}

TEST(BadInk, IsRefusedOnASolid) {
    for (const BadInk& bad : badInk()) {
        SCOPED_TRACE(bad.name);
        const auto d = withBox();
        expectRefused(*d, bad, kApply, {});
    }
}

TEST(BadInk, AMillionPointsInAStrokeAreRefusedAtTheStroke) {
    const auto d = withBox();
    const auto state = &d->state();
    const auto report =
        firstFailure(*d, script(strokeStep(std::vector<Vec2>(1'000'000, Vec2(10.5, 20.25)))));
    ASSERT_TRUE(report);
    EXPECT_EQ(report->error->code, Errc::TooManyPoints);
    EXPECT_EQ(&d->state(), state);
    EXPECT_TRUE(d->pendingStrokes().empty());
}

TEST(BadInk, TenThousandStrokesAreRefusedWhereTheyBecomeTooMany) {
    const auto d = withBox();
    const auto state = &d->state();
    std::string steps;
    for (int i = 0; i < 10'000; ++i) {
        const double y = 20 + 0.07 * i;
        steps += strokeStep({Vec2(100, y), Vec2(900, y + 3)}) + ", ";
    }
    const auto report = firstFailure(*d, script(steps + kApply));
    ASSERT_TRUE(report);
    EXPECT_EQ(report->error->code, Errc::TooManyStrokes);
    EXPECT_EQ(report->index, static_cast<int>(kMaxPendingStrokes));
    EXPECT_EQ(d->pendingStrokes().size(), kMaxPendingStrokes);
    // As many as it takes are too many to make sense of, which is told like any other misreading.
    const auto applied = firstFailure(*d, script(kApply));
    ASSERT_TRUE(applied);
    EXPECT_NE(applied->error->code, Errc::Internal);
    EXPECT_EQ(d->pendingStrokes().size(), kMaxPendingStrokes);
    EXPECT_EQ(&d->state(), state);
}

TEST(BadInk, CoordinatesThatAreNoPlaceAreRefusedAtTheStroke) {
    const auto d = withBox();
    ASSERT_TRUE(d->addStroke(Stroke{{{Vec2(1, 2), 1, 0}, {Vec2(90, 2), 1, 0}}}));
    const auto before = d->pendingStrokes();
    for (const char* point : {"[1e308, 0]", "[0, -1e308]", "[1000001, 0]"}) {
        const auto report = firstFailure(
            *d, script(std::string(R"({"do": "stroke", "points": [[1, 1], )") + point + "]}"));
        ASSERT_TRUE(report) << point;
        EXPECT_EQ(report->error->code, Errc::BadCoordinates) << point;
        EXPECT_TRUE(sameInk(d->pendingStrokes(), before)) << point;
    }
    for (const char* point : {"[NaN, 0]", "[Infinity, 0]", "[-Infinity, 0]", "[nan, 0]"}) {
        const auto read =
            readSketchScript(std::string(R"({"format": "edgewright-sketch", "version": 1,
                            "steps": [{"do": "stroke", "points": [)") +
                             point + "]}]}");
        ASSERT_FALSE(read) << point;
        EXPECT_EQ(read.error().code, Errc::Syntax) << point;
    }
}

TEST(TwoBoxes, BecomeTwoBodiesInOneStep) {
    Document d(library());
    Lines lines = boxAt({-60, 0, 0});
    for (auto& points : boxAt({60, 60, 0})) lines.push_back(std::move(points));
    const auto failure = firstFailure(d, script(lines, kApply));
    ASSERT_FALSE(failure) << failure->error->message;
    ASSERT_EQ(d.state().bodies.size(), 2U);
    for (const Body& body : d.state().bodies) {
        EXPECT_EQ(body.solid.shellCount(), 1);
        EXPECT_NEAR(body.solid.volume(), 40 * 30 * 20, 1.0);
    }
    ASSERT_TRUE(d.undo());
    EXPECT_TRUE(d.state().bodies.empty());
    EXPECT_EQ(d.pendingStrokes().size(), lines.size());
    ASSERT_TRUE(d.redo());
    EXPECT_EQ(d.state().bodies.size(), 2U);
}

}  // namespace
}  // namespace ew
