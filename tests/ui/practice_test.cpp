// SPDX-License-Identifier: GPL-3.0-or-later
// Exercises in the window: shown, drawn, graded, kept.
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTest>
#include <QTimer>

#include "core/document/classroom/class_overview.h"
#include "core/document/lesson/attempt.h"
#include "tests/ui/german_fixture.h"
#include "ui/lesson/class_session.h"
#include "ui/lesson/lesson_dock.h"
#include "ui/lesson/lesson_guide.h"
#include "ui/lesson/practice_actions.h"
#include "ui/lesson/practice_curve.h"
#include "ui/lesson/practice_dialog.h"
#include "ui/viewport/sketch_plane.h"
#include "ui/viewport/viewport_widget.h"

namespace ew::test {
namespace {

template <class Base>
class PracticeIn : public Base {
  protected:
    void SetUp() override {
        // The person's own history stays out of the tests.
        qputenv("XDG_STATE_HOME", this->folder_.path().toUtf8());
        QSettings().remove("practice/level");
        Base::SetUp();
    }
    void TearDown() override {
        Base::TearDown();
        qunsetenv("XDG_STATE_HOME");
    }
    LessonGuide& guide() { return this->window_->lesson().guide(); }
    QLabel& label(const char* name) {
        return *this->window_->template findChild<QLabel*>(QLatin1String(name));
    }
    void begin(int level, std::uint32_t seed) {
        ASSERT_TRUE(this->window_->lesson().practice().begin(level, seed));
        this->settle();
    }
    void trace() {
        const Lesson& lesson = guide().lesson();
        const auto stage = stageOf(lesson, 0, this->document().state().library);
        ASSERT_TRUE(stage);
        const QTransform map = sketchToView(stage->begin->camera(), this->document().camera());
        for (const ScriptStep& step : lesson.solution.steps) {
            const auto* stroke = std::get_if<StrokeStep>(&step);
            if (stroke == nullptr) continue;
            const auto& samples = stroke->stroke.samples;
            this->drawLine(Hand::Pen, toVec(map.map(toPoint(samples.front().position))),
                           toVec(map.map(toPoint(samples.back().position))));
        }
        this->key(Qt::Key_Return);
        this->settle();
    }
    static std::vector<PracticeResult> kept() {
        return *PracticeLog(PracticeLog::standardPath()).list();
    }
};

using PracticeTest = PracticeIn<WindowTest>;
using GermanPracticeTest = PracticeIn<German>;

TEST_F(PracticeTest, AnExerciseIsShownDrawnAndKept) {
    QSettings().remove("lessons/practice-1-3");
    const QImage empty = window_->viewport().grabFramebuffer();
    begin(1, 3);
    EXPECT_TRUE(window_->lesson().isVisible());
    EXPECT_FALSE(label("practicePicture").pixmap().isNull());
    EXPECT_TRUE(label("practicePicture").isVisible());
    EXPECT_FALSE(window_->findChild<QPushButton*>("lessonHint")->isVisible());
    trace();
    ASSERT_TRUE(guide().stepDone()) << label("lessonSaid").text().toStdString();
    EXPECT_GT(guide().result()->accuracy, 0.9);
    EXPECT_EQ(guide().result()->strokes, 9);
    EXPECT_GT(guide().result()->seconds, 0.0);
    EXPECT_TRUE(label("lessonSaid").text().startsWith("Done. Accuracy "));
    ASSERT_EQ(kept().size(), 1U);
    EXPECT_EQ(kept().front(), *guide().result());
    EXPECT_FALSE(QSettings().contains("lessons/practice-1-3")) << "it is no lesson";
    // On to the next one.
    bool asked = false;
    QTimer::singleShot(200, [&] {
        auto* dialog = qobject_cast<PracticeDialog*>(QApplication::activeModalWidget());
        ASSERT_NE(dialog, nullptr);
        asked = true;
        EXPECT_EQ(dialog->choice().level, 1);
        EXPECT_EQ(dialog->choice().seed, 4U);
        EXPECT_TRUE(dialog->findChild<PracticeCurve*>()->accessibleName().startsWith("Accuracy"));
        dialog->findChild<QSpinBox*>("practiceLevel")->setValue(2);
        dialog->findChild<QPushButton*>("practiceBegin")->click();
    });
    QTest::mouseClick(window_->findChild<QPushButton*>("lessonNext"), Qt::LeftButton);
    EXPECT_TRUE(QTest::qWaitFor([&] { return asked && guide().running(); }, 5'000));
    ASSERT_NE(guide().practice(), nullptr);
    EXPECT_EQ(guide().practice()->level, 2);
    EXPECT_EQ(QSettings().value("practice/level").toInt(), 2);
}

TEST_F(PracticeTest, ItsLinesAreShownOnlyToWhoAsks) {
    begin(1, 3);
    EXPECT_FALSE(guide().showsGhost());
    const QImage before = window_->viewport().grabFramebuffer();
    guide().showStrokes();
    EXPECT_TRUE(QTest::qWaitFor([&] { return guide().showsGhost(); }, 5'000));
    EXPECT_NE(window_->viewport().grabFramebuffer(), before);
    guide().again();
    EXPECT_FALSE(guide().showsGhost());
}

TEST_F(PracticeTest, AnotherShapeIsNotIt) {
    begin(1, 3);
    drawLines(Hand::Pen, prismLines());
    key(Qt::Key_Return);
    settle();
    EXPECT_FALSE(guide().stepDone());
    EXPECT_EQ(label("lessonSaid").text(), "It became another kind of shape.");
    EXPECT_TRUE(kept().empty());
}

TEST_F(PracticeTest, InAClassItIsKeptThere) {
    ASSERT_TRUE(window_->lesson().session().join(folder_.path(), "Anna"));
    begin(1, 3);
    trace();
    ASSERT_TRUE(guide().stepDone());
    ASSERT_TRUE(window_->lesson().session().settle());
    const auto found = readClass(folder_.path(), {});
    ASSERT_TRUE(found);
    ASSERT_EQ(found->pupils.size(), 1U);
    EXPECT_EQ(found->pupils[0].progress.practice.size(), 1U);
    EXPECT_TRUE(found->pupils[0].progress.lessons.empty()) << "it is no lesson";
    EXPECT_TRUE(kept().empty());
}

TEST_F(PracticeTest, ALessonAfterItIsALessonAgain) {
    begin(1, 3);
    ASSERT_TRUE(
        window_->beginLesson(QStringLiteral(EDGEWRIGHT_SOURCE_DIR "/resources/lessons/first-box")));
    settle();
    EXPECT_EQ(guide().practice(), nullptr);
    EXPECT_FALSE(label("practicePicture").isVisible());
    EXPECT_TRUE(window_->findChild<QPushButton*>("lessonHint")->isVisible());
}

TEST_F(GermanPracticeTest, SpeaksGerman) {
    begin(1, 3);
    trace();
    ASSERT_TRUE(guide().stepDone());
    EXPECT_TRUE(label("lessonSaid").text().startsWith("Geschafft. Genauigkeit "))
        << label("lessonSaid").text().toStdString();
}

}  // namespace
}  // namespace ew::test
