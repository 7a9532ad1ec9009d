// SPDX-License-Identifier: GPL-3.0-or-later
// What a window shows before anything is opened in it, and how files come into windows.
#include "ui/start/start_page.h"

#include <QDir>
#include <QDockWidget>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QMenuBar>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QTest>
#include <QToolBar>
#include <QUrl>

#include "core/document/recent_files.h"
#include "tests/ui/window_fixture.h"
#include "ui/actions/file_actions.h"
#include "ui/lesson/lesson_dock.h"
#include "ui/lesson/lesson_guide.h"
#include "ui/panels/message_bar.h"
#include "ui/start/card_delegate.h"
#include "ui/viewport/viewport_widget.h"
#include "ui/window_list.h"
#include "ui/work_keeper.h"

namespace ew::test {
namespace {

class Start : public WindowTest {
  protected:
    Start() {
        recentList_ = folder_.filePath("recent.json");
        workFolder_ = folder_.filePath("work");
    }
    template <class T>
    T& part(const char* name) {
        T* found = window_->findChild<T*>(name);
        EXPECT_NE(found, nullptr) << name;
        return *found;
    }
    QListView& cards() { return part<QListView>("startCards"); }
    QStringList names() {
        QStringList out;
        const auto* model = cards().model();
        for (int i = 0; i < model->rowCount(); ++i) out << model->index(i, 0).data().toString();
        return out;
    }
    void click(int row) {
        const QModelIndex index = cards().model()->index(row, 0);
        cards().scrollTo(index);
        QTest::mouseClick(cards().viewport(), Qt::LeftButton, {},
                          cards().visualRect(index).center());
    }
    QString path(const QString& name) const { return folder_.filePath(name); }
    /// A document with a cube in a file of this name.
    void saveCube(const QString& name) {
        drawLines(Hand::Mouse, boxLines());
        key(Qt::Key_Return);
        ASSERT_TRUE(window_->files().saveTo(path(name)));
    }
    void showStart() {
        window_->showStart();
        QApplication::processEvents();
    }
};

TEST_F(Start, AtFirstItShowsTheExamplesAndNoPanels) {
    showStart();
    EXPECT_TRUE(window_->startShown());
    EXPECT_FALSE(window_->viewport().isVisible());
    for (const QDockWidget* panel : window_->findChildren<QDockWidget*>()) {
        EXPECT_FALSE(panel->isVisible()) << panel->objectName().toStdString();
    }
    EXPECT_GE(names().size(), 8);
    const auto box = names().indexOf("A box, drawn by hand");
    ASSERT_GE(box, 0) << names().join(", ").toStdString();
    click(static_cast<int>(box));
    EXPECT_FALSE(window_->startShown());
    EXPECT_EQ(document().state().bodies.size(), 1U);
    EXPECT_TRUE(RecentFiles(recentList_).list().empty()) << "examples are nobody's documents";
}

TEST_F(Start, ALessonIsBegunFromItsCard) {
    QSettings().setValue("lessons/first-box", "3 2");
    showStart();
    window_->startPage()->show(StartPage::Section::Lessons);
    QApplication::processEvents();
    EXPECT_EQ(names().size(), 9);
    const auto box = names().indexOf("Your first box");
    ASSERT_EQ(box, 0) << "the shortest and easiest first: " << names().join(", ").toStdString();
    const QModelIndex card = cards().model()->index(static_cast<int>(box), 0);
    EXPECT_FALSE(card.data(Qt::DecorationRole).value<QPixmap>().isNull());
    EXPECT_EQ(card.data(kDetailRole).toString(), "5 min \u00b7 \u2605 5 / 6");
    click(static_cast<int>(box));
    EXPECT_FALSE(window_->startShown());
    EXPECT_TRUE(window_->lesson().guide().running());
    EXPECT_TRUE(window_->lesson().isVisible());
    QSettings().remove("lessons/first-box");
}

TEST_F(Start, NewAndEscapeLeadToTheDrawing) {
    for (const bool escape : {false, true}) {
        showStart();
        ASSERT_TRUE(window_->startShown());
        if (escape)
            QTest::keyClick(&cards(), Qt::Key_Escape);
        else
            part<QPushButton>("startNew").click();
        EXPECT_FALSE(window_->startShown());
        EXPECT_TRUE(window_->viewport().isVisible());
        EXPECT_TRUE(window_->viewport().hasFocus());
        EXPECT_TRUE(part<QToolBar>("toolBar").isVisible());
        EXPECT_TRUE(part<QDockWidget>("historyPanel").isVisible());
    }
}

TEST_F(Start, ListsWhatWasSavedWithAPicture) {
    saveCube("first.edgewright");
    ASSERT_TRUE(window_->files().saveTo(path("second.edgewright")));
    showStart();
    EXPECT_EQ(names(), (QStringList{"second", "first"}));
    const QModelIndex card = cards().model()->index(0, 0);
    EXPECT_FALSE(card.data(Qt::DecorationRole).value<QPixmap>().isNull());
    click(1);
    EXPECT_FALSE(window_->startShown());
    EXPECT_EQ(document().filePath(), path("first.edgewright"));
}

TEST_F(Start, SearchLooksInNamesAndFolders) {
    QDir(folder_.path()).mkpath("tray");
    saveCube("lid.edgewright");
    ASSERT_TRUE(window_->files().saveTo(path("tray/base.edgewright")));
    showStart();
    auto& search = part<QLineEdit>("startSearch");
    search.setText("TRAY");
    EXPECT_EQ(names(), QStringList{"base"});
    search.setText("li");
    EXPECT_EQ(names(), QStringList{"lid"});
    search.setText("no such thing");
    EXPECT_TRUE(names().isEmpty());
    EXPECT_TRUE(part<QLabel>("startEmpty").isVisible());
    search.clear();
    EXPECT_EQ(names().size(), 2);
}

TEST_F(Start, AFileThatVanishedIsShownAsSuch) {
    saveCube("gone.edgewright");
    QFile::remove(path("gone.edgewright"));
    window_->files().newDocument();
    showStart();
    ASSERT_EQ(names(), QStringList{"gone"});
    EXPECT_TRUE(cards().model()->index(0, 0).data(kMissingRole).toBool());
    click(0);
    EXPECT_TRUE(window_->startShown());
    EXPECT_TRUE(window_->messages().isVisible()) << "it says why";
    EXPECT_FALSE(window_->messages().text().isEmpty());
    cards().setFocus();
    cards().setCurrentIndex(cards().model()->index(0, 0));
    QTest::keyClick(&cards(), Qt::Key_Delete);
    EXPECT_TRUE(RecentFiles(recentList_).list().empty());
}

TEST_F(Start, APinIsSetByItsOwnClick) {
    saveCube("a.edgewright");
    ASSERT_TRUE(window_->files().saveTo(path("b.edgewright")));
    showStart();
    const QRect card = cards().visualRect(cards().model()->index(1, 0));
    const QPoint pin = card.topRight() + QPoint(-22, 22);
    QTest::mouseMove(cards().viewport(), pin);
    QTest::mouseClick(cards().viewport(), Qt::LeftButton, {}, pin);
    EXPECT_TRUE(window_->startShown()) << "the card itself was not clicked";
    EXPECT_EQ(names(), (QStringList{"a", "b"}));
    EXPECT_TRUE(RecentFiles(recentList_).list().front().pinned);
}

TEST_F(Start, LostWorkComesFirst) {
    drawLines(Hand::Mouse, boxLines());
    key(Qt::Key_Return);
    ASSERT_TRUE(window_->workKeeper()->copy().flush());
    // As another start finds it after a power cut.
    const QString there = path("cut");
    QDir().mkpath(there);
    for (const QFileInfo& file : QDir(workFolder_).entryInfoList(QDir::Files)) {
        QFile::copy(file.filePath(), there + '/' + file.fileName());
    }
    MainWindow second(document().state().library, *appearance_,
                      {.remember = false, .workFolder = there, .recentList = path("other.json")});
    second.show();
    second.showStart();
    ASSERT_EQ(second.startPage()->lostCount(), 1);
    auto* list = second.findChild<QListView*>("startCards");
    ASSERT_EQ(list->model()->rowCount(), 1);
    list->setCurrentIndex(list->model()->index(0, 0));
    QTest::keyClick(list, Qt::Key_Return);
    EXPECT_FALSE(second.startShown());
    EXPECT_EQ(second.document().state().bodies.size(), 1U);
    second.files().setQuestion([] { return FileActions::Answer::Discard; });
}

TEST_F(Start, SeveralFilesHaveWindowsOfTheirOwn) {
    saveCube("a.edgewright");
    ASSERT_TRUE(window_->files().saveTo(path("b.edgewright")));
    WindowList windows(document().state().library, *appearance_,
                       {.remember = false, .recentList = recentList_});
    MainWindow& first = *windows.make();
    first.show();
    const QString url = QUrl::fromLocalFile(path("b.edgewright")).toString();
    EXPECT_TRUE(windows.open({path("a.edgewright"), url}, first));
    ASSERT_EQ(windows.windows().size(), 2);
    EXPECT_EQ(windows.windows()[0]->document().filePath(), path("a.edgewright"));
    EXPECT_EQ(windows.windows()[1]->document().filePath(), path("b.edgewright"));
    // What is open already comes to the front.
    EXPECT_TRUE(windows.open({path("a.edgewright")}, *windows.windows()[1]));
    EXPECT_EQ(windows.windows().size(), 2);
    // Several that are dropped, too.
    EXPECT_FALSE(windows.open({path("none.edgewright"), "https://example.org/x"}, first));
}

TEST_F(Start, FilesAreDroppedOntoTheWindow) {
    saveCube("a.edgewright");
    window_->files().newDocument();
    const auto drop = [&](const QList<QUrl>& urls) {
        QMimeData data;
        data.setUrls(urls);
        QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window_.get(), &enter);
        if (!enter.isAccepted()) return;
        QDropEvent event({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(window_.get(), &event);
    };
    QStringList wanted;
    QObject::connect(window_.get(), &MainWindow::windowsWanted, window_.get(),
                     [&](const QStringList& paths) { wanted = paths; });
    const QUrl a = QUrl::fromLocalFile(path("a.edgewright"));
    drop({QUrl("https://example.org/a.edgewright")});
    EXPECT_TRUE(document().filePath().isEmpty());
    drop({a, QUrl::fromLocalFile(path("b.edgewright"))});
    EXPECT_EQ(wanted.size(), 2);
    EXPECT_TRUE(document().filePath().isEmpty());
    showStart();
    drop({a});
    EXPECT_EQ(document().filePath(), path("a.edgewright"));
    EXPECT_FALSE(window_->startShown());
}

}  // namespace
}  // namespace ew::test
