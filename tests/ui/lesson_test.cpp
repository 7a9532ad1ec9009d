// SPDX-License-Identifier: GPL-3.0-or-later
// A lesson as a pupil goes through it: tracing, hints, going on, ending.
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QTest>

#include "core/document/lesson/attempt.h"
#include "tests/ui/german_fixture.h"
#include "ui/actions/file_actions.h"
#include "ui/lesson/lesson_dock.h"
#include "ui/lesson/lesson_guide.h"
#include "ui/panels/message_bar.h"
#include "ui/viewport/sketch_plane.h"
#include "ui/viewport/viewport_widget.h"

namespace ew::test {
namespace {

QString lessonPath(const char* id) {
    return QStringLiteral(EDGEWRIGHT_SOURCE_DIR "/resources/lessons/") + QLatin1String(id);
}

template <class Base>
class LessonIn : public Base {
  protected:
    LessonGuide& guide() { return this->window_->lesson().guide(); }
    QString label(const char* name) {
        return this->window_->template findChild<QLabel*>(QLatin1String(name))->text();
    }
    QPushButton& button(const char* name) {
        return *this->window_->template findChild<QPushButton*>(QLatin1String(name));
    }
    void click(const char* name) {
        QTest::mouseClick(&button(name), Qt::LeftButton);
        this->settle();
    }
    void begin(const char* id) {
        ASSERT_TRUE(this->window_->beginLesson(lessonPath(id)));
        this->settle();
    }
    /// Follows the strokes to trace from end to end.
    void trace() {
        const Lesson& lesson = guide().lesson();
        const auto [from, to] = taskOf(lesson, guide().step());
        const auto stage = stageOf(lesson, guide().step(), this->document().state().library);
        ASSERT_TRUE(stage);
        const QTransform map = sketchToView(stage->begin->camera(), this->document().camera());
        for (std::size_t i = from; i < to; ++i) {
            const auto* stroke = std::get_if<StrokeStep>(&lesson.solution.steps[i]);
            if (stroke == nullptr) continue;
            const auto& samples = stroke->stroke.samples;
            this->drawLine(Hand::Pen, toVec(map.map(toPoint(samples.front().position))),
                           toVec(map.map(toPoint(samples.back().position))));
        }
    }
};

using LessonTest = LessonIn<WindowTest>;
using GermanLessonTest = LessonIn<German>;

TEST_F(LessonTest, IsFinishedByTracing) {
    QSettings().remove("lessons/first-box");
    begin("first-box");
    EXPECT_TRUE(window_->lesson().isVisible());
    for (int step = 0; step < 2; ++step) {
        ASSERT_EQ(guide().step(), static_cast<std::size_t>(step));
        EXPECT_FALSE(guide().stepDone());
        EXPECT_FALSE(button("lessonNext").isEnabled());
        trace();
        EXPECT_FALSE(guide().stepDone()) << "nothing was made yet";
        key(Qt::Key_Return);
        settle();
        EXPECT_TRUE(guide().stepDone()) << label("lessonSaid").toStdString();
        EXPECT_EQ(guide().stars(guide().step()), 3);
        ASSERT_TRUE(button("lessonNext").isEnabled());
        EXPECT_EQ(button("lessonNext").text(), step == 0 ? "Next" : "Finish");
        click("lessonNext");
    }
    EXPECT_FALSE(guide().running());
    EXPECT_FALSE(window_->lesson().isVisible());
    EXPECT_EQ(document().state().bodies.size(), 1U) << "what was made stays";
    EXPECT_EQ(rememberedStars("first-box"), (std::vector<int>{3, 3}));
}

TEST_F(LessonTest, AnotherShapeIsNotDoneAndSaysWhy) {
    begin("first-box");
    drawLines(Hand::Pen, prismLines());
    key(Qt::Key_Return);
    settle();
    ASSERT_FALSE(document().state().bodies.empty());
    EXPECT_FALSE(guide().stepDone());
    EXPECT_EQ(label("lessonSaid"), "It became another kind of shape.");
    // Undo works as everywhere, and then nothing is wrong any more.
    ASSERT_TRUE(document().undo());
    settle();
    EXPECT_EQ(label("lessonSaid"), "");
    click("lessonAgain");
    EXPECT_TRUE(document().state().bodies.empty());
    EXPECT_TRUE(document().pendingStrokes().empty());
    trace();
    key(Qt::Key_Return);
    settle();
    EXPECT_TRUE(guide().stepDone());
}

TEST_F(LessonTest, MoreStrokesAreFewerStars) {
    begin("first-box");
    drawLine(Hand::Pen, {100, 100}, {160, 120});
    drawLine(Hand::Pen, {100, 140}, {160, 160});
    document().clearStrokes();
    trace();
    key(Qt::Key_Return);
    settle();
    ASSERT_TRUE(guide().stepDone());
    EXPECT_EQ(guide().stars(0), 2);
}

TEST_F(LessonTest, HintsAreThereWhenTheyAreAskedFor) {
    begin("first-box");
    EXPECT_EQ(label("lessonSaid"), "");
    click("lessonHint");
    EXPECT_TRUE(label("lessonSaid").startsWith("Draw only the edges that you can see"));
    EXPECT_FALSE(button("lessonHint").isEnabled());
    const QImage before = window_->viewport().grabFramebuffer();
    click("lessonShow");
    QTest::qWait(300);
    EXPECT_NE(window_->viewport().grabFramebuffer(), before) << "a pen draws";
}

TEST_F(LessonTest, GhostsAreSeenUntilTheStepIsDone) {
    const QImage empty = window_->viewport().grabFramebuffer();
    begin("first-box");
    EXPECT_NE(window_->viewport().grabFramebuffer(), empty);
    click("lessonEnd");
    EXPECT_FALSE(guide().running());
    EXPECT_FALSE(window_->lesson().isVisible());
}

TEST_F(LessonTest, AStepAboutTheThresholdsIsDoneByThem) {
    begin("thresholds");
    trace();
    key(Qt::Key_Return);
    settle();
    ASSERT_TRUE(guide().stepDone()) << label("lessonSaid").toStdString();
    click("lessonNext");
    EXPECT_FALSE(guide().stepDone());
    ASSERT_TRUE(document().setThresholds({33.0, 12.0}));
    settle();
    EXPECT_TRUE(guide().stepDone());
}

TEST_F(LessonTest, WorkThatIsNotSavedIsAskedAbout) {
    drawLines(Hand::Mouse, boxLines());
    key(Qt::Key_Return);
    ASSERT_EQ(document().state().bodies.size(), 1U);
    bool asked = false;
    window_->files().setQuestion([&] {
        asked = true;
        return FileActions::Answer::Cancel;
    });
    EXPECT_FALSE(window_->beginLesson(lessonPath("first-box")));
    EXPECT_TRUE(asked);
    EXPECT_FALSE(guide().running());
    EXPECT_EQ(document().state().bodies.size(), 1U);
    window_->files().setQuestion([] { return FileActions::Answer::Discard; });
}

TEST_F(LessonTest, WhatIsNoLessonIsSaid) {
    EXPECT_FALSE(window_->beginLesson(folder_.filePath("none")));
    EXPECT_FALSE(window_->messages().text().isEmpty());
    EXPECT_FALSE(guide().running());
}

TEST_F(LessonTest, TheMenuListsThem) {
    QMenu* lessons = nullptr;
    for (QMenu* menu : window_->menuBar()->findChildren<QMenu*>()) {
        if (menu->title() == "&Lessons") lessons = menu;
    }
    ASSERT_NE(lessons, nullptr);
    emit lessons->aboutToShow();
    EXPECT_GE(lessons->actions().size(), 9 + 2);
    QSettings().setValue("lessons/first-box", "3 2");
    emit lessons->aboutToShow();
    bool found = false;
    for (QAction* action : lessons->actions()) {
        if (!action->text().startsWith("Your first box")) continue;
        found = true;
        EXPECT_TRUE(action->isChecked());
    }
    EXPECT_TRUE(found);
    QSettings().remove("lessons/first-box");
}

TEST_F(GermanLessonTest, SpeaksGerman) {
    begin("first-box");
    const bool german = QLocale().language() == QLocale::German;
    EXPECT_EQ(button("lessonAgain").text(), "Von vorn");
    if (german) {
        EXPECT_TRUE(label("lessonTask").startsWith("Zeichne die neun Kanten"));
    }
    drawLines(Hand::Pen, prismLines());
    key(Qt::Key_Return);
    settle();
    EXPECT_EQ(label("lessonSaid").toStdString(), "Es wurde eine andere Form daraus.");
}

}  // namespace
}  // namespace ew::test
