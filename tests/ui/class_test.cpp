// SPDX-License-Identifier: GPL-3.0-or-later
// A class as its pupils and its teacher have it: joining, keeping, what goes wrong, the overview.
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QTableView>
#include <QTest>
#include <QTimer>

#include "core/document/classroom/class_overview.h"
#include "core/document/file_bytes.h"
#include "core/document/lesson/attempt.h"
#include "tests/ui/german_fixture.h"
#include "ui/lesson/class_actions.h"
#include "ui/lesson/class_session.h"
#include "ui/lesson/join_dialog.h"
#include "ui/lesson/lesson_dock.h"
#include "ui/lesson/lesson_guide.h"
#include "ui/lesson/overview_dialog.h"
#include "ui/panels/message_bar.h"
#include "ui/viewport/sketch_plane.h"
#include "ui/viewport/viewport_widget.h"

namespace ew::test {
namespace {

QString lessonPath(const char* id) {
    return QStringLiteral(EDGEWRIGHT_SOURCE_DIR "/resources/lessons/") + QLatin1String(id);
}

template <class Base>
class ClassIn : public Base {
  protected:
    void SetUp() override {
        // The person's own shelf stays out of the tests.
        qputenv("XDG_STATE_HOME", this->folder_.path().toUtf8());
        Base::SetUp();
        ASSERT_TRUE(QDir().mkpath(classFolder()));
    }
    void TearDown() override {
        Base::TearDown();
        qunsetenv("XDG_STATE_HOME");
    }
    QString classFolder() const { return this->folder_.filePath("5b"); }
    LessonGuide& guide() { return this->window_->lesson().guide(); }
    ClassSession& session() { return this->window_->lesson().session(); }
    QString said() { return this->window_->messages().text(); }
    ClassOverview overview() {
        auto found = readClass(classFolder(), {});
        EXPECT_TRUE(found) << found.error().message;
        return *std::move(found);
    }
    void join(const QString& name) {
        const auto joined = session().join(classFolder(), name);
        ASSERT_TRUE(joined) << joined.error().message;
    }
    void begin(const char* id) {
        ASSERT_TRUE(this->window_->beginLesson(lessonPath(id)));
        this->settle();
    }
    /// Draws the solution of the step.
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
        this->key(Qt::Key_Return);
        this->settle();
    }
    /// Lines that enclose nothing.
    void fail() {
        const auto lines = this->boxLines();
        this->drawLines(Hand::Pen, {lines[0], lines[1]});
        this->key(Qt::Key_Return);
        this->settle();
        this->document().clearStrokes();
    }
    QMenu& lessons() {
        QMenu* found = nullptr;
        for (QMenu* menu : this->window_->menuBar()->template findChildren<QMenu*>()) {
            if (menu->title().remove('&') == "Lessons" || menu->title().remove('&') == "Lektionen")
                found = menu;
        }
        emit found->aboutToShow();
        return *found;
    }
    QAction* action(const QString& beginning) {
        for (QAction* action : lessons().actions()) {
            if (action->text().remove('&').startsWith(beginning)) return action;
        }
        return nullptr;
    }
};

using ClassTest = ClassIn<WindowTest>;
using GermanClassTest = ClassIn<German>;

TEST_F(ClassTest, WhatAPupilDoesIsInTheClassFolder) {
    join("An/na");
    begin("first-box");
    EXPECT_EQ(window_->findChild<QLabel*>("lessonPupil")->text(), "An/na in 5b");
    trace();
    ASSERT_TRUE(guide().stepDone());
    ASSERT_TRUE(session().settle());
    const ClassOverview found = overview();
    ASSERT_EQ(found.pupils.size(), 1U);
    const ClassPupil& anna = found.pupils.front();
    EXPECT_EQ(anna.progress.name, "An/na");
    const LessonProgress& box = anna.progress.lessons.at("first-box");
    EXPECT_EQ(box.done(), 1);
    EXPECT_EQ(box.stars(), 3);
    EXPECT_FALSE(box.thumbnail.empty());
    Document work(document().state().library);
    const auto opened = work.open(anna.document("first-box"));
    ASSERT_TRUE(opened) << opened.error().message;
    EXPECT_EQ(work.state().bodies.size(), 1U);
}

TEST_F(ClassTest, SheGoesOnWhereSheWas) {
    QSettings().remove("lessons/first-box");
    join("Anna");
    begin("first-box");
    trace();
    QTest::mouseClick(window_->findChild<QPushButton*>("lessonNext"), Qt::LeftButton);
    settle();
    ASSERT_EQ(guide().step(), 1U);
    session().leave();
    guide().stop();
    EXPECT_FALSE(session().joined());
    begin("first-box");
    EXPECT_EQ(guide().step(), 0U) << "nobody in particular begins at the beginning";
    join("Berta");
    begin("first-box");
    EXPECT_EQ(guide().step(), 0U);
    join("Anna");
    begin("first-box");
    EXPECT_EQ(guide().step(), 1U);
    EXPECT_FALSE(action("Your first box")->isChecked());
    trace();
    ASSERT_TRUE(guide().stepDone());
    EXPECT_TRUE(action("Your first box")->isChecked());
    session().leave();
    EXPECT_EQ(overview().pupils.size(), 2U);
    EXPECT_TRUE(overview().pupils[0].progress.lessons.at("first-box").finished());
}

TEST_F(ClassTest, WhoFailsAgainAndAgainIsSeenToBeStuck) {
    join("Anna");
    begin("first-box");
    for (int i = 0; i < 3; ++i) fail();
    // A shape that was made and is another one counts, too, and once.
    drawLines(Hand::Pen, prismLines());
    key(Qt::Key_Return);
    settle();
    ASSERT_FALSE(document().state().bodies.empty());
    ASSERT_TRUE(document().setThresholds({33.0, 12.0}));
    settle();
    ASSERT_TRUE(session().settle());
    const auto stuck = overview().pupils.at(0).stuck;
    ASSERT_TRUE(stuck);
    EXPECT_EQ(stuck->lesson, "first-box");
    EXPECT_EQ(stuck->step, 0U);
    EXPECT_EQ(stuck->failed, 4);
    EXPECT_EQ(stuck->hint, "wrong-shape");
}

TEST_F(ClassTest, WithoutAClassNothingIsWritten) {
    begin("first-box");
    trace();
    EXPECT_FALSE(session().joined());
    EXPECT_FALSE(window_->findChild<QLabel*>("lessonPupil")->isVisible());
    EXPECT_TRUE(QDir(classFolder()).isEmpty());
}

TEST_F(ClassTest, AStickThatIsPulledOutLosesNothing) {
    join("Anna");
    begin("first-box");
    ASSERT_TRUE(session().settle());
    const QString pulled = folder_.filePath("pulled");
    ASSERT_TRUE(QDir().rename(classFolder(), pulled));
    trace();
    ASSERT_TRUE(guide().stepDone());
    EXPECT_FALSE(session().settle());
    EXPECT_TRUE(said().startsWith("Not kept in the class folder: The class folder"))
        << said().toStdString();
    EXPECT_TRUE(window_->findChild<QLabel*>("lessonPupil")->text().contains("not kept"));
    EXPECT_FALSE(QFileInfo::exists(classFolder()));
    // Back again while she works ...
    ASSERT_TRUE(QDir().rename(pulled, classFolder()));
    EXPECT_TRUE(session().settle());
    EXPECT_EQ(said(), "Everything is kept in the class folder again.");
    EXPECT_EQ(overview().pupils.at(0).stars(), 3);
    // ... or only when she is here next.
    ASSERT_TRUE(QDir().rename(classFolder(), pulled));
    QTest::mouseClick(window_->findChild<QPushButton*>("lessonNext"), Qt::LeftButton);
    settle();
    trace();
    ASSERT_TRUE(guide().stepDone());
    session().leave();
    ASSERT_TRUE(QDir().rename(pulled, classFolder()));
    EXPECT_EQ(overview().pupils.at(0).stars(), 3);
    join("Anna");
    EXPECT_EQ(overview().pupils.at(0).stars(), 6);
    EXPECT_TRUE(said().startsWith("What could not be written")) << said().toStdString();
}

TEST_F(ClassTest, AnotherMachineWithHerNameIsTold) {
    join("Anna");
    begin("first-box");
    ASSERT_TRUE(session().settle());
    auto other = PupilFiles::join(classFolder(), "Anna", {"room-7", "other"});
    ASSERT_TRUE(other);
    trace();
    ASSERT_TRUE(session().settle());
    EXPECT_TRUE(said().startsWith("Another machine (room-7) writes to")) << said().toStdString();
    EXPECT_EQ(overview().pupils.size(), 2U);
}

TEST_F(ClassTest, WhoJoinsAgainHasOneFolder) {
    join("Anna");
    begin("first-box");
    trace();
    join("Anna");
    EXPECT_FALSE(guide().running());
    begin("first-box");
    EXPECT_EQ(guide().step(), 1U);
    join("Berta");
    EXPECT_FALSE(guide().running()) << "nobody goes on in another's name";
    EXPECT_EQ(session().pupil(), "Berta");
    const auto joined = session().join(classFolder() + "/none", "Carla");
    ASSERT_FALSE(joined);
    EXPECT_EQ(session().pupil(), "Berta");
    session().leave();
    EXPECT_EQ(overview().pupils.size(), 2U);
}

TEST_F(ClassTest, ClosingTheWindowKeepsWhatWasDone) {
    join("Anna");
    begin("first-box");
    trace();
    window_.reset();
    EXPECT_EQ(overview().pupils.at(0).stars(), 3);
}

TEST_F(ClassTest, JoiningAsksForFolderAndName) {
    QSettings().remove("class/folder");
    ASSERT_TRUE(PupilFiles::join(classFolder(), "Berta", {"room-7", "x"}));
    QAction* work = action("Work in a class");
    ASSERT_NE(work, nullptr);
    QTimer::singleShot(0, [&] {
        auto* dialog = qobject_cast<JoinDialog*>(QApplication::activeModalWidget());
        ASSERT_NE(dialog, nullptr);
        auto* folder = dialog->findChild<QLineEdit*>("classFolder");
        auto* pupil = dialog->findChild<QComboBox*>("classPupil");
        auto* go = dialog->findChild<QPushButton*>("classJoin");
        EXPECT_FALSE(go->isEnabled());
        folder->setText(classFolder() + "/none");
        pupil->setEditText("Anna");
        ASSERT_TRUE(go->isEnabled());
        go->click();
        EXPECT_TRUE(dialog->isVisible()) << "it says what is wrong and stays";
        EXPECT_TRUE(dialog->findChild<QLabel*>("classProblem")
                        ->text()
                        .startsWith("There is no class folder at"));
        folder->setText(classFolder());
        emit folder->editingFinished();
        EXPECT_EQ(pupil->findText("Berta"), 0);
        EXPECT_EQ(pupil->currentText(), "Anna");
        EXPECT_EQ(dialog->findChild<QLabel*>("classProblem")->text(), "");
        go->click();
        EXPECT_FALSE(dialog->isVisible());
        if (dialog->isVisible()) dialog->reject();
    });
    work->trigger();
    EXPECT_EQ(session().pupil(), "Anna");
    EXPECT_EQ(QSettings().value("class/folder").toString(), classFolder());
    QAction* leave = action("Leave the class (Anna)");
    ASSERT_NE(leave, nullptr);
    leave->trigger();
    EXPECT_FALSE(session().joined());
    QSettings().remove("class/folder");
}

TEST_F(ClassTest, TheTeacherSeesThemAllAndOpensTheirWork) {
    join("Anna");
    begin("first-box");
    trace();
    join("Berta");
    begin("first-box");
    for (int i = 0; i < 3; ++i) fail();
    session().leave();
    guide().stop();
    const QString file = overview().pupils.at(0).document("first-box");
    const std::string bytes = *readFileBytes(file, 1U << 26U);
    ASSERT_TRUE(writeFileBytes(classFolder() + "/work/foreign.txt", "x"));

    ASSERT_TRUE(window_->lesson().classes().showOverview(classFolder()));
    auto& dialog = *window_->lesson().classes().overviewDialog();
    auto& table = *dialog.findChild<QTableView*>("overviewTable");
    const auto name = [&](int row) { return table.model()->index(row, 0).data().toString(); };
    ASSERT_EQ(table.model()->rowCount(), 2);
    EXPECT_EQ(name(0), "Berta") << "who is stuck comes first";
    EXPECT_TRUE(table.model()->index(0, 1).data().toString().contains("step 1: 3 attempts"));
    table.sortByColumn(0, Qt::AscendingOrder);
    EXPECT_EQ(name(0), "Anna");
    table.sortByColumn(3, Qt::DescendingOrder);
    EXPECT_EQ(name(0), "Anna") << "by stars";
    dialog.findChild<QCheckBox*>("overviewStuck")->setChecked(true);
    ASSERT_EQ(table.model()->rowCount(), 1);
    EXPECT_EQ(name(0), "Berta");
    dialog.findChild<QCheckBox*>("overviewStuck")->setChecked(false);
    dialog.findChild<QLineEdit*>("overviewSearch")->setText("nn");
    ASSERT_EQ(table.model()->rowCount(), 1);
    EXPECT_TRUE(dialog.findChild<QLabel*>("overviewProblems")
                    ->text()
                    .startsWith("work/foreign.txt: This is no pupil's folder"));

    auto& open = *dialog.findChild<QPushButton*>("overviewOpen");
    EXPECT_FALSE(open.isEnabled());
    table.setCurrentIndex(table.model()->index(0, 0));
    ASSERT_TRUE(open.isEnabled());
    document().reset();
    open.click();
    EXPECT_EQ(document().state().bodies.size(), 1U);
    EXPECT_TRUE(document().filePath().isEmpty()) << "nothing can be saved over hers";
    EXPECT_FALSE(document().isModified());
    EXPECT_EQ(window_->windowTitle().remove("[*]"),
              "Anna, Your first box (read-only) \u2013 Edgewright");
    EXPECT_EQ(*readFileBytes(file, 1U << 26U), bytes);
    document().reset();
    EXPECT_FALSE(window_->windowTitle().contains("Anna"));
    dialog.close();
}

TEST_F(ClassTest, TheOverviewIsExported) {
    join("Anna");
    begin("first-box");
    trace();
    ASSERT_TRUE(session().settle());
    ASSERT_TRUE(window_->lesson().classes().showOverview(classFolder()));
    auto& dialog = *window_->lesson().classes().overviewDialog();
    ASSERT_TRUE(dialog.exportTo(folder_.filePath("a.csv")));
    ASSERT_TRUE(dialog.exportTo(folder_.filePath("a.html")));
    EXPECT_NE(readFileBytes(folder_.filePath("a.csv"), 1U << 20U)->find("Anna,first-box,"),
              std::string::npos);
    EXPECT_NE(readFileBytes(folder_.filePath("a.html"), 1U << 20U)->find("data:image/png;base64,"),
              std::string::npos);
    EXPECT_EQ(dialog.exportTo(folder_.filePath("none/a.csv")).error().code, Errc::CannotWrite);
    // A class that is gone meanwhile is told, and what is shown stays.
    ASSERT_TRUE(QDir().rename(classFolder(), folder_.filePath("gone")));
    dialog.findChild<QPushButton*>("overviewRefresh")->click();
    EXPECT_TRUE(dialog.findChild<QLabel*>("overviewSaid")
                    ->text()
                    .startsWith("There is no class folder at"));
    EXPECT_EQ(dialog.findChild<QTableView*>("overviewTable")->model()->rowCount(), 1);
    dialog.close();
    EXPECT_FALSE(window_->lesson().classes().showOverview(classFolder()));
    EXPECT_TRUE(said().startsWith("There is no class folder at"));
}

TEST_F(GermanClassTest, SpeaksGerman) {
    join("Anna");
    begin("first-box");
    for (int i = 0; i < 3; ++i) fail();
    ASSERT_TRUE(session().settle());
    EXPECT_NE(action("In einer Klasse arbeiten"), nullptr);
    EXPECT_NE(action("Klasse verlassen (Anna)"), nullptr);
    ASSERT_TRUE(window_->lesson().classes().showOverview(classFolder()));
    auto& dialog = *window_->lesson().classes().overviewDialog();
    auto& table = *dialog.findChild<QTableView*>("overviewTable");
    EXPECT_EQ(table.model()->headerData(0, Qt::Horizontal), "Schüler");
    EXPECT_TRUE(table.model()->index(0, 1).data().toString().contains("Schritt 1: 3 Versuche"))
        << table.model()->index(0, 1).data().toString().toStdString();
    EXPECT_TRUE(dialog.findChild<QLabel*>("overviewSummary")
                    ->text()
                    .startsWith("1 Schüler, 1 hängt fest, Stand "));
    dialog.close();
    ASSERT_TRUE(QDir().rename(classFolder(), folder_.filePath("gone")));
    trace();
    EXPECT_FALSE(session().settle());
    EXPECT_TRUE(said().startsWith("Nicht im Klassenordner gesichert: Der Klassenordner"))
        << said().toStdString();
}

}  // namespace
}  // namespace ew::test
