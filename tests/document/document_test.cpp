// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/document.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QUndoStack>
#include <cmath>
#include <limits>
#include <set>

#include "core/document/document_compare.h"
#include "core/document/replay.h"
#include "tests/document/fixtures.h"

namespace ew {
namespace {

using test::fakeDocument;
using test::line;

/// Collects what the document says.
struct Listener : QObject {
    explicit Listener(Document& document) {
        connect(&document, &Document::changed, this,
                [this](DocumentChange what) { heard.insert(what); });
    }
    bool take(DocumentChange what) { return heard.erase(what) > 0; }
    std::set<DocumentChange> heard;
};

void draw(Document& d, double size) {
    ASSERT_TRUE(d.addStroke(line({100, 100}, {100 + size, 103})));
}

TEST(Document, StartsEmptyAndUnmodified) {
    const auto d = fakeDocument();
    EXPECT_TRUE(d->state().bodies.empty());
    EXPECT_TRUE(d->pendingStrokes().empty());
    EXPECT_EQ(d->undoStack().count(), 0);
    EXPECT_FALSE(d->isModified());
    EXPECT_FALSE(d->canUndoInk());
    EXPECT_EQ(d->state().library.size(), 1U);
    EXPECT_TRUE(d->recordedScript().steps.empty());
}

TEST(Document, RefusesBadStrokesAndKeepsItsInk) {
    const auto d = fakeDocument();
    draw(*d, 5);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    const std::vector<std::pair<Stroke, Errc>> table{
        {Stroke{}, Errc::EmptySketch},
        {line({nan, 0}, {1, 1}), Errc::BadCoordinates},
        {line({0, 0}, {1, inf}), Errc::BadCoordinates},
        {line({0, 1e308}, {1, 1}), Errc::BadCoordinates},
        {Stroke{{{Vec2(0, 0), nan, 0}}}, Errc::BadCoordinates},
        {Stroke{{{Vec2(0, 0), 1, inf}}}, Errc::BadCoordinates},
        {Stroke{std::vector<PenSample>(1'000'000)}, Errc::TooManyPoints},
    };
    for (const auto& [stroke, code] : table) {
        const auto added = d->addStroke(stroke);
        ASSERT_FALSE(added);
        EXPECT_EQ(added.error().code, code);
    }
    EXPECT_EQ(d->pendingStrokes().size(), 1U);
}

TEST(Document, RefusesMoreStrokesThanItReads) {
    const auto d = fakeDocument();
    for (std::size_t i = 0; i < kMaxPendingStrokes; ++i)
        ASSERT_TRUE(d->addStroke(line({0, 0}, {1, 1})));
    const auto more = d->addStroke(line({0, 0}, {1, 1}));
    ASSERT_FALSE(more);
    EXPECT_EQ(more.error().code, Errc::TooManyStrokes);
    EXPECT_EQ(d->pendingStrokes().size(), kMaxPendingStrokes);
    d->clearStrokes();
    EXPECT_TRUE(d->pendingStrokes().empty());
    EXPECT_TRUE(d->undoInk());
    EXPECT_EQ(d->pendingStrokes().size(), kMaxPendingStrokes);
}

TEST(Document, ErasesTheNearestStrokeWithinTheThreshold) {
    const auto d = fakeDocument();
    const int far = *d->addStroke(line({0, 0}, {100, 0}));
    const int near = *d->addStroke(line({0, 10}, {100, 10}));
    auto erased = d->eraseAt({50, 24.5});
    ASSERT_FALSE(erased);
    EXPECT_EQ(erased.error().code, Errc::NoStroke);
    EXPECT_EQ(erased.error().where.size(), 1U);
    erased = d->eraseAt({50, 6});
    ASSERT_TRUE(erased);
    EXPECT_EQ(*erased, near);
    EXPECT_EQ(d->pendingStrokes().front().id, far);
    EXPECT_FALSE(d->eraseAt({std::numeric_limits<double>::quiet_NaN(), 0}));
}

TEST(Document, InkHasItsOwnUndo) {
    const auto d = fakeDocument();
    Listener listener(*d);
    const int a = *d->addStroke(line({0, 0}, {9, 0}));
    const int b = *d->addStroke(line({0, 50}, {9, 50}));
    EXPECT_TRUE(listener.take(DocumentChange::Ink));
    EXPECT_TRUE(listener.take(DocumentChange::File));
    ASSERT_TRUE(d->eraseAt({4, 1}));
    ASSERT_EQ(d->pendingStrokes().size(), 1U);
    EXPECT_TRUE(d->undoInk());
    ASSERT_EQ(d->pendingStrokes().size(), 2U);
    EXPECT_EQ(d->pendingStrokes()[0].id, a);  // back in its old place
    EXPECT_EQ(d->pendingStrokes()[1].id, b);
    EXPECT_TRUE(d->undoInk());
    EXPECT_TRUE(d->undoInk());
    EXPECT_FALSE(d->undoInk());
    EXPECT_TRUE(d->pendingStrokes().empty());
    EXPECT_EQ(d->undoStack().count(), 0);
    EXPECT_TRUE(d->recordedScript().steps.empty());
}

TEST(Document, ApplyConsumesTheInkAndUndoGivesItBack) {
    const auto d = fakeDocument();
    Listener listener(*d);
    draw(*d, 5);
    listener.heard.clear();
    const auto outcome = d->apply();
    ASSERT_TRUE(outcome) << outcome.error().message;
    EXPECT_EQ(outcome->chosen, 0);
    EXPECT_TRUE(listener.take(DocumentChange::Bodies));
    EXPECT_TRUE(listener.take(DocumentChange::Ink));
    EXPECT_TRUE(listener.take(DocumentChange::History));
    ASSERT_EQ(d->state().bodies.size(), 1U);
    EXPECT_NEAR(d->state().bodies[0].solid.volume(), 6 * 4 * 2, 1e-9);
    EXPECT_TRUE(d->pendingStrokes().empty());
    EXPECT_FALSE(d->canUndoInk());
    EXPECT_EQ(d->undoStack().text(0), "Create box");

    // A stroke drawn in between stays through undo and redo.
    const int between = *d->addStroke(line({0, 0}, {1, 1}));
    ASSERT_TRUE(d->undo());
    EXPECT_TRUE(d->state().bodies.empty());
    ASSERT_EQ(d->pendingStrokes().size(), 2U);
    EXPECT_EQ(d->pendingStrokes()[1].id, between);
    ASSERT_TRUE(d->redo());
    ASSERT_EQ(d->pendingStrokes().size(), 1U);
    EXPECT_EQ(d->pendingStrokes()[0].id, between);
    EXPECT_EQ(d->state().bodies.size(), 1U);
}

TEST(Document, FailedAppliesChangeNothing) {
    const auto d = fakeDocument();
    EXPECT_EQ(d->apply().error().code, Errc::EmptySketch);
    draw(*d, 5);
    ApplyRequest request;
    request.templateId = "no-such";
    EXPECT_EQ(d->apply(request).error().code, Errc::UnknownTemplate);
    request = {};
    request.candidate = 2;
    EXPECT_EQ(d->apply(request).error().code, Errc::UnknownCandidate);
    request.candidate = -1;
    EXPECT_EQ(d->apply(request).error().code, Errc::UnknownCandidate);
    request = {};
    request.operation = Operation::Cut;
    EXPECT_EQ(d->apply(request).error().code, Errc::OperationImpossible);
    request = {};
    request.obliqueFactor = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(d->apply(request).error().code, Errc::BadValue);
    draw(*d, 6);
    EXPECT_EQ(d->apply().error().code, Errc::Ambiguous);
    draw(*d, 7);
    const auto noMatch = d->apply();
    EXPECT_EQ(noMatch.error().code, Errc::NoMatch);
    EXPECT_EQ(noMatch.error().where.size(), 1U);
    EXPECT_EQ(d->pendingStrokes().size(), 3U);
    EXPECT_EQ(d->undoStack().count(), 0);
    EXPECT_TRUE(d->state().bodies.empty());
    EXPECT_EQ(d->lastApply(), nullptr);
}

TEST(Document, ASolidThatCannotBeIsAnErrorAndKeepsTheInk) {
    const auto flat = [](const std::vector<Stroke>& strokes, const TemplateLibrary& library,
                         const InterpretOptions& options) {
        Interpretation r = test::fakeInterpreter(strokes, library, options);
        for (Candidate& c : r.candidates) c.spec = test::cornerBox(1, 1, 0);
        return r;
    };
    Document d(test::smallLibrary(), flat);
    draw(d, 5);
    EXPECT_FALSE(d.apply());
    EXPECT_EQ(d.pendingStrokes().size(), 1U);
    EXPECT_EQ(d.undoStack().count(), 0);
}

TEST(Document, AmbiguousInkIsAppliedByNumber) {
    const auto d = fakeDocument();
    draw(*d, 5);
    draw(*d, 6);
    ApplyRequest second;
    second.candidate = 1;
    const auto outcome = d->apply(second);
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->chosen, 1);
    EXPECT_NEAR(d->state().bodies[0].solid.volume(), 6 * 4 * 3 * 1.5, 1e-9);
}

TEST(Document, UndoAndRedoByCountAreAllOrNothing) {
    const auto d = fakeDocument();
    for (int i = 0; i < 3; ++i) {
        draw(*d, 5 + i);
        ASSERT_TRUE(d->apply());
    }
    EXPECT_EQ(d->undo(4).error().code, Errc::NothingToUndo);
    EXPECT_EQ(d->undo(0).error().code, Errc::BadValue);
    EXPECT_EQ(d->state().bodies.size(), 3U);
    EXPECT_EQ(d->redo().error().code, Errc::NothingToRedo);
    ASSERT_TRUE(d->undo(3));
    EXPECT_TRUE(d->state().bodies.empty());
    EXPECT_EQ(d->pendingStrokes().size(), 3U);
    EXPECT_EQ(d->redo(4).error().code, Errc::NothingToRedo);
    ASSERT_TRUE(d->redo(2));
    EXPECT_EQ(d->state().bodies.size(), 2U);
    EXPECT_EQ(d->pendingStrokes().size(), 1U);
}

TEST(Document, FollowsAHistoryThatIsMovedFromOutside) {
    const auto d = fakeDocument();
    for (int i = 0; i < 3; ++i) {
        draw(*d, 5 + i);
        ASSERT_TRUE(d->apply());
    }
    Listener listener(*d);
    d->undoStack().setIndex(1);
    EXPECT_EQ(d->state().bodies.size(), 1U);
    EXPECT_TRUE(listener.take(DocumentChange::Bodies));
    EXPECT_TRUE(listener.take(DocumentChange::History));
    d->undoStack().redo();
    EXPECT_EQ(d->state().bodies.size(), 2U);
    const auto steps = d->recordedScript().steps;
    ASSERT_GE(steps.size(), 2U);
    EXPECT_EQ(std::get<UndoStep>(steps[steps.size() - 2]).count, 2);
    EXPECT_EQ(std::get<RedoStep>(steps.back()).count, 1);
}

TEST(Document, AnotherReadingTakesThePlaceOfTheLast) {
    const auto d = fakeDocument();
    draw(*d, 5);
    ASSERT_TRUE(d->apply());
    ASSERT_NE(d->lastApply(), nullptr);
    EXPECT_EQ(d->lastApply()->interpretation.candidates.size(), 2U);
    const auto other = d->chooseReading(1);
    ASSERT_TRUE(other) << other.error().message;
    EXPECT_EQ(d->undoStack().count(), 1);
    ASSERT_EQ(d->state().bodies.size(), 1U);
    EXPECT_NEAR(d->state().bodies[0].solid.volume(), 6 * 4 * 2 * 1.5, 1e-9);
    EXPECT_EQ(d->lastApply()->chosen, 1);
    EXPECT_EQ(d->chooseReading(2).error().code, Errc::UnknownCandidate);

    // Another oblique factor: the readings follow, and choosing the same one again takes it over.
    d->setObliqueFactor(1.0);
    ASSERT_NE(d->lastApply(), nullptr);
    EXPECT_EQ(d->lastApply()->interpretation.candidates[1].spec.vertices[7].z(), 4.0);
    ASSERT_TRUE(d->chooseReading(1));
    EXPECT_NEAR(d->state().bodies[0].solid.volume(), 6 * 4 * 2 * 2, 1e-9);
    EXPECT_EQ(d->undoStack().count(), 1);

    draw(*d, 3);
    EXPECT_EQ(d->lastApply(), nullptr);
    EXPECT_FALSE(d->chooseReading(0));
    EXPECT_TRUE(d->undoInk());
    EXPECT_NE(d->lastApply(), nullptr);
    ASSERT_TRUE(d->setThresholds({20, 5}));
    EXPECT_EQ(d->lastApply(), nullptr);
}

TEST(Document, ReadsAgainOnlyWhenSomethingChanged) {
    int reads = 0;
    const auto counting = [&reads](const std::vector<Stroke>& strokes,
                                   const TemplateLibrary& library,
                                   const InterpretOptions& options) {
        ++reads;
        return test::fakeInterpreter(strokes, library, options);
    };
    Document d(test::smallLibrary(), counting);
    draw(d, 5);
    d.interpretation();
    d.interpretation();
    EXPECT_EQ(reads, 1);
    ASSERT_TRUE(d.setThresholds({20, 5}));
    d.interpretation();
    EXPECT_EQ(reads, 2);
    d.setObliqueFactor(0.8);
    d.interpretation();
    EXPECT_EQ(reads, 3);
    ASSERT_TRUE(d.defineTemplate(test::boxTemplate("slab", "Slab")));
    d.interpretation();
    EXPECT_EQ(reads, 4);
    OrthographicCamera turned;
    turned.center = Vec3(1, 2, 3);
    ASSERT_TRUE(d.setCamera(turned));  // the ink keeps the camera that it was drawn through
    d.interpretation();
    EXPECT_EQ(reads, 4);
    ASSERT_TRUE(d.apply());
    EXPECT_EQ(reads, 4);
}

TEST(Document, ReadsThroughTheCameraOfTheNewestStroke) {
    OrthographicCamera seen;
    const auto watching = [&seen](const std::vector<Stroke>& strokes,
                                  const TemplateLibrary& library, const InterpretOptions& options) {
        seen = options.camera;
        return test::fakeInterpreter(strokes, library, options);
    };
    Document d(test::smallLibrary(), watching);
    OrthographicCamera first;
    first.worldPerPixel = 0.5;
    ASSERT_TRUE(d.setCamera(first));
    draw(d, 5);
    OrthographicCamera later = first;
    later.worldPerPixel = 2;
    ASSERT_TRUE(d.setCamera(later));
    d.interpretation();
    EXPECT_EQ(seen, first);
    d.interpretWith(line({0, 0}, {5, 5}));
    EXPECT_EQ(seen, later);
    EXPECT_EQ(d.pendingStrokes().size(), 1U);
}

TEST(Document, AReadingTaskWorksOnCopies) {
    const auto d = fakeDocument();
    draw(*d, 5);
    d->clearStrokes();
    EXPECT_TRUE(d->undoInk());
    const auto task = d->readingTask(nullptr, d->camera());
    const auto before = d->interpretation().candidates.size();
    draw(*d, 5);
    EXPECT_FALSE(d->readingKnown());
    // What was drawn later is not in it.
    EXPECT_EQ(task().candidates.size(), before);
    Interpretation found = d->readingTask(nullptr, d->camera())();
    d->keepReading(found);
    EXPECT_TRUE(d->readingKnown());
    EXPECT_EQ(d->interpretation().candidates.size(), found.candidates.size());
    draw(*d, 5);
    EXPECT_FALSE(d->readingKnown());
}

TEST(Document, RefusesBadSettings) {
    const auto d = fakeDocument();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Thresholds t : {Thresholds{0.5, 12}, Thresholds{101, 12}, Thresholds{14, 0.4},
                               Thresholds{14, 46}, Thresholds{nan, 12}, Thresholds{14, nan}}) {
        EXPECT_EQ(d->setThresholds(t).error().code, Errc::BadValue);
    }
    const auto refuses = [&](auto change) {
        OrthographicCamera c;
        change(c);
        return !d->setCamera(c);
    };
    EXPECT_TRUE(refuses([](auto& c) { c.direction = Vec3(0, 0, 2); }));
    EXPECT_TRUE(refuses([](auto& c) { c.up = c.direction; }));
    EXPECT_TRUE(refuses([](auto& c) { c.worldPerPixel = -1; }));
    EXPECT_TRUE(refuses([&](auto& c) { c.center.x() = nan; }));
    EXPECT_TRUE(refuses([](auto& c) { c.center.x() = 1e200; }));
    EXPECT_TRUE(refuses([](auto& c) { c.width = 3; }));
    EXPECT_EQ(d->camera(), OrthographicCamera{});
    d->setObliqueFactor(nan);
    EXPECT_EQ(d->obliqueFactor(), 0.5);
    d->setObliqueFactor(9);
    EXPECT_EQ(d->obliqueFactor(), 2.0);
}

