// SPDX-License-Identifier: GPL-3.0-or-later
// What the window makes of a reading: panels, choosing, applying by itself, repairs.
#include <QAbstractButton>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListView>
#include <QListWidget>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QThread>
#include <QUndoStack>
#include <atomic>
#include <set>

#include "core/reading/interpret.h"
#include "tests/ui/window_fixture.h"
#include "ui/apply_controller.h"
#include "ui/live_reading.h"
#include "ui/panels/message_bar.h"
#include "ui/theme/appearance.h"
#include "ui/tools/tool_box.h"

namespace ew::test {

class Reading : public WindowTest {
  protected:
    template <class T>
    T& child(const char* name) {
        T* found = window_->findChild<T*>(QLatin1String(name));
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }
    const Interpretation& reading() { return window_->reading().reading(); }

    /// The box, with the end of its first line short of the corner by some px.
    std::vector<std::array<Vec2, 2>> boxWithGap(double gapPx) {
        auto lines = boxLines();
        // A line of the outline, pulled back from its end.
        auto& line = lines[4];
        line[1] -= gapPx * (line[1] - line[0]).normalized();
        return lines;
    }
};

TEST_F(Reading, ClearDrawingIsAcceptedAndShownInThePanels) {
    drawLines(Hand::Mouse, boxLines());
    ASSERT_TRUE(reading().accepted) << (reading().problem ? reading().problem->message : "");
    EXPECT_EQ(reading().candidates[static_cast<std::size_t>(*reading().accepted)].templateId,
              "cube");
    EXPECT_EQ(reading().graph.edges.size(), 9U);
    EXPECT_EQ(child<QLabel>("graphHeading").text().toStdString(), "Cube");
    EXPECT_TRUE(child<QPushButton>("applyButton").isEnabled());
    EXPECT_TRUE(child<QAbstractButton>("candidate1").isVisible());
}

TEST_F(Reading, TheDistanceFollowsTheDrawingUntilItIsSetAndAgainWhenAsked) {
    auto& automatic = child<QCheckBox>("automaticDistance");
    auto& number = child<QDoubleSpinBox>("distanceNumber");
    EXPECT_TRUE(automatic.isChecked());
    number.setValue(22.5);
    EXPECT_FALSE(automatic.isChecked());
    EXPECT_FALSE(document().automaticDistance());
    automatic.click();
    EXPECT_TRUE(automatic.isChecked());
    EXPECT_TRUE(document().automaticDistance());
    EXPECT_EQ(number.value(), Thresholds{}.distancePx);

    auto& reset = child<QPushButton>("resetThresholds");
    EXPECT_FALSE(reset.isEnabled());
    child<QSlider>("distanceSlider").setValue(50);
    child<QDoubleSpinBox>("angleNumber").setValue(20.0);
    EXPECT_FALSE(automatic.isChecked());
    reset.click();
    EXPECT_TRUE(automatic.isChecked());
    EXPECT_EQ(document().thresholds(), Thresholds{});
    EXPECT_FALSE(reset.isEnabled());
}

TEST_F(Reading, TheStrokeUnderWayIsReadBeforeThePenIsUp) {
    auto lines = boxLines();
    const auto last = lines.back();
    lines.pop_back();
    drawLines(Hand::Pen, lines);
    EXPECT_FALSE(reading().accepted && reading().graph.edges.size() == 9U);
    press(Hand::Pen, last[0]);
    for (int i = 1; i <= 20; ++i) move(Hand::Pen, last[0] + (last[1] - last[0]) * (i / 20.0));
    settle();
    EXPECT_TRUE(window_->tools().gestureUnderWay());
    EXPECT_EQ(document().pendingStrokes().size(), 8U);
    EXPECT_EQ(reading().graph.edges.size(), 9U);
    EXPECT_TRUE(reading().accepted.has_value());
    release(Hand::Pen, last[1]);
}

TEST_F(Reading, WhatMayTakeLongIsReadOnAnotherThreadAndDroppedWhenStale) {
    std::atomic<int> elsewhere{0};
    std::atomic<bool> wait{false};
    const QThread* const here = QThread::currentThread();
    const auto slow = [&](const std::vector<Stroke>& strokes, const TemplateLibrary& library,
                          const InterpretOptions& options) {
        if (QThread::currentThread() != here) ++elsewhere;
        while (wait) QThread::msleep(1);
        return interpret(strokes, library, options);
    };
    Document sheet(document().state().library, slow);
    ASSERT_TRUE(sheet.setCamera(document().camera()));
    LiveReading live(sheet);
    const auto draw = [&](const std::vector<std::array<Vec2, 2>>& lines) {
        for (const auto& l : lines) {
            Stroke stroke;
            for (int i = 0; i <= 20; ++i) {
                stroke.samples.push_back({l[0] + (l[1] - l[0]) * (i / 20.0), 0.5, 8.0 * i});
            }
            ASSERT_TRUE(sheet.addStroke(stroke));
        }
    };
    draw(boxLines());
    ASSERT_TRUE(sheet.apply());
    elsewhere = 0;
    // With a solid there, reading may take long: nothing waits for it.
    wait = true;
    draw(boxLines());
    QTest::qWait(60);
    EXPECT_FALSE(live.upToDate());
    EXPECT_GT(elsewhere, 0);
    sheet.clearStrokes();
    wait = false;
    EXPECT_TRUE(QTest::qWaitFor([&] { return live.upToDate(); }, 10000));
    // What was found for strokes that are gone is not shown.
    EXPECT_TRUE(live.reading().candidates.empty());
}

TEST_F(Reading, ThresholdSliderReadsAnewAtOnce) {
    drawLines(Hand::Mouse, boxWithGap(24.0));
    window_->reading().settleNow();
    ASSERT_FALSE(reading().accepted);
    ASSERT_TRUE(reading().problem);
    EXPECT_FALSE(reading().problem->message.empty());
    QSlider& slider = child<QSlider>("distanceSlider");
    slider.setFocus();
    slider.setValue(2 * 32);  // steps of half a pixel
    EXPECT_EQ(document().thresholds().distancePx, 32.0);
    EXPECT_EQ(child<QDoubleSpinBox>("distanceNumber").value(), 32.0);
    settle();
    EXPECT_TRUE(reading().accepted.has_value());
    EXPECT_EQ(document().pendingStrokes().size(), 9U);
}

TEST_F(Reading, NumbersGoToTheDocumentAndComeBack) {
    child<QDoubleSpinBox>("angleNumber").setValue(20.0);
    EXPECT_EQ(document().thresholds().angleDeg, 20.0);
    EXPECT_EQ(child<QSlider>("angleSlider").value(), 40);
    ASSERT_TRUE(document().setThresholds({21.5, 7.0}));
    EXPECT_EQ(child<QDoubleSpinBox>("distanceNumber").value(), 21.5);
    EXPECT_EQ(child<QSlider>("angleSlider").value(), 14);
}

TEST_F(Reading, AnOpenEndIsSaidAndOneClickRepairsIt) {
    drawLines(Hand::Mouse, boxWithGap(24.0));
    window_->reading().settleNow();
    ASSERT_TRUE(reading().problem);
    EXPECT_EQ(window_->messages().text().toStdString(), reading().problem->message);
    EXPECT_FALSE(reading().culprits.empty());
    ASSERT_FALSE(reading().repairs.empty());
    QPushButton& button = child<QPushButton>("repair1");
    EXPECT_EQ(button.text().toStdString(), reading().repairs.front().label);
    button.click();
    settle();
    EXPECT_TRUE(reading().accepted.has_value());
}

TEST_F(Reading, TwoLinesAreNoFault) {
    drawLine(Hand::Mouse, {300, 300}, {300, 450});
    drawLine(Hand::Mouse, {340, 300}, {460, 260});
    window_->reading().settleNow();
    settle();
    EXPECT_EQ(window_->findChild<QPushButton*>("repair1"), nullptr);
    EXPECT_TRUE(reading().culprits.empty());
    const auto* text = window_->messages().findChild<QLabel*>("message");
    ASSERT_NE(text, nullptr);
    EXPECT_EQ(text->palette().color(QPalette::WindowText), appearance_->colours().text)
        << text->text().toStdString();
}

TEST_F(Reading, EachRepairHasAButtonOfItsOwnName) {
    // Three gaps of a triangle.
    drawLine(Hand::Mouse, {300, 300}, {560, 300});
    drawLine(Hand::Mouse, {580, 320}, {440, 560});
    drawLine(Hand::Mouse, {420, 560}, {280, 322});
    window_->reading().settleNow();
    settle();
    ASSERT_TRUE(reading().problem);
    EXPECT_EQ(reading().problem->code, Errc::OpenEnd);
    EXPECT_GE(reading().repairs.size(), 3U);
    std::set<QString> names;
    int count = 0;
    for (const auto* button : window_->messages().findChildren<QPushButton*>()) {
        if (button->isHidden()) continue;
        ++count;
        names.insert(button->text());
    }
    EXPECT_GE(count, 1);
    EXPECT_EQ(static_cast<int>(names.size()), count);
}

TEST_F(Reading, ThePanelAndTheMessageTellTheSameNumbers) {
    drawLines(Hand::Mouse, boxLines());
    ASSERT_TRUE(document().apply());
    // A triangle beside the box, and two lines that belong to nothing.
    const double w = surface().width();
    const double h = surface().height();
    const Vec2 a(0.70 * w, 0.80 * h);
    const Vec2 b(0.95 * w, 0.80 * h);
    const Vec2 c(0.82 * w, 0.95 * h);
    drawLines(Hand::Mouse, {{a, b},
                            {b, c},
                            {c, a},
                            {Vec2(0.45 * w, 0.42 * h), Vec2(0.55 * w, 0.60 * h)},
                            {Vec2(0.10 * w, 0.20 * h), Vec2(0.22 * w, 0.30 * h)}});
    window_->reading().settleNow();
    settle();
    const auto& r = reading();
    ASSERT_TRUE(r.problem && r.nearest) << (r.problem ? r.problem->message : "read");
    ASSERT_EQ(r.problem->code, Errc::NoMatch);
    const auto missing = r.nearest->missing.size();
    const auto extra = r.nearest->extra.size();
    const auto words = [](std::size_t n) {
        return n == 1 ? std::string("one line") : std::to_string(n) + " lines";
    };
    const std::string& said = r.problem->message;
    const std::string shown = child<QLabel>("graphDetail").text().toStdString();
    EXPECT_EQ(said.find(words(missing) + " missing") != std::string::npos, missing > 0) << said;
    EXPECT_EQ(said.find(words(extra) + " too many") != std::string::npos, extra > 0) << said;
    EXPECT_EQ(shown, std::to_string(missing) + " missing, " + std::to_string(extra) + " too many");
    EXPECT_GT(missing + extra, 0U) << said << " / " << shown;
}

TEST_F(Reading, EnterWithNothingDrawnSaysSoAndChangesNothing) {
    key(Qt::Key_Return);
    EXPECT_TRUE(document().state().bodies.empty());
    EXPECT_EQ(document().undoStack().count(), 0);
    EXPECT_FALSE(window_->messages().text().isEmpty());
}

TEST_F(Reading, EnterOnAnUnreadableDrawingKeepsTheInk) {
    drawLine(Hand::Mouse, {100, 100}, {300, 130});
    key(Qt::Key_Return);
    EXPECT_TRUE(document().state().bodies.empty());
    EXPECT_EQ(document().pendingStrokes().size(), 1U);
    EXPECT_FALSE(window_->messages().text().isEmpty());
}

TEST_F(Reading, KeysChooseAReadingAndEnterTakesIt) {
    drawLines(Hand::Mouse, prismLines());
    const auto count = reading().candidates.size();
    ASSERT_GE(count, 2U) << "a prism leaves a freedom open";
    key(Qt::Key_2);
    EXPECT_EQ(window_->reading().current(), 1);
    EXPECT_TRUE(child<QAbstractButton>("candidate2").isChecked());
    EXPECT_TRUE(document().state().bodies.empty()) << "choosing is not applying";
    key(Qt::Key_9);
    EXPECT_EQ(window_->reading().current(), count >= 9 ? 8 : 1);
    key(Qt::Key_2);
    key(Qt::Key_Return);
    ASSERT_EQ(document().state().bodies.size(), 1U);
    ASSERT_NE(document().lastApply(), nullptr);
    EXPECT_EQ(document().lastApply()->chosen, 1);
}

TEST_F(Reading, AfterApplyingTheOtherReadingsAreOneKeyAway) {
    drawLines(Hand::Mouse, prismLines());
    key(Qt::Key_Return);
    ASSERT_NE(document().lastApply(), nullptr);
    const int first = document().lastApply()->chosen;
    ASSERT_GE(document().lastApply()->interpretation.candidates.size(), 2U);
    const double before = document().state().bodies[0].solid.volume();
    key(first == 0 ? Qt::Key_2 : Qt::Key_1);
    ASSERT_EQ(document().state().bodies.size(), 1U);
    EXPECT_NE(document().lastApply()->chosen, first);
    EXPECT_NE(document().state().bodies[0].solid.volume(), before);
    EXPECT_EQ(document().undoStack().count(), 1) << "the reading is replaced, not added";
    drawLine(Hand::Mouse, {60, 60}, {120, 60});
    EXPECT_FALSE(window_->applyController().showsApplied());
}

TEST_F(Reading, AppliesByItselfOnlyWhenOnAndClear) {
    ApplyController& apply = window_->applyController();
    QCheckBox& box = child<QCheckBox>("automatic");
    drawLines(Hand::Mouse, boxLines());
    EXPECT_FALSE(apply.waiting()) << "it is off";
    document().clearStrokes();
    box.click();
    EXPECT_TRUE(apply.automatic());
    apply.setBusyTest([] { return false; });
    auto lines = boxLines();
    lines.erase(lines.begin() + 7);
    lines.erase(lines.begin() + 5);
    drawLines(Hand::Mouse, lines);
    EXPECT_FALSE(apply.waiting()) << "two faces are open";
    document().clearStrokes();
    drawLines(Hand::Mouse, boxLines());
    EXPECT_TRUE(QTest::qWaitFor([&] { return !document().state().bodies.empty(); }, 20000));
    EXPECT_FALSE(apply.waiting());
    // Taken back is not taken again.
    key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(document().pendingStrokes().size(), 9U);
    EXPECT_FALSE(apply.waiting());
}

TEST_F(Reading, ApplyingByItselfWaitsForEscapePenAndPanels) {
    ApplyController& apply = window_->applyController();
    apply.setAutomatic(true);
    bool inUse = true;
    apply.setBusyTest([&] { return inUse; });
    drawLines(Hand::Mouse, boxLines());
    ASSERT_TRUE(apply.waiting());
    key(Qt::Key_Escape);
    EXPECT_FALSE(apply.waiting());
    document().clearStrokes();
    drawLines(Hand::Mouse, boxLines());
    ASSERT_TRUE(apply.waiting());
    press(Hand::Mouse, {60, 60});
    move(Hand::Mouse, {70, 60});
    settle();
    EXPECT_FALSE(apply.waiting()) << "someone draws";
    key(Qt::Key_Escape);
    release(Hand::Mouse, {70, 60});
    document().clearStrokes();
    drawLines(Hand::Mouse, boxLines());
    ASSERT_TRUE(apply.waiting());
    bool asked = false;
    apply.setBusyTest([&] { return std::exchange(asked, true), inUse; });
    EXPECT_TRUE(QTest::qWaitFor([&] { return asked; }, 20000));
    EXPECT_TRUE(document().state().bodies.empty()) << "a panel is in use";
    inUse = false;
    EXPECT_TRUE(QTest::qWaitFor([&] { return !document().state().bodies.empty(); }, 20000));
}

TEST_F(Reading, HistoryGoesToTheStepThatIsClicked) {
    drawLines(Hand::Mouse, boxLines());
    key(Qt::Key_Return);
    QListView& list = child<QListView>("historyList");
    const auto state = [&](int row) { return list.model()->index(row, 0); };
    ASSERT_EQ(list.model()->rowCount(), 2);
    EXPECT_EQ(list.currentIndex().row(), 1);
    EXPECT_EQ(state(1).data().toString().toStdString(), "Create cube");
    list.setCurrentIndex(state(0));
    EXPECT_TRUE(document().state().bodies.empty());
    list.setCurrentIndex(state(1));
    EXPECT_EQ(document().state().bodies.size(), 1U);
}

TEST_F(Reading, TemplateListShowsWhatIsInUse) {
    const QListWidget& list = child<QListWidget>("templateList");
    EXPECT_EQ(static_cast<std::size_t>(list.count()), document().state().library.size());
    drawLines(Hand::Mouse, boxLines());
    key(Qt::Key_Return);
    ASSERT_TRUE(document().defineTemplateFromSolid("my-box", "My box"));
    ASSERT_GT(list.count(), 0);
    EXPECT_EQ(list.item(list.count() - 1)->text().toStdString(), "My box");
}

}  // namespace ew::test
