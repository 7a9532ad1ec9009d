// SPDX-License-Identifier: GPL-3.0-or-later
// Trying a template on the sheet of its editor.
#include <QTableWidget>

#include "tests/ui/editor_fixture.h"
#include "ui/template_editor/confusion_run.h"

namespace ew::test {
namespace {

/// A pen, or its other end, in any window.
class PenIn {
  public:
    PenIn(QWidget& widget, QPointingDevice::PointerType type)
        : widget_(widget),
          device_(QStringLiteral("test pen"), 90 + static_cast<int>(type),
                  QInputDevice::DeviceType::Stylus, type,
                  QInputDevice::Capability::Position | QInputDevice::Capability::Pressure |
                      QInputDevice::Capability::Hover,
                  1, 3, QString(), QPointingDeviceUniqueId::fromNumericId(4712)) {}

    void drag(const QPointF& from, const QPointF& to) const {
        constexpr int kSteps = 30;
        send(from, Qt::NoButton);
        for (int i = 0; i <= kSteps; ++i) {
            send(from + (to - from) * (static_cast<double>(i) / kSteps), Qt::LeftButton);
        }
        send(to, Qt::NoButton);
    }
    void leave() const {
        QWindowSystemInterface::handleTabletEnterLeaveProximityEvent(nullptr, 300'000, &device_,
                                                                     false);
        QWindowSystemInterface::sendWindowSystemEvents(QEventLoop::AllEvents);
    }

  private:
    void send(const QPointF& at, Qt::MouseButtons buttons) const {
        static unsigned long clockMs = 200'000;
        clockMs += 8;
        QWidget& window = *widget_.window();
        const double scale = window.windowHandle()->devicePixelRatio();
        QWindowSystemInterface::handleTabletEvent(
            window.windowHandle(), clockMs, &device_, widget_.mapTo(&window, at) * scale,
            widget_.mapToGlobal(at) * scale, buttons, buttons == Qt::NoButton ? 0.0 : 0.6, 0, 0,
            0.0, 0.0, 0, Qt::NoModifier);
        QWindowSystemInterface::sendWindowSystemEvents(QEventLoop::AllEvents);
    }

    QWidget& widget_;
    QPointingDevice device_;
};

TEST_F(EditorTest, WhatIsDrawnOnTheSheetIsReadAsTheTemplate) {
    TemplateEditor* editor = editorFromMenu();
    ASSERT_NE(editor, nullptr);
    drawOnSheet(*editor, 3);
    EXPECT_EQ(editor->model().draft().trial.size(), lines_);
    EXPECT_TRUE(editor->trial().isAccepted()) << editor->trial().sentence().toStdString();
    EXPECT_EQ(editor->trialPage().verdict(), "It is read as this template.");
    // Trying is no change of the template, but can be taken back all the same.
    EXPECT_FALSE(editor->model().isChanged());
    keys(*editor, QKeySequence::Undo);
    EXPECT_EQ(editor->model().draft().trial.size(), lines_ - 1);
    EXPECT_FALSE(editor->trial().isAccepted());
    EXPECT_TRUE(document().pendingStrokes().empty());
}

TEST_F(EditorTest, PenAndMouseDrawOnTheSheetAndTheEraserTakesAway) {
    TemplateEditor* editor = editorFromMenu();
    ASSERT_NE(editor, nullptr);
    part<QTabWidget>(*editor, "editorPages").setCurrentIndex(1);
    settle(*editor);
    TemplateModel& model = editor->model();
    TrialCanvas& canvas = editor->trialPage().canvas();
    MouseIn(canvas).drag({50, 50}, {200, 60});
    PenIn(canvas, QPointingDevice::PointerType::Pen).drag({50, 150}, {200, 160});
    MouseIn(canvas).click({100, 100});  // a click is no stroke
    ASSERT_EQ(model.draft().trial.size(), 2U);
    EXPECT_GT(model.draft().trial[1].samples.size(), 10U);
    const PenIn eraser(canvas, QPointingDevice::PointerType::Eraser);
    eraser.drag({60, 250}, {90, 260});
    EXPECT_EQ(model.draft().trial.size(), 2U);
    eraser.drag({120, 140}, {124, 175});
    ASSERT_EQ(model.draft().trial.size(), 1U);
    EXPECT_LT(model.draft().trial[0].samples[0].position.y(), 100.0);
    eraser.leave();
    for (QPushButton* button : editor->trialPage().findChildren<QPushButton*>()) click(*button);
    EXPECT_TRUE(model.draft().trial.empty());
    keys(*editor, QKeySequence::Undo);
    keys(*editor, QKeySequence::Undo);
    EXPECT_EQ(model.draft().trial.size(), 2U);
}

TEST_F(EditorTest, MixUpsAreCountedInTheBackground) {
    TemplateEditor* editor = editorFromMenu();
    ASSERT_NE(editor, nullptr);
    ConfusionRun& run = editor->confusion();
    constexpr int kFew = 6;
    run.start(kFew);
    EXPECT_TRUE(run.isRunning());
    run.settle();
    ASSERT_FALSE(run.rows().empty());
    for (const ConfusionRow& row : run.rows()) {
        EXPECT_EQ(row.drawings, kFew);
        EXPECT_EQ(row.right() + row.wrong() + row.asked + row.refused, kFew);
    }
    EXPECT_GE(run.rows().front().right(), kFew - 1);
    EXPECT_FALSE(run.isOld());
    auto& table = part<QTableWidget>(*editor, "confusionTable");
    EXPECT_EQ(table.rowCount(), static_cast<int>(run.rows().size()));
    EXPECT_EQ(table.item(0, 0)->text(), "This template");
    tick(*editor, 0);
    EXPECT_TRUE(run.isOld());
}

TEST_F(EditorTest, CountingMixUpsCanBeStopped) {
    TemplateEditor* editor = editorFromMenu();
    ASSERT_NE(editor, nullptr);
    part<QTabWidget>(*editor, "editorPages").setCurrentIndex(2);
    settle(*editor);
    auto& button = part<QPushButton>(*editor, "confusionStart");
    click(button);
    ASSERT_TRUE(editor->confusion().isRunning());
    click(button);
    editor->confusion().settle();
    EXPECT_FALSE(editor->confusion().isRunning());
    EXPECT_LT(editor->confusion().done(), 1.0);
    EXPECT_TRUE(editor->confusion().rows().empty());
}

}  // namespace
}  // namespace ew::test