TEST(Document, DefinesTemplatesFromAFileAndFromTheSolid) {
    const auto d = fakeDocument();
    EXPECT_EQ(d->defineTemplateFromSolid("mine", "Mine").error().code, Errc::NoSolid);
    ASSERT_TRUE(d->defineTemplate(test::boxTemplate("slab", "Slab")));
    EXPECT_EQ(d->defineTemplate(test::boxTemplate("slab", "Slab")).error().code, Errc::DuplicateId);
    EXPECT_EQ(d->defineTemplate(test::boxTemplate("box", "Box")).error().code, Errc::DuplicateId);
    EXPECT_EQ(d->undoStack().text(0), QString::fromUtf8("Define template \u201cSlab\u201d"));
    draw(*d, 5);
    ASSERT_TRUE(d->apply());
    const auto defined = d->defineTemplateFromSolid("mine", "Mine");
    ASSERT_TRUE(defined) << defined.error().message;
    const DocumentState& state = d->state();
    EXPECT_EQ(state.addedTemplates, (std::vector<std::string>{"slab", "mine"}));
    const int found = state.library.find("mine");
    ASSERT_GE(found, 0);
    const Template& mine = state.library.at(static_cast<std::size_t>(found));
    EXPECT_EQ(mine.shape.vertices.size(), 8U);
    EXPECT_EQ(mine.shape.faces.size(), 6U);
    EXPECT_EQ(mine.relations.parallel.size(), 3U);
    EXPECT_EQ(mine.relations.perpendicular.size(), 3U);
    EXPECT_TRUE(mine.relations.equalLength.empty());
    ASSERT_TRUE(d->undo());
    EXPECT_EQ(d->state().library.find("mine"), -1);
    draw(*d, 5);
    ASSERT_TRUE(d->apply());
    EXPECT_EQ(d->defineTemplateFromSolid("two", "Two").error().code, Errc::BadTemplate);
}

