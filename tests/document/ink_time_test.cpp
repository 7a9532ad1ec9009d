// SPDX-License-Identifier: GPL-3.0-or-later
// Ink and steps in one line of time, and ink that an apply does not use.
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QUndoStack>

#include "core/document/document.h"
#include "core/document/replay.h"
#include "tests/document/fixtures.h"

namespace ew {
namespace {

using test::fakeDocument;
using test::line;

int draw(Document& d, double y) {
    const auto id = d.addStroke(line({100, y}, {105, y}));
    EXPECT_TRUE(id);
    return *id;
}

std::vector<int> ids(const Document& d) {
    std::vector<int> out;
    for (const PendingStroke& s : d.pendingStrokes()) out.push_back(s.id);
    return out;
}

/// Ctrl+Z and its way back, as the window has them.
bool back(Document& d) { return d.undoInk() || d.undo().has_value(); }
bool forward(Document& d) { return d.redoInk() || d.redo().has_value(); }

/// What there is at a moment: how many steps are done and which ink waits.
using Moment = std::pair<int, std::vector<int>>;
Moment now(const Document& d) { return {d.undoStack().index(), ids(d)}; }

TEST(InkTime, AStrokeThatWasUndoneComesBackUntilSomethingElseIsDrawn) {
    const auto d = fakeDocument();
    const int a = draw(*d, 10);
    const int b = draw(*d, 60);
    EXPECT_FALSE(d->canRedoInk());
    ASSERT_TRUE(d->undoInk());
    ASSERT_TRUE(d->undoInk());
    EXPECT_TRUE(d->pendingStrokes().empty());
    ASSERT_TRUE(d->redoInk());
    ASSERT_TRUE(d->redoInk());
    EXPECT_EQ(ids(*d), (std::vector<int>{a, b}));
    EXPECT_FALSE(d->redoInk());
    // What was erased and cleared goes both ways too.
    ASSERT_TRUE(d->eraseAt({102, 10}));
    d->clearStrokes();
    ASSERT_TRUE(d->undoInk());
    EXPECT_EQ(ids(*d), (std::vector<int>{b}));
    ASSERT_TRUE(d->undoInk());
    EXPECT_EQ(ids(*d), (std::vector<int>{a, b}));
    ASSERT_TRUE(d->redoInk());
    EXPECT_EQ(ids(*d), (std::vector<int>{b}));
    ASSERT_TRUE(d->undoInk());
    draw(*d, 90);
    EXPECT_FALSE(d->canRedoInk());
    EXPECT_EQ(d->recordedScript().steps.size(), 3U) << "what was taken back is not written down";
}

TEST(InkTime, InkAndStepsAreOneLine) {
    const auto d = fakeDocument();
    std::vector<Moment> line{now(*d)};
    const auto note = [&] { line.push_back(now(*d)); };
    draw(*d, 10);
    note();
    draw(*d, 60);
    note();
    draw(*d, 90);
    note();
    draw(*d, 120);
    note();
    ASSERT_TRUE(d->eraseAt({102, 60}));
    note();
    draw(*d, 150);
    note();
    ASSERT_TRUE(d->apply());
    note();
    draw(*d, 20);
    note();
    ASSERT_TRUE(d->fillet({{}, 0.1, {}, false}));  // takes no ink
    note();
    ASSERT_TRUE(d->apply());
    note();
    draw(*d, 30);
    note();
    for (int turn = 0; turn < 2; ++turn) {
        for (std::size_t i = line.size() - 1; i-- > 0;) {
            ASSERT_TRUE(back(*d)) << i;
            EXPECT_EQ(now(*d), line[i]) << i;
        }
        EXPECT_FALSE(back(*d));
        for (std::size_t i = 1; i < line.size(); ++i) {
            ASSERT_TRUE(forward(*d)) << i;
            EXPECT_EQ(now(*d), line[i]) << i;
        }
        EXPECT_FALSE(forward(*d));
    }
}

TEST(InkTime, TheHistoryIsWalkedWithItsInk) {
    const auto d = fakeDocument();
    const int a = draw(*d, 10);
    ASSERT_TRUE(d->apply());
    const int b = draw(*d, 20);
    ASSERT_TRUE(d->apply());
    draw(*d, 30);
    ASSERT_TRUE(d->goToStep(0));
    EXPECT_EQ(now(*d), (Moment{0, {a}})) << "ink of later drawings is not there yet";
    ASSERT_TRUE(d->goToStep(1));
    EXPECT_EQ(now(*d), (Moment{1, {}}));
    ASSERT_TRUE(d->goToStep(2));
    EXPECT_EQ(now(*d), (Moment{2, {}}));
    ASSERT_TRUE(d->redoInk());
    ASSERT_TRUE(d->goToStep(1));
    EXPECT_EQ(now(*d), (Moment{1, {b}}));
    EXPECT_EQ(d->goToStep(3).error().code, Errc::BadValue);
    EXPECT_EQ(d->goToStep(-1).error().code, Errc::BadValue);
}

TEST(InkTime, AGestureThatIsGivenUpLeavesNothingToRedo) {
    const auto d = fakeDocument();
    draw(*d, 10);
    ASSERT_TRUE(d->withdrawInk());
    EXPECT_TRUE(d->pendingStrokes().empty());
    EXPECT_FALSE(d->canRedoInk());
    EXPECT_FALSE(d->withdrawInk());
}

TEST(InkTime, IsThereAfterSavingAndOpening) {
    const QTemporaryDir folder;
    const auto d = fakeDocument();
    const int a = draw(*d, 10);
    const int b = draw(*d, 60);
    ASSERT_TRUE(d->apply({.candidate = 0, .templateId = {}, .obliqueFactor = {}}));
    const int c = draw(*d, 90);
    ASSERT_TRUE(d->save(folder.filePath("d.edgewright")));
    const auto e = fakeDocument();
    ASSERT_TRUE(e->open(folder.filePath("d.edgewright")));
    for (const Moment& m : {Moment{1, {}}, Moment{0, {a, b}}, Moment{0, {a}}, Moment{0, {}}}) {
        ASSERT_TRUE(back(*e));
        EXPECT_EQ(now(*e), m);
    }
    for (const Moment& m : {Moment{0, {a}}, Moment{0, {a, b}}, Moment{1, {}}, Moment{1, {c}}}) {
        ASSERT_TRUE(forward(*e));
        EXPECT_EQ(now(*e), m);
    }
    // The script of an opened document tells of it as well.
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(back(*e));
    const auto again = fakeDocument();
    ASSERT_EQ(replay(*again, e->recordedScript(), {}).firstFailure(), nullptr);
    EXPECT_EQ(again->pendingStrokes().size(), 1U);
    EXPECT_TRUE(test::sameState(again->state(), e->state()));
}

TEST(InkTime, ScriptsUndoInkToo) {
    const auto script = readSketchScript(R"({"format": "edgewright-sketch", "version": 1, "steps": [
        {"do": "stroke", "points": [[0, 0], [5, 5]]}, {"do": "stroke", "points": [[0, 9], [5, 5]]},
        {"do": "stroke", "points": [[9, 9], [5, 5]]}, {"do": "stroke", "points": [[9, 0], [5, 5]]},
        {"do": "apply"}, {"do": "undo"}, {"do": "undo", "of": "ink", "count": 3},
        {"do": "redo", "of": "ink"}, {"do": "undo", "of": "steps"}]})");
    ASSERT_TRUE(script) << script.error().message;
    const auto d = fakeDocument();
    const ReplayReport report = replay(*d, *script, {});
    ASSERT_NE(report.firstFailure(), nullptr);
    EXPECT_EQ(report.firstFailure()->index, 8);
    EXPECT_EQ(now(*d), (Moment{0, {0, 1}}));
    for (const char* step : {R"({"do": "undo", "of": "ink", "count": 9})",
                             R"({"do": "redo", "of": "ink", "count": 9})"}) {
        const auto one = readSketchScript(
            std::string(R"({"format": "edgewright-sketch", "version": 1, "steps": [)") + step +
            "]}");
        ASSERT_TRUE(one);
        const auto failed = replay(*fakeDocument(), *one, {});
        ASSERT_NE(failed.firstFailure(), nullptr) << step;
        EXPECT_EQ(writeSketchScript(*readSketchScript(writeSketchScript(*one))),
                  writeSketchScript(*one));
    }
    EXPECT_EQ(readSketchScript(R"({"format": "edgewright-sketch", "version": 1, "steps": [
                  {"do": "undo", "of": "time"}]})")
                  .error()
                  .code,
              Errc::BadValue);
}

