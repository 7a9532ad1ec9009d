// SPDX-License-Identifier: GPL-3.0-or-later
// What the window says while someone draws and when something was done.
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QWindow>

#include "tests/ui/window_fixture.h"
#include "ui/apply_controller.h"
#include "ui/live_reading.h"
#include "ui/panels/message_bar.h"

namespace ew::test {
namespace {

class Talk : public WindowTest {
  protected:
    std::string said() { return window_->messages().text().toStdString(); }
    QPoint over(const QWidget& w) { return w.mapTo(window_.get(), w.rect().center()); }
    void pointAt(const QWidget& w) {
        QTest::mouseMove(window_->windowHandle(), over(w));
        QApplication::processEvents();
    }
    const QWidget& panel(const char* name) {
        const auto* found = window_->findChild<QDockWidget*>(name);
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }
};

TEST_F(Talk, APenThatJumpsFromAPanelToTheDrawingIsNotInThePanel) {
    window_->applyController().setAutomatic(true);
    // The mouse is left over a panel; no event says that it is not used any more.
    pointAt(panel("candidatePanel"));
    drawLines(Hand::Pen, boxLines());
    EXPECT_TRUE(window_->applyController().countingDown()) << said();
    EXPECT_TRUE(QTest::qWaitFor([&] { return !document().state().bodies.empty(); }, 20000));
}

TEST_F(Talk, NothingIsAppliedAndNothingSaysSoWhileAPanelIsUsed) {
    ApplyController& apply = window_->applyController();
    apply.setAutomatic(true);
    bool liedWhileHeld = false;
    bool held = false;
    QObject::connect(&apply, &ApplyController::changed, window_.get(), [&] {
        if (held && said().find("Applying") != std::string::npos) liedWhileHeld = true;
    });
    drawLines(Hand::Mouse, boxLines());
    ASSERT_TRUE(apply.countingDown());
    EXPECT_NE(said().find("Applying"), std::string::npos);
    pointAt(panel("thresholdPanel"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return !apply.countingDown(); }, 20000));
    held = true;
    EXPECT_TRUE(apply.waiting());
    EXPECT_TRUE(document().state().bodies.empty());
    EXPECT_EQ(said().find("Applying"), std::string::npos) << said();
    EXPECT_FALSE(liedWhileHeld);
    held = false;
    pointAt(surface());
    EXPECT_TRUE(QTest::qWaitFor([&] { return !document().state().bodies.empty(); }, 20000));
}

TEST_F(Talk, AFirstStrokeIsNotCriticised) {
    drawLine(Hand::Pen, {100, 100}, {300, 130});
    window_->reading().settleNow();
    EXPECT_FALSE(window_->reading().settled());
    EXPECT_EQ(said(), "Keep drawing.");
    EXPECT_EQ(window_->findChild<QPushButton*>("repair1"), nullptr);
    // Whoever asks is told.
    key(Qt::Key_Return);
    EXPECT_NE(said(), "Keep drawing.");
}

TEST_F(Talk, IsQuietUntilThePenRests) {
    LiveReading& reading = window_->reading();
    drawLine(Hand::Pen, {100, 100}, {300, 130});
    drawLine(Hand::Pen, {300, 130}, {310, 300});
    EXPECT_FALSE(reading.settled());
    EXPECT_TRUE(QTest::qWaitFor([&] { return reading.settled(); }, 20000));
    EXPECT_NE(said(), "Keep drawing.");
    // Taking strokes back is drawing too.
    drawLine(Hand::Pen, {310, 300}, {400, 310});
    reading.settleNow();
    ASSERT_TRUE(reading.settled());
    key(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_FALSE(reading.settled());
}

TEST_F(Talk, TheGraphPanelTellsWhatIsMissing) {
    const auto* detail = window_->findChild<QLabel*>("graphDetail");
    ASSERT_NE(detail, nullptr);
    auto lines = boxLines();
    lines.erase(lines.begin() + 6);
    lines.erase(lines.begin() + 0);
    drawLines(Hand::Mouse, lines);
    window_->reading().settleNow();
    const auto& nearest = window_->reading().reading().nearest;
    ASSERT_TRUE(nearest);
    EXPECT_GT(nearest->missing.size() + nearest->extra.size(), 0U);
    EXPECT_EQ(detail->text(), QStringLiteral("%1 missing, %2 too many")
                                  .arg(nearest->missing.size())
                                  .arg(nearest->extra.size()));
}

/// Reads any ink as one change, and leaves all strokes but the first.
struct OneChange {
    Operation operation;
    std::string name;
    Interpretation operator()(const std::vector<Stroke>& strokes, const TemplateLibrary&,
                              const InterpretOptions& options) const {
        Interpretation r;
        if (strokes.empty()) return r;
        Candidate c;
        c.templateId = "cube";
        c.templateName = name;
        c.spec.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                           {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
        c.spec.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                        {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
        if (!options.bodies.empty()) {
            c.operation = operation;
            c.body = 0;
            c.result = options.bodies.front().solid;
        }
        for (int i = 1; i < static_cast<int>(strokes.size()); ++i) c.unusedStrokes.push_back(i);
        r.candidates.push_back(c);
        r.accepted = 0;
        return r;
    }
};

std::vector<QString> saidOf(Operation operation, const std::string& name, int strokes) {
    Document sheet(TemplateLibrary(), OneChange{operation, name});
    LiveReading live(sheet);
    ApplyController apply(sheet, live);
    Appearance look;
    MessageBar bar(sheet, live, apply, look);
    std::vector<QString> said;
    for (int step = 0; step < 2; ++step) {
        for (int i = 0; i < strokes; ++i) {
            EXPECT_TRUE(sheet.addStroke(Stroke{{{{0, 1.0 * i}, 1, 0}, {{9, 9}, 1, 0}}}));
        }
        apply.apply();
        said.push_back(bar.text());
        if (strokes > 1) break;
    }
    return said;
}

TEST(TalkOfSteps, SaysWhatWasDone) {
    EXPECT_EQ(saidOf(Operation::Cut, "Cube", 1),
              (std::vector<QString>{"Made a box.", "Cut a box."}));
    EXPECT_EQ(saidOf(Operation::Add, "Triangular prism", 1),
              (std::vector<QString>{"Made a prism.", "Added a prism."}));
    EXPECT_EQ(saidOf(Operation::Add, "L-prism", 1),
              (std::vector<QString>{"Made an L-prism.", "Added an L-prism."}));
    EXPECT_EQ(saidOf(Operation::Cut, "Octagon", 1),
              (std::vector<QString>{"Made an Octagon.", "Cut an Octagon."}));
}

TEST(TalkOfSteps, SaysThatInkStays) {
    EXPECT_EQ(saidOf(Operation::Cut, "Cube", 2).front(),
              "Made a box. 1 stroke that it does not use stays.");
    EXPECT_EQ(saidOf(Operation::Cut, "Cube", 9).front(),
              "Made a box. 8 strokes that it does not use stay.");
}

}  // namespace
}  // namespace ew::test