TEST(Document, ReplacesATemplateOfItsOwn) {
    const auto d = fakeDocument();
    ASSERT_TRUE(d->defineTemplate(test::boxTemplate("slab", "Slab")));
    Template changed = test::boxTemplate("slab", "Plank");
    changed.about.author = "A. Person";
    Listener listener(*d);
    ASSERT_TRUE(d->defineTemplate(changed, true));
    EXPECT_TRUE(listener.take(DocumentChange::Library));
    const auto name = [&] {
        const TemplateLibrary& library = d->state().library;
        return library.at(static_cast<std::size_t>(library.find("slab"))).name;
    };
    EXPECT_EQ(name(), "Plank");
    EXPECT_EQ(d->undoStack().text(1), QString::fromUtf8("Change template \u201cPlank\u201d"));
    EXPECT_EQ(d->state().addedTemplates, (std::vector<std::string>{"slab"}));
    ASSERT_TRUE(d->undo());
    EXPECT_EQ(name(), "Slab");
    ASSERT_TRUE(d->redo());
    // Neither what is not there nor what belongs to all documents.
    EXPECT_EQ(d->defineTemplate(test::boxTemplate("new", "New"), true).error().code,
              Errc::UnknownTemplate);
    EXPECT_EQ(d->defineTemplate(test::boxTemplate("box", "Box"), true).error().code,
              Errc::UnknownTemplate);
    // A file keeps both versions, one for each state.
    QTemporaryDir folder;
    const QString path = folder.filePath("t.edgewright");
    ASSERT_TRUE(d->save(path));
    const auto again = fakeDocument();
    ASSERT_TRUE(again->open(path));
    EXPECT_TRUE(identicalDocuments(*d, *again));
    ASSERT_TRUE(again->undo());
    EXPECT_EQ(again->state()
                  .library.at(static_cast<std::size_t>(again->state().library.find("slab")))
                  .name,
              "Slab");
}