// Ink that is not used ---------------------------------------------------------------------------

/// Explains the first stroke in its first candidate, all but the second in the other.
Interpretation choosy(const std::vector<Stroke>& strokes, const TemplateLibrary& library,
                      const InterpretOptions& options) {
    Interpretation r = test::fakeInterpreter(strokes, library, options);
    for (std::size_t k = 0; k < r.candidates.size(); ++k) {
        for (int i = 0; i < static_cast<int>(strokes.size()); ++i) {
            const bool unused = k == 0 ? i > 0 : i == 1;
            if (unused) r.candidates[k].unusedStrokes.push_back(i);
        }
        r.candidates[k].unusedStrokes.push_back(99);  // nonsense does no harm
    }
    return r;
}

std::unique_ptr<Document> choosyDocument() {
    return std::make_unique<Document>(test::smallLibrary(), &choosy);
}

TEST(UnusedInk, StaysWhereTheCandidateDoesNotExplainIt) {
    const auto d = choosyDocument();
    const int a = draw(*d, 10);
    const int b = draw(*d, 60);
    const int c = draw(*d, 90);
    const int e = draw(*d, 120);
    const int f = draw(*d, 150);
    ASSERT_TRUE(d->apply());
    EXPECT_EQ(now(*d), (Moment{1, {b, c, e, f}}));
    EXPECT_EQ(d->lastApply(), nullptr) << "the ink that is left is what is read now";
    // Time goes back past the step before the ink that it left.
    EXPECT_FALSE(d->canUndoInk());
    ASSERT_TRUE(back(*d));
    EXPECT_EQ(now(*d), (Moment{0, {a, b, c, e, f}}));
    ASSERT_TRUE(back(*d));
    EXPECT_EQ(now(*d), (Moment{0, {a, b, c, e}}));
    ASSERT_TRUE(forward(*d));
    ASSERT_TRUE(forward(*d));
    EXPECT_EQ(now(*d), (Moment{1, {b, c, e, f}}));
    // The rest makes the next solid, with a repair as with an apply.
    d->clearStrokes();
    ASSERT_TRUE(d->undoInk());
    Repair take;
    take.kind = Repair::Kind::UseCandidate;
    take.candidate = 1;
    ASSERT_TRUE(d->repair(take));
    EXPECT_EQ(now(*d), (Moment{2, {c}}));
}

