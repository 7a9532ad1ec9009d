// SPDX-License-Identifier: GPL-3.0-or-later
// What is done in the window outlives it: working copies, and how an earlier run's are offered.
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <QTimer>

#include "core/document/document_compare.h"
#include "core/document/file_bytes.h"
#include "tests/ui/window_fixture.h"
#include "ui/actions/file_actions.h"
#include "ui/dialogs/recover_dialog.h"
#include "ui/panels/message_bar.h"
#include "ui/work_keeper.h"

namespace ew::test {
namespace {

class WorkCopies : public WindowTest {
  protected:
    WorkCopies() { workFolder_ = folder_.filePath("work"); }

    WorkKeeper& keeper() { return *window_->workKeeper(); }

    /// A machine that was switched off now and where the program is started again.
    /// \return the folder with what it finds.
    QString afterPowerCut() {
        EXPECT_TRUE(keeper().copy().flush());
        const QString there = folder_.filePath(QStringLiteral("cut%1").arg(++cuts_));
        QDir().mkpath(there);
        for (const QFileInfo& file : QDir(workFolder_).entryInfoList(QDir::Files)) {
            QFile::copy(file.filePath(), there + '/' + file.fileName());
        }
        return there;
    }

    /// Clicks buttons of the dialog that offers copies, one after the other.
    void whileOffered(const QStringList& buttons, const std::function<void()>& action) {
        bool seen = false;
        QTimer timer;
        QObject::connect(&timer, &QTimer::timeout, [&] {
            auto* dialog = qobject_cast<RecoverDialog*>(QApplication::activeModalWidget());
            if (dialog == nullptr || !dialog->isVisible()) return;
            timer.stop();
            seen = true;
            for (const QString& text : buttons) {
                for (auto* button : dialog->findChildren<QPushButton*>()) {
                    if (button->text().remove('&') == text) button->click();
                }
            }
            if (dialog->isVisible()) dialog->reject();
        });
        timer.start(10);
        action();
        EXPECT_TRUE(seen) << "nothing was offered";
    }

    MainWindow& openSecondWindow(const QString& work) {
        second_ =
            std::make_unique<MainWindow>(document().state().library, *appearance_,
                                         MainWindowOptions{.remember = false, .workFolder = work});
        second_->files().setQuestion([] { return FileActions::Answer::Discard; });
        second_->show();
        QApplication::processEvents();
        return *second_;
    }

    void TearDown() override {
        second_.reset();
        WindowTest::TearDown();
    }