TEST(Document, DeletesTheSolidAsOneStep) {
    const auto d = fakeDocument();
    EXPECT_EQ(d->deleteBodies().error().code, Errc::NoSolid);
    draw(*d, 5);
    ASSERT_TRUE(d->apply());
    ASSERT_TRUE(d->deleteBodies());
    EXPECT_TRUE(d->state().bodies.empty());
    ASSERT_TRUE(d->undo());
    EXPECT_EQ(d->state().bodies.size(), 1U);
}

TEST(Document, RepairsInkAndThresholds) {
    const auto d = fakeDocument();
    draw(*d, 5);
    draw(*d, 6);
    Repair repair;
    repair.kind = Repair::Kind::JoinEnds;
    repair.strokes = {0};
    repair.from = Vec2(104, 103);
    repair.to = Vec2(120, 110);
    ASSERT_TRUE(d->repair(repair));
    ASSERT_EQ(d->pendingStrokes().size(), 2U);
    EXPECT_EQ(d->pendingStrokes()[1].stroke.samples.back().position, Vec2(120, 110));
    EXPECT_TRUE(d->undoInk());
    EXPECT_EQ(d->pendingStrokes()[0].stroke.samples.size(), 2U);
    repair.strokes = {7};
    EXPECT_FALSE(d->repair(repair));
    repair.strokes = {0};
    repair.to = Vec2(1e300, 0);
    EXPECT_FALSE(d->repair(repair));
    repair.kind = Repair::Kind::RaiseDistance;
    repair.strokes = {};
    repair.value = 19;
    ASSERT_TRUE(d->repair(repair));
    EXPECT_EQ(d->thresholds().distancePx, 19);
    repair.value = 1000;
    EXPECT_FALSE(d->repair(repair));
    repair.kind = Repair::Kind::RaiseAngle;
    repair.value = 15;
    ASSERT_TRUE(d->repair(repair));
    EXPECT_EQ(d->thresholds().angleDeg, 15);
    repair.kind = Repair::Kind::UseCandidate;
    repair.candidate = 1;
    EXPECT_EQ(d->pendingStrokes().size(), 2U);
    ASSERT_TRUE(d->repair(repair));
    EXPECT_EQ(d->state().bodies.size(), 1U);
    ASSERT_TRUE(d->undo());
    repair.kind = Repair::Kind::DropStrokes;
    repair.strokes = {1};
    ASSERT_TRUE(d->repair(repair));
    EXPECT_EQ(d->pendingStrokes().size(), 1U);
}

}  // namespace
}  // namespace ew
