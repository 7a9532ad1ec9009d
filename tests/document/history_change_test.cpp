// SPDX-License-Identifier: GPL-3.0-or-later
// The history as something to work with: names of states, steps that are changed in the middle,
// steps that are merged.
#include "core/document/history_change.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QUndoStack>

#include "core/document/document_compare.h"
#include "core/document/replay.h"
#include "tests/document/fixtures.h"

namespace ew {
namespace {

using test::line;

/// What resources/examples has, replayed.
std::unique_ptr<Document> example(const char* name) {
    const auto text =
        readFileBytes(QStringLiteral(EDGEWRIGHT_SOURCE_DIR "/resources/examples/%1.json").arg(name),
                      kMaxScriptBytes);
    auto d = std::make_unique<Document>(test::shippedLibrary());
    ReplayOptions options;
    options.leaveOutFiles = true;
    const auto report = replay(*d, *readSketchScript(*text), options);
    EXPECT_EQ(report.firstFailure(), nullptr);
    return d;
}

/// The first step of a kind, by its place in the history.
template <class Step>
int placeOf(const DocumentFile& file, int which = 0) {
    const auto steps = recordedSteps(file);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const bool fits = steps[i] && std::holds_alternative<Step>(steps[i]->step);
        if (fits && which-- == 0) return static_cast<int>(i);
    }
    ADD_FAILURE() << "no such step";
    return -1;
}

HistoryChange changed(const Document& d, const StepChange& change) {
    auto out = changeStep(d.contents(), test::shippedLibrary(), change);
    EXPECT_TRUE(out) << out.error().message;
    return out ? *std::move(out) : HistoryChange{};
}

TEST(HistoryChange, AStepThatStaysAsItIsChangesNothing) {
    const auto d = example("printer");
    const DocumentFile before = d->contents();
    const auto steps = recordedSteps(before);
    ASSERT_EQ(steps.size(), before.commands.size());
    for (const int place : {0, 2, static_cast<int>(steps.size()) - 1}) {
        const auto& step = steps[static_cast<std::size_t>(place)];
        ASSERT_TRUE(step) << place;
        const HistoryChange change = changed(*d, {place, step->step, std::nullopt});
        EXPECT_TRUE(change.misfits.empty());
        EXPECT_EQ(change.redone, static_cast<int>(steps.size()) - place - 1);
        Document after(test::shippedLibrary());
        after.restore(change.file, {});
        EXPECT_TRUE(identicalDocuments(*d, after)) << place;
    }
    EXPECT_TRUE(before.commands.back().after == d->contents().commands.back().after);
}

TEST(HistoryChange, AnotherRadiusIsTheOneThatIsThereInTheEnd) {
    const auto d = example("printer");
    const int place = placeOf<FilletStep>(d->contents());
    const auto steps = recordedSteps(d->contents());
    auto fillet = std::get<FilletStep>(steps[static_cast<std::size_t>(place)]->step);
    fillet.radius *= 0.5;
    HistoryChange change = changed(*d, {place, fillet, std::nullopt});
    EXPECT_TRUE(change.misfits.empty());
    const int count = d->undoStack().count();
    const auto before = d->state().surface;
    d->replaceHistory(std::move(change));
    EXPECT_EQ(d->undoStack().count(), count);
    EXPECT_NE(d->state().surface, before);
    EXPECT_TRUE(d->isModified());
    // And it can be taken back as long as nothing else is done.
    ASSERT_TRUE(d->canTakeBackHistory());
    d->takeBackHistory();
    EXPECT_EQ(d->state().surface, before);
    EXPECT_FALSE(d->canTakeBackHistory());
}

TEST(HistoryChange, WhatNoLongerFitsIsNamedAndItsStrokesAreKept) {
    const auto d = example("printer");
    // Without the first solid nothing that was drawn on it has anything to be on.
    const int first = placeOf<ApplyStep>(d->contents());
    const auto steps = recordedSteps(d->contents());
    const auto step = *steps[static_cast<std::size_t>(first)];
    const auto readings =
        readingsOfStep(d->contents(), test::shippedLibrary(), first, step.view.thresholds, 0.5);
    ASSERT_TRUE(readings);
    ASSERT_GT(readings->candidates.size(), 1U);
    auto apply = std::get<ApplyStep>(step.step);
    std::size_t drawn = 0;
    for (const StoredCommand& c : d->contents().commands) drawn += c.consumed.size();
    for (std::size_t i = 0; i < readings->candidates.size(); ++i) {
        apply.candidate = static_cast<int>(i);
        const HistoryChange change = changed(*d, {first, apply, std::nullopt});
        std::size_t used = 0;
        for (const StoredCommand& c : change.file.commands) used += c.consumed.size();
        EXPECT_EQ(change.redone + static_cast<int>(change.misfits.size()) + 1,
                  static_cast<int>(steps.size()) - first);
        EXPECT_EQ(used + change.file.pending.size(), drawn + d->pendingStrokes().size())
            << "no stroke is lost";
        for (const MisfitStep& misfit : change.misfits) {
            EXPECT_FALSE(misfit.name.empty());
            EXPECT_FALSE(misfit.error.message.empty());
        }
        // What came of it is a document like any other.
        const auto bytes = writeDocument(change.file);
        ASSERT_TRUE(bytes);
        EXPECT_TRUE(readDocument(*bytes, test::shippedLibrary()));
    }
}

TEST(HistoryChange, RefusesWhatIsNoChange) {
    const auto d = example("cube");
    const DocumentFile file = d->contents();
    const auto refused = [&](const StepChange& change) {
        const auto out = changeStep(file, test::shippedLibrary(), change);
        return out ? Errc::Internal : out.error().code;
    };
    EXPECT_EQ(refused({-1, ApplyStep{}, std::nullopt}), Errc::BadValue);
    EXPECT_EQ(refused({99, ApplyStep{}, std::nullopt}), Errc::BadValue);
    EXPECT_EQ(refused({0, DeleteSolidStep{}, std::nullopt}), Errc::BadValue);
    ApplyStep none;
    none.candidate = 99;
    EXPECT_EQ(refused({0, none, std::nullopt}), Errc::UnknownCandidate);
    const auto givenUp = changeStep(file, test::shippedLibrary(), {0, ApplyStep{}, std::nullopt},
                                    [](int, int) { return false; });
    EXPECT_EQ(givenUp.error().code, Errc::Cancelled);
}

TEST(StateNames, StayWithTheirStatesInFilesAndScripts) {
    const auto d = example("printer");
    ASSERT_TRUE(d->nameState(2, "before the tray"));
    ASSERT_TRUE(d->nameState(0, "nothing yet"));
    EXPECT_EQ(d->nameState(-1, "x").error().code, Errc::BadValue);
    EXPECT_EQ(d->nameState(1'000, "x").error().code, Errc::BadValue);
    EXPECT_EQ(d->nameState(1, std::string(kMaxStateName + 1, 'x')).error().code, Errc::BadValue);
    const QTemporaryDir folder;
    ASSERT_TRUE(d->save(folder.filePath("d.edgewright")));
    Document opened(test::shippedLibrary());
    ASSERT_TRUE(opened.open(folder.filePath("d.edgewright")));
    EXPECT_EQ(opened.stateName(2), "before the tray");
    EXPECT_EQ(opened.stateName(0), "nothing yet");
    EXPECT_EQ(opened.stateName(1), "");
    Document replayed(test::shippedLibrary());
    replay(replayed, d->recordedScript(), {});
    EXPECT_TRUE(identicalDocuments(*d, replayed));
    // A state that is gone takes its name along.
    ASSERT_TRUE(d->goToStep(1));
    ASSERT_TRUE(d->defineTemplate(test::boxTemplate("t", "T")));
    EXPECT_EQ(d->stateName(2), "");
    EXPECT_EQ(d->stateName(0), "nothing yet");
}

TEST(CompactHistory, OnlyNamedStatesAndTheNewestStay) {
    const auto d = example("printer");
    const int count = d->undoStack().count();
    ASSERT_GT(count, 4);
    ASSERT_TRUE(d->nameState(3, "before the tray"));
    const auto named = d->stateAt(3);
    const auto now = d->stateAt(count);
    const auto first = d->stateAt(0);
    const auto large = writeDocument(d->contents());
    ASSERT_TRUE(d->compactHistory());
    ASSERT_EQ(d->undoStack().count(), 2);
    EXPECT_EQ(d->stateName(1), "before the tray");
    EXPECT_TRUE(identicalStates(*d->stateAt(1), *named));
    EXPECT_TRUE(identicalStates(*d->stateAt(2), *now));
    EXPECT_TRUE(identicalStates(*d->stateAt(0), *first));
    EXPECT_TRUE(identicalStates(d->state(), *now));
    EXPECT_LT(writeDocument(d->contents())->size(), large->size());
    // The script is whole, and leads to the same, compacted.
    Document replayed(test::shippedLibrary());
    const auto report = replay(replayed, d->recordedScript(), {});
    EXPECT_EQ(report.firstFailure(), nullptr);
    EXPECT_TRUE(identicalDocuments(*d, replayed));
    EXPECT_FALSE(recordedSteps(d->contents())[0]) << "it was merged";
    ASSERT_TRUE(d->undo(2));
    EXPECT_TRUE(identicalStates(d->state(), *first));
}

}  // namespace
}  // namespace ew