    std::unique_ptr<MainWindow> second_;
    int cuts_ = 0;
};

TEST_F(WorkCopies, NothingIsKeptOfAWindowInWhichNothingWasDone) {
    settle();
    EXPECT_TRUE(keeper().copy().path().isEmpty());
    EXPECT_FALSE(keeper().offerLost());
}

TEST_F(WorkCopies, ASolidAndAStrokeComeBackAfterAPowerCut) {
    drawLines(Hand::Pen, boxLines());
    ASSERT_TRUE(document().apply());
    drawLine(Hand::Mouse, {100, 100}, {220, 130});
    keeper().takePicture();
    const QString there = afterPowerCut();
    // Another window, as the next start opens it.
    WorkKeeper* later = openSecondWindow(there).workKeeper();
    ASSERT_NE(later, nullptr);
    whileOffered({"Recover"}, [&] { EXPECT_TRUE(later->offerLost()); });
    Document& found = second_->document();
    EXPECT_TRUE(identicalDocuments(document(), found));
    EXPECT_TRUE(found.isModified());
    EXPECT_NE(second_->messages().text().indexOf("Recovered: 1 step"), -1)
        << second_->messages().text().toStdString();
    // It is kept on, once.
    ASSERT_TRUE(later->copy().flush());
    QApplication::processEvents();
    EXPECT_EQ(WorkFolder(there).list().size(), 1U);
    EXPECT_TRUE(WorkFolder(there).list().front().open);
    while (found.undoInk()) {
    }
    EXPECT_TRUE(found.undo());
    EXPECT_EQ(found.pendingStrokes().size(), 9U);
}

TEST_F(WorkCopies, EveryStrokeIsThereOnceTheEventsAreDone) {
    drawLine(Hand::Pen, {300, 300}, {420, 330});
    QApplication::processEvents();  // no flush: the window does it by itself
    ASSERT_FALSE(keeper().copy().path().isEmpty());
    drawLine(Hand::Pen, {300, 400}, {420, 430});
    QTRY_VERIFY(QFileInfo(keeper().copy().path() + "-wal").size() > 0);
    const WorkFolder cut(afterPowerCut());
    ASSERT_EQ(cut.list().size(), 1U);
    EXPECT_EQ(cut.list().front().summary.strokes, 2);
}

TEST_F(WorkCopies, WhatIsPutAwayIsNotOfferedAgainButStays) {
    drawLine(Hand::Mouse, {100, 100}, {220, 130});
    const QString there = afterPowerCut();
    WorkKeeper* later = openSecondWindow(there).workKeeper();
    whileOffered({"Put away"}, [&] { EXPECT_TRUE(later->offerLost()); });
    EXPECT_FALSE(later->offerLost());
    EXPECT_EQ(WorkFolder(there).list().size(), 1U);
    whileOffered({"Recover"}, [&] { later->offerAll(); });
    EXPECT_EQ(second_->document().pendingStrokes().size(), 1U);
}

TEST_F(WorkCopies, ASavedDocumentIsNotOffered) {
    drawLine(Hand::Mouse, {100, 100}, {220, 130});
    ASSERT_TRUE(window_->files().saveTo(folder_.filePath("a.edgewright")));
    const WorkFolder cut(afterPowerCut());
    ASSERT_EQ(cut.list().size(), 1U);
    EXPECT_FALSE(cut.list().front().lost());
    EXPECT_FALSE(cut.list().front().summary.thumbnail.empty());
    drawLine(Hand::Mouse, {100, 150}, {220, 180});
    EXPECT_TRUE(WorkFolder(afterPowerCut()).list().front().lost());
}

TEST_F(WorkCopies, AnotherWindowOnTheSameFileIsTold) {
    drawLine(Hand::Mouse, {100, 100}, {220, 130});
    const QString path = folder_.filePath("a.edgewright");
    ASSERT_TRUE(window_->files().saveTo(path));
    MainWindow& second = openSecondWindow(workFolder_);
    ASSERT_TRUE(second.files().openPath(path));
    EXPECT_NE(second.messages().text().indexOf("a.edgewright is open in another window"), -1)
        << second.messages().text().toStdString();
}

TEST_F(WorkCopies, TheQuestionAboutChangesSaysWhatBecomesOfThem) {
    /// The informative text of the box that a window asks with before it lets go of its changes.
    const auto asked = [&](MainWindow& window) {
        QString text;
        QTimer timer;
        QObject::connect(&timer, &QTimer::timeout, [&] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            if (box == nullptr || !box->isVisible()) return;
            timer.stop();
            text = box->informativeText();
            box->button(QMessageBox::Discard)->click();
        });
        timer.start(10);
        EXPECT_TRUE(window.files().mayDiscard());
        return text;
    };
    const auto draw = [](Document& document) {
        ASSERT_TRUE(document.addStroke(Stroke{{{Vec2(10, 10), 1, 0}, {Vec2(90, 10), 1, 0}}}));
    };
    MainWindow kept(document().state().library, *appearance_,
                    MainWindowOptions{.remember = false, .workFolder = workFolder_});
    draw(kept.document());
    EXPECT_TRUE(asked(kept).contains("Recover")) << asked(kept).toStdString();
    kept.document().reset();
    whileOffered({"Recover"}, [&] { kept.workKeeper()->offerAll(); });
    EXPECT_EQ(kept.document().pendingStrokes().size(), 1U) << "as it was said";
    MainWindow lost(document().state().library, *appearance_,
                    MainWindowOptions{.remember = false, .workFolder = {}});
    draw(lost.document());
    EXPECT_EQ(asked(lost), "They are lost otherwise.");
}

}  // namespace
}  // namespace ew::test