TEST(UnusedInk, IsTheRightOneForEachReading) {
    const auto d = choosyDocument();
    const int a = draw(*d, 10);
    const int b = draw(*d, 60);
    ASSERT_TRUE(d->apply({.candidate = 0, .templateId = {}, .obliqueFactor = {}}));
    EXPECT_EQ(ids(*d), (std::vector<int>{b}));
    // Dropped ink makes the other readings reachable again; their strokes are told by what they
    // were read from.
    d->clearStrokes();
    ASSERT_NE(d->lastApply(), nullptr);
    ASSERT_TRUE(d->chooseReading(1));
    EXPECT_EQ(now(*d), (Moment{1, {}}));
    ASSERT_TRUE(d->undo());
    EXPECT_EQ(ids(*d), (std::vector<int>{a}));
}

TEST(UnusedInk, IsKeptInAFileAndReplays) {
    const QTemporaryDir folder;
    const auto d = choosyDocument();
    for (const double y : {10.0, 60.0, 90.0, 120.0}) draw(*d, y);
    ASSERT_TRUE(d->apply());
    const auto again = choosyDocument();
    ASSERT_EQ(replay(*again, d->recordedScript(), {}).firstFailure(), nullptr);
    EXPECT_EQ(now(*again), now(*d));
    ASSERT_TRUE(d->save(folder.filePath("d.edgewright")));
    const auto opened = choosyDocument();
    ASSERT_TRUE(opened->open(folder.filePath("d.edgewright")));
    EXPECT_EQ(now(*opened), now(*d));
    while (back(*d)) {
        ASSERT_TRUE(back(*opened));
        EXPECT_EQ(now(*opened), now(*d));
    }
    EXPECT_FALSE(back(*opened));
}

}  // namespace
}  // namespace ew
